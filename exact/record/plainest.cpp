#include "exact/record/plainest.h"

#include "exact/base/json.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/record/five_signs.h"
#include "exact/trial/describe.h"

namespace tribunal {
namespace {

template <class K>
std::string row(const char* name, const K& k, const Query& query) {
  std::string text = std::string("    ") + name;
  text.resize(24, ' ');
  for (const Sign s : five_signs(query, k))
    text += s == Sign::positive ? "    +" : s == Sign::negative ? "    -" : "    0";
  return text + "\n";
}

std::string signs_table(const Query& query, Format format) {
  std::string text = "    signs of volumes    ";
  for (const char* v : five_sign_names) text += " " + std::string(v);
  text += "\n" + row("exact", RationalKernel{}, query);
  return text + (format == Format::binary32 ? row("in binary32", FormulaKernel<float>{}, query)
                                            : row("in binary64", FormulaKernel<double>{}, query));
}

std::string hit_or_not(const Json& finding, const char* key) {
  return !finding.contains(key) ? "nothing (a fault)" : finding[key] == 1 ? "a hit" : "no hit";
}

}  // namespace

std::string counterexample_in_words(const Method& method, const Case& c) {
  std::string text = points_of(c.query) + "    exact answer " + describe(exact_truth(c.query)) + "\n";
  if (c.query.operands() == Operands::triangles) text += signs_table(c.query, method.contract.format);
  return text + "    " + method.name + " answers " + hit_or_not(c.finding, "answered") + "; due is " +
         hit_or_not(c.finding, "expected") + "\n";
}

}  // namespace tribunal
