#include "exact/report/page.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>

#include "exact/cases/family_table.h"
#include "exact/certificate/bounds.h"
#include "exact/methods/methods.h"
#include "exact/report/html.h"
#include "exact/report/page_parts.h"
#include "exact/report/page_style.h"
#include "exact/report/sketch.h"

namespace tribunal {
namespace {

std::string paragraph(const std::string& html) { return element("p", html); }

std::string code(const std::string& text) { return "<code>" + escape(text) + "</code>"; }

std::string item(const std::string& html) { return element("li", html); }

std::string section(const std::string& title, const std::string& html) {
  return element("section", element("h2", escape(title)) + html);
}

// --- the verdicts ------------------------------------------------------------------------------------------------

std::string sampled_line(const SampleFigures& c) {
  const std::string of =
      " of " + grouped(c.sampled) + " hard " + escape(c.fmt) + " cases, drawn at random by the families below";
  if (c.wrong > 0) {
    const double share = static_cast<double>(c.wrong) / static_cast<double>(c.sampled);
    return "<b>" + grouped(c.wrong) + " wrong</b>" + of + " (" + percent(share) + ")";
  }
  return "<b>0 wrong</b>" + of + ": with 95 % confidence at most " +
         percent(upper_bound(0, c.sampled, confidence_alpha)) + " of what these generators make";
}

std::string evidence_line(const CertificateFigures& c) {
  return c.refuted() ? grouped(c.counterexamples) + " of the wrong answers shrunk to short coordinates, each to replay"
                     : "No counterexample found. That is not a proof beyond the sets run whole";
}

std::string card(const CertificateFigures& c, const std::string& directory, const std::string& what) {
  std::string list = item(escape(c.worst));
  for (const SampleFigures& sample : c.samples) list += item(sampled_line(sample));
  for (const WholeSet& set : c.whole) {
    list += item("<b>" + grouped(set.wrong) + " wrong</b> of the " + grouped(set.size) +
                 " in a set run whole: " + escape(set.name));
  }
  list += item(evidence_line(c));
  const std::string body = element("h3", code(c.method)) + element("div", escape(c.verdict), "class=\"verdict\"") +
                           paragraph(what) + element("ul", list) +
                           paragraph("<a href=\"" + directory + "/certificate.md\">the certificate</a>");
  return element("div", body, c.refuted() ? "class=\"card bad\"" : "class=\"card good\"");
}

std::string verdicts(const Tour& tour) {
  return section(
      "The verdicts",
      paragraph("One test, written once, in two kinds of arithmetic: the segment-triangle test of Segura and Feito, "
                "which decides by the signs of five determinants. Its sums and products are rounded in one and exact "
                "in the other. Both were asked the same questions, whose right answers are known exactly.") +
          element("div",
                  card(tour.floating, certificate_directory(tour.floating.method),
                       "Double precision, as most programs compute.") +
                      card(tour.exact, certificate_directory(tour.exact.method),
                           "Rational numbers: slower, and nothing is rounded."),
                  "class=\"cards\""));
}

// --- one counterexample ------------------------------------------------------------------------------------------

std::string one_counterexample(const Tour& tour) {
  const Case& c = tour.counterexample;
  const Segment& s = std::get<Segment>(c.query.probe);
  const std::string left = element(
      "figure",
      sketch(s, c.query.triangle()) +
          element("figcaption",
                  "Triangle abc and segment pq, seen at a slant. A drawing is rounded: what seems to touch may not."));
  const std::string command = "tribunal replay " + tour.directory + "/" + demo_files::counterexample;
  return section("One wrong answer, whole",
                 paragraph("The plainest counterexample that this run found and shrunk. " + answers_in_words(c)) +
                     element("div", left + element("div", coordinates_table(c)), "class=\"pair\"") +
                     paragraph(rule_in_words(c)) + element("div", signs_table(c), "class=\"wide\"") +
                     paragraph("This command shows it again, with what every method answers:") +
                     element("pre", "$ " + escape(command) + "\n" + escape(tour.replay)));
}

// --- all methods -------------------------------------------------------------------------------------------------

std::string fuzz_row(const FuzzFigures& f) {
  const double share = f.judged > 0 ? static_cast<double>(f.wrong) / static_cast<double>(f.judged) : 0;
  char bar[80];
  std::snprintf(bar, sizeof bar, "style=\"width:%.2f%%\"", std::min(100.0, 400 * share));
  return element("tr", element("td", code(f.method)) + element("td", escape(f.fmt)) +
                           element("td", grouped(f.judged), "class=\"number\"") +
                           element("td", grouped(f.wrong), "class=\"number\"") +
                           element("td", percent(share), "class=\"number\"") +
                           element("td", f.wrong > 0 ? element("div", "", bar) : "", "class=\"share\""));
}

std::string families() {
  std::string list;
  for (const Family& f : families_of(Operands::triangles)) {
    list += item("<b>" + escape(f.name) + "</b>: " + escape(f.stresses));
  }
  return list;
}

/// The methods that read coplanar contacts differently from the others, in words.
std::string transversal_in_words(const Tour& tour) {
  std::string names;
  std::string_view before;
  for (const FuzzFigures& f : tour.fuzz) {
    const Method* const m = find_method(f.method);
    if (std::exchange(before, f.method) == f.method) continue;
    if (m == nullptr || m->contract.convention != Convention::transversal) continue;
    names += (names.empty() ? "" : ", ") + code(f.method) + " (" + escape(m->card.reference) + ")";
  }
  if (names.empty()) return "";
  return "To some of them a segment in the triangle's plane is a miss, and they are judged by that convention: " +
         names + ".";
}

std::string fuzzing(const Tour& tour) {
  std::string rows = "<tr><th>method</th><th>cases</th><th>judged</th><th>wrong</th><th>share</th><th></th></tr>\n";
  for (const FuzzFigures& f : tour.fuzz) rows += fuzz_row(f);
  return section(
      "Several methods, the same hunt",
      paragraph(
          "Fuzzing makes cases on purpose where they are hard. Binary32 methods are judged only on "
          "coordinates that binary32 holds; cases of the two formats are no one population, and have a row each. " +
          transversal_in_words(tour)) +
          element("div", element("table", rows), "class=\"wide\"") +
          paragraph("The cases come from these families, in equal parts:") +
          element("ul", families(), "class=\"families\"") +
          paragraph("Such cases are not random ones. On random points double precision is nearly always "
                    "right, as the charts below show; in meshes, where rays run along edges and through "
                    "vertices, they are everyday."));
}

// --- the pictures ------------------------------------------------------------------------------------------------

std::string picture(const std::string& file, const std::string& caption) {
  return element("figure",
                 "<img src=\"" + escape(file) + "\" alt=\"" + caption + "\">" + element("figcaption", caption));
}

/// A window of a picture, enlarged by the style sheet alone; lengths are in percent of the window.
std::string crop(const std::string& file, const PictureFigures& f, const Place& corner, const std::string& caption) {
  constexpr int width = 40, height = 30;
  char style[160];
  std::snprintf(style, sizeof style, "style=\"width:%.4f%%;left:%.4f%%;top:%.4f%%\"", 100.0 * f.width / width,
                -100.0 * corner.column / width, -100.0 * corner.row / height);
  return element("figure", element("div", "<img src=\"" + escape(file) + "\" alt=\"" + caption + "\" " + style + ">",
                                   "class=\"crop\"") +
                               element("figcaption", caption));
}

std::string crops(const PictureFigures& f) {
  const Place corner = busiest_window(f, 40, 30);
  return paragraph("The 40 &times; 30 pixels where they differ most:") +
         element("div",
                 crop(exact_picture(f.method), f, corner, "exact") + crop(own_picture(f.method), f, corner, f.method) +
                     crop(difference_picture(f.method), f, corner, "the difference"),
                 "class=\"pictures\"");
}

std::string remark(const PictureFigures& f) {
  if (f.pixels == 0) {
    return "That clears this picture and not the method: its rays met none of the cases in which it is wrong.";
  }
  std::string text = "On " + grouped(f.pixels) + " pixels some decision differs; " + grouped(f.other_colour) +
                     " of these show it in their colour.";
  if (f.fmt == "binary32") {
    text += " The scene was rounded to binary32 for both beforehand, so none of this comes from the rounding of input.";
  }
  return text;
}

std::string comparison(const PictureFigures& f, const std::string& exact) {
  const std::string all = grouped(static_cast<std::uint64_t>(f.width) * static_cast<std::uint64_t>(f.height));
  const std::string title =
      f.pixels == 0 ? "no pixel differs" : grouped(f.other_colour) + " of " + all + " pixels have another colour";
  return element("h3", code(f.method) + " against exact arithmetic: " + title) + paragraph(remark(f)) +
         element("div",
                 picture(exact_picture(f.method), "exact (" + escape(exact) + ")") +
                     picture(own_picture(f.method), escape(f.method)) +
                     picture(difference_picture(f.method), "magenta: another colour, yellow: another decision only"),
                 "class=\"pictures\"") +
         (f.places.empty() ? "" : crops(f));
}

std::string pictures(const Tour& tour) {
  std::string html = paragraph(
      "The same tests drive a ray tracer: a mesh from CGAL's collection under a very long lens, where large distances "
      "meet small triangles. Every pixel that differs is written as a case, and " +
      code("tribunal replay") + " explains it.");
  for (const PictureFigures& f : tour.pictures) html += comparison(f, tour.exact.method);
  return section("What it does to a picture", html);
}

// --- the charts --------------------------------------------------------------------------------------------------

std::string chart(const std::string& name, const std::string& caption) {
  const std::string path = std::string(demo_files::charts) + "/" + name;
  return element("figure",
                 "<a href=\"" + path + ".svg\"><img src=\"" + path + ".svg\" alt=\"" + name + "\"></a>" +
                     element("figcaption", caption),
                 "class=\"chart\"");
}

std::string charts(const Tour& tour) {
  return section("Speed against accuracy",
                 chart("speed-accuracy",
                       "Each mark is a method: to the left is faster, down is right more often, and all were given the "
                       "same cases, those of either format by themselves. Methods that were never wrong stand in a "
                       "band of their own below the axis. " +
                           cost_in_words(tour.chart)) +
                     chart("speed",
                           "What a test costs its own users, in a loop that was compiled around it, by the share of "
                           "hits. A test that prepares triangles is shown as it comes, which includes preparing one, "
                           "and prepared; the time to prepare is beside it.") +
                     paragraph("The numbers: <a href=\"charts/chart.json\">chart.json</a>; the script that draws them: "
                               "<a href=\"charts/plot.py\">plot.py</a>."));
}

// --- limits, and further -----------------------------------------------------------------------------------------

std::string limits(const Tour& tour) {
  std::string list = item(
      "<b>Proved</b> is only what was run whole: small integer coordinates. The rest is sampled, and "
      "its bounds speak of the cases that these generators make, not of your data.");
  for (const auto& [reason, strata] : tour.exact.gaps) {
    list += item(grouped(strata) + " pairs of a family and a class have no case: " + escape(reason) + ".");
  }
  list += item(
      "The certificates speak of segments and triangles. Rays are tried here by the pictures only; polygons "
      "with more corners not at all.");
  list += item(
      "Coordinates are taken as the exact numbers that they are. What was rounded before, in your file or "
      "your modeller, is no part of the trial.");
  list += item("Times are those of this machine under this run's load; compare ratios.");
  return section("What this does not say", element("ul", list));
}

std::string further(const Tour& tour) {
  std::string commands;
  for (const std::string& command : tour.commands) commands += "$ " + escape(command) + "\n";
  const std::string both = escape(tour.exact.method + "," + tour.floating.method), own = escape(tour.floating.method);
  return section(
      "Go on", paragraph("This page was made by these commands; each can be run alone, and with the same seed gives "
                         "the same answers. " +
                         code("tribunal") + " is " + code("build/release/tribunal") + ".") +
                   element("pre", commands) +
                   paragraph("Your own data: put segments and triangles in a case file, one JSON object a line, and "
                             "ask any method, or put a method on trial with your cases among the rest:") +
                   element("pre", "$ tribunal methods\n$ tribunal classify --method " + both + " --in cases.jsonl\n" +
                                      "$ tribunal certify --method " + own + " --cases cases.jsonl --out certificate-" +
                                      own + "\n") +
                   paragraph(code("tribunal COMMAND --help") + " says more."));
}

std::string head() {
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\">\n<title>Tribunal: the tour</title>\n<style>" +
         std::string(page_style) + "</style>\n</head>\n";
}

std::string masthead() {
  return element(
      "header", element("div", element("h1", "Does this segment hit that triangle?") +
                                   paragraph("Ray tracers, collision detection, CAD and GIS ask it millions of times a "
                                             "second, in floating point, and sometimes get the wrong answer: a ray "
                                             "slips through a closed surface, two solids overlap unnoticed.") +
                                   paragraph("Tribunal puts such tests on trial against exact arithmetic. This page "
                                             "shows one run: which test may be trusted, where the other fails, and "
                                             "what being right costs.")));
}

std::string footer(const Tour& tour) {
  std::string list;
  for (const auto& entry : tour.chart.at("environment").items()) {
    list += element("dt", escape(entry.key())) + element("dd", escape(entry.value().get<std::string>()));
  }
  char seconds[40];
  std::snprintf(seconds, sizeof seconds, "%.0f s", tour.seconds);
  list += element("dt", "this run") + element("dd", seconds);
  return element("footer", element("div", element("dl", list)));
}

}  // namespace

std::string certificate_directory(const std::string& method) { return "certificate-" + method; }

std::string exact_picture(const std::string& method) { return "render/exact-" + method + ".png"; }

std::string own_picture(const std::string& method) { return "render/" + method + ".png"; }

std::string difference_picture(const std::string& method) { return "render/exact-" + method + ".diff.png"; }

Place busiest_window(const PictureFigures& f, int width, int height) {
  const auto corner_for = [&](const Place& centre) {
    return Place{std::clamp(centre.column - width / 2, 0, std::max(0, f.width - width)),
                 std::clamp(centre.row - height / 2, 0, std::max(0, f.height - height))};
  };
  const auto inside = [&](const Place& corner) {
    return std::ranges::count_if(f.places, [&](const Place& p) {
      return p.column >= corner.column && p.column < corner.column + width && p.row >= corner.row &&
             p.row < corner.row + height;
    });
  };
  Place best{};
  for (const Place& centre : f.places) {
    if (inside(corner_for(centre)) > inside(best)) best = corner_for(centre);
  }
  return best;
}

std::string page(const Tour& tour) {
  const std::string body = verdicts(tour) + one_counterexample(tour) + fuzzing(tour) + pictures(tour) + charts(tour) +
                           limits(tour) + further(tour);
  return head() + element("body", masthead() + element("main", body) + footer(tour)) + "</html>\n";
}

}  // namespace tribunal
