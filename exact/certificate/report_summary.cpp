// Writes a certificate's summary for the terminal.
#include "exact/base/shown.h"
#include "exact/cases/families/aimed.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "exact/certificate/report_parts.h"

namespace tribunal {
namespace {

std::string worst_line(const Certificate& c) {
  std::string text;
  for (const Stratum& s : worst_of(c, 5, [](const Stratum&) { return true; })) {
    text += (text.empty() ? "  most in  " : ", ") + slot_name(s.slot) + " " + c.streams[s.stream].family + " " +
            std::string(name_of(c.streams[s.stream].format)) + " " + std::to_string(s.count.wrong) + "/" +
            std::to_string(s.count.judged());
  }
  return text.empty() ? "" : text + "\n";
}

std::string sampled_line(const Certificate& c, bool rays, Format format) {
  const Count sampled = c.sampled(rays, format);
  if (sampled.asked == 0) return "";
  return std::string("  sampled  ") + (rays ? "rays, " : "segments, ") + std::string(name_of(format)) + ": " +
         with_breakdown(sampled) + "; 95 % upper bound " +
         percent(upper_bound(sampled.wrong, sampled.judged(), confidence_alpha)) + " on these populations\n";
}

/// Counts of the user's own mesh, which are part of those above. People take them for leaks.
std::string mesh_lines(const Certificate& c) {
  std::string text;
  for (std::size_t i = 0; i < c.streams.size(); ++i) {
    if (c.streams[i].family != mesh_family) continue;
    text += "  mesh     " + std::string(name_of(c.streams[i].format)) + ": " + wrong_of(total_of(c, i)) +
            ", each about one triangle of your mesh: no leak rate, which `tribunal leak` measures\n";
  }
  return text;
}

/// A contract that culls says nothing of pierced polygons, whose front is not defined by their vertices.
std::string unjudged_polygons_line(const Certificate& c) {
  if (c.contract.culling == Culling::none) return "";
  Count own;
  for (const Stratum& s : c.strata) {
    if (c.is_own(s) && operands_of(s.slot) == Operands::polygons) own += s.count;
  }
  if (own.not_owed() == 0) return "";
  return "  own      " + std::to_string(own.not_owed()) + " of " + std::to_string(own.asked) +
         " polygons are not judged: a test that culls owes no answer about those that are pierced\n";
}

std::string summary_of(const Certificate& c) {
  std::string text = c.method() + ": " + name_of(c.verdict) + "; " + c.worst() + "\n";
  for (const ProvedSet& s : c.proved) {
    text += (s.count.wrong == 0 ? "  proved   " : "  refuted  ") + s.name + ": " + std::to_string(s.count.wrong) +
            " wrong of " + std::to_string(s.count.judged()) + ", " + std::to_string(s.classes) + " " + classes_word(c) +
            after_semicolon(breakdown(s.count)) + "\n";
  }
  for (const bool rays : {false, true}) {
    for (const Format format : both_formats) text += sampled_line(c, rays, format);
  }
  text += mesh_lines(c);
  for (const Format format : both_formats) {
    const Count own = c.own(format);
    if (own.asked > 0) text += "  own      " + std::string(name_of(format)) + ": " + with_breakdown(own) + "\n";
  }
  for (const NonfiniteRow& row : c.nonfinite) text += "  not finite, " + in_words(row) + "\n";
  text += unjudged_polygons_line(c);
  text += relation_lines(c) + errors_lines(c) + fault_lines(c, "  FAULT    ") + worst_line(c);
  text += (c.coverage.has(Operands::polygons) ? "  judged   " : "  classes  ") + coverage_text(c) + "\n";
  for (const Gap& g : c.gaps) {
    if (!g.explained) text += "  HOLE     " + g.what + ": " + g.reason + "\n";
  }
  return text;
}

}  // namespace

std::string to_summary(const Certificate& c) { return summary_of(with_texts(c, shown)); }

}  // namespace tribunal
