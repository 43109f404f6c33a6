// What a certificate says of the errors of numbers.
#include "exact/certificate/report_parts.h"

namespace tribunal {
namespace {

std::string errors_row(const ErrorRow& e, const char* what, const Ulps& u) {
  if (u.all() == 0) return "";
  return "| " + e.family + " | " + std::string(name_of(e.format)) + " | " + what + " | " +
         std::to_string(e.errors.hits) + " | " + in_words(u) + " |\n";
}

/// The errors of one number in all families of a format, and where the largest is.
std::string errors_line(const Certificate& c, Format format, const char* what, Ulps HitErrors::*number) {
  Ulps total;
  std::string worst;
  for (const ErrorRow& e : c.errors) {
    if (e.format != format) continue;
    const Ulps& u = e.errors.*number;
    if (u.most > total.most) worst = "; the most in " + e.family;
    total += u;
  }
  return total.all() == 0 ? ""
                          : "  ulps     " + std::string(what) + ", " + std::string(name_of(format)) + ": " +
                                in_words(total) + worst + "\n";
}

}  // namespace

std::string errors_section(const Certificate& c) {
  std::string text =
      "## Errors of t and of the weights\n\nOf right hits of rays at one point, against the exact value, in units in "
      "the last place of it in " +
      std::string(name_of(c.contract.format)) +
      ". How ill-conditioned the problem is, is not divided out. Of the sampled cases one in " +
      std::to_string(measured_period) +
      ", drawn by a hash.\n\n| family | cases | number | hits | errors |\n|---|---|---|---|---|\n";
  for (const ErrorRow& e : c.errors) {
    text += errors_row(e, "t", e.errors.t) + errors_row(e, "weights", e.errors.weights);
  }
  return text + "\n";
}

std::string errors_lines(const Certificate& c) {
  std::string text;
  for (const Format format : both_formats) {
    text += errors_line(c, format, "t", &HitErrors::t) + errors_line(c, format, "weights", &HitErrors::weights);
  }
  return text;
}

}  // namespace tribunal
