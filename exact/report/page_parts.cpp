#include "exact/report/page_parts.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>

#include "exact/classes/class_table.h"
#include "exact/methods/methods.h"
#include "exact/record/five_signs.h"
#include "exact/report/html.h"

namespace tribunal {
namespace {

std::string shortest(double x) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string verb(bool hit) { return hit ? "a hit" : "no hit"; }

std::string answer(bool hit, bool right) {
  return "<span class=\"answer " + std::string(right ? "good" : "bad") + "\">" + verb(hit) + "</span>";
}

std::string triple(const std::string& x, const std::string& y, const std::string& z) { return x + ", " + y + ", " + z; }

std::string point_row(const char* name, const Point3& p) {
  const std::string decimal = triple(shortest(p.x), shortest(p.y), shortest(p.z));
  const std::string hex = triple(hex_float(p.x), hex_float(p.y), hex_float(p.z));
  return element("tr", element("td", std::string("<b>") + name + "</b>") +
                           element("td", decimal + "<br><code>" + hex + "</code>"));
}

/// A side of a plane or a line: what each sign of it means.
struct SignRow {
  const char* key;
  const char* determinant;
  const char* negative;
  const char* zero;
  const char* positive;
};

constexpr SignRow sign_rows[] = {
    {"abcp", "orient(a, b, c, p)", "p lies below the plane of the triangle", "p lies exactly in the plane",
     "p lies above the plane of the triangle"},
    {"abcq", "orient(a, b, c, q)", "q lies below it", "q lies exactly in it", "q lies above it"},
    {"pqab", "orient(p, q, a, b)", "the line pq passes edge ab on one side", "the line pq meets the line ab exactly",
     "the line pq passes edge ab on the other side"},
    {"pqbc", "orient(p, q, b, c)", "it passes edge bc on one side", "it meets the line bc exactly",
     "it passes edge bc on the other side"},
    {"pqca", "orient(p, q, c, a)", "it passes edge ca on one side", "it meets the line ca exactly",
     "it passes edge ca on the other side"}};

/// The five signs as rounded arithmetic has them, in the order of the table.
std::array<int, 5> rounded_signs(const Case& c) {
  std::array<int, 5> signs;
  std::ranges::transform(five_signs(c.query, FormulaKernel<double>{}), signs.begin(), [](Sign s) { return value(s); });
  return signs;
}

std::array<int, 5> exact_signs(const Case& c) {
  std::array<int, 5> signs;
  for (std::size_t i = 0; i < 5; ++i) signs[i] = c.finding.at("exact").at(sign_rows[i].key);
  return signs;
}

const char* mark(int sign) { return sign < 0 ? "&minus;" : sign > 0 ? "+" : "0"; }

std::string sign_row(const SignRow& row, int exact, int rounded) {
  const char* const meaning = exact < 0 ? row.negative : exact > 0 ? row.positive : row.zero;
  const std::string colour = exact == rounded ? "" : " class=\"answer bad\"";
  return element("tr", element("td", std::string("<code>") + row.determinant + "</code>") +
                           element("td", std::string("<b>") + mark(exact) + "</b>", "class=\"number\"") +
                           element("td", "<b" + colour + ">" + mark(rounded) + "</b>", "class=\"number\"") +
                           element("td", meaning));
}

const Json* drawn_row(const Json& chart, const std::string& population, const std::string& method) {
  for (const Json& row : chart.at("rows")) {
    if (row.at("own_format") == true && row.at("population") == population && row.at("method") == method) return &row;
  }
  return nullptr;
}

/// Double precision without a filter: the naive method that costs are compared with.
std::string plain_double() {
  for (const Method& m : methods_with(Role::calibration)) {
    if (m.contract.format == Format::binary64) return m.name;
  }
  return {};
}

std::string cost_on(const Json& chart, const std::string& population, const std::string& where) {
  const Json* const floating = drawn_row(chart, population, plain_double());
  const Json* const certified = drawn_row(chart, population, flagship_method().name);
  if (floating == nullptr || certified == nullptr) return {};
  const auto median = [](const Json& row) { return row.at("nanoseconds").at("median").get<double>(); };
  char text[60];
  std::snprintf(text, sizeof text, "%.1f", median(*certified) / median(*floating));
  return std::string(text) + " times as long " + where;
}

}  // namespace

std::string answers_in_words(const Case& c) {
  const bool expected = c.finding.at("expected") == 1, answered = c.finding.at("answered") == 1;
  const ClassRow& row = class_row(c.class_id);
  std::string text = "The exact answer is " + answer(expected, true);
  text += row.hit() ? ": they meet in a " + escape(row.intersection) : ": they have no point in common";
  return text + " (class " + class_name(c.class_id) + " of 163). <code>" +
         escape(c.finding.at("method").get<std::string>()) + "</code> says " + answer(answered, false) + ".";
}

std::string coordinates_table(const Case& c) {
  const Segment& s = std::get<Segment>(c.query.probe);
  const Triangle& t = c.query.triangle();
  const std::string rows =
      point_row("p", s.p) + point_row("q", s.q) + point_row("a", t.a) + point_row("b", t.b) + point_row("c", t.c);
  return element("div", element("table", rows), "class=\"wide\"");
}

std::string rule_in_words(const Case& c) {
  const std::array<int, 5> exact = exact_signs(c), rounded = rounded_signs(c);
  int wrong = 0;
  for (std::size_t i = 0; i < 5; ++i) wrong += exact[i] != rounded[i];
  return "The test looks at five signs. It is a miss if p and q lie strictly on one side of the triangle's plane, or "
         "if "
         "one of the last three signs equals the side on which p lies (where p is in the plane: is opposite to the "
         "side "
         "of q); otherwise it is a hit. Double precision gets " +
         std::to_string(wrong) + " of the five wrong here:";
}

std::string signs_table(const Case& c) {
  const std::array<int, 5> exact = exact_signs(c), rounded = rounded_signs(c);
  std::string rows = "<tr><th>determinant</th><th>exact</th><th>double</th><th>what the exact sign says</th></tr>\n";
  for (std::size_t i = 0; i < 5; ++i) rows += sign_row(sign_rows[i], exact[i], rounded[i]);
  return element("table", rows);
}

std::string cost_in_words(const Json& chart) {
  const std::string random = cost_on(chart, "general", "on random points");
  const std::string degenerate = cost_on(chart, "degenerate", "on exactly degenerate ones");
  if (random.empty() || degenerate.empty()) return {};
  return "In this run the exact test with a filter, <code>" + escape(flagship_method().name) + "</code>, took " +
         random + " as <code>" + escape(plain_double()) + "</code>, " + degenerate + ".";
}

}  // namespace tribunal
