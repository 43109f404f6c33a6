#include "exact/record/plainest.h"

#include <array>

#include "core/kernel.h"
#include "exact/base/json.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/trial/describe.h"

namespace tribunal {
namespace {

constexpr std::array<const char*, 5> volumes = {"abcp", "abcq", "pqab", "pqbc", "pqca"};

template <class K, class P>
std::array<Sign, 5> signs_of(const K& k, const P& probe, const Triangle& t) {
  const Point3& p = source(probe);
  const auto& q = target(probe);
  return {k.orient3d(t.a, t.b, t.c, p), k.orient3d(t.a, t.b, t.c, q), k.orient3d(p, t.a, t.b, q),
          k.orient3d(p, t.b, t.c, q), k.orient3d(p, t.c, t.a, q)};
}

template <class K>
std::string row(const char* name, const K& k, const Query& query) {
  const auto signs = std::visit([&](const auto& probe) { return signs_of(k, probe, query.triangle()); }, query.probe);
  std::string text = std::string("    ") + name;
  text.resize(24, ' ');
  for (const Sign s : signs) text += s == Sign::positive ? "    +" : s == Sign::negative ? "    -" : "    0";
  return text + "\n";
}

std::string signs_table(const Query& query, Format format) {
  std::string text = "    signs of volumes    ";
  for (const char* v : volumes) text += " " + std::string(v);
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
