#include "exact/report/case_view.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "exact/classes/class_table.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/record/five_signs.h"
#include "exact/trial/describe.h"
#include "exact/trial/truth.h"

namespace tribunal {
namespace {

bool is_harmless(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("_-./,=:+").find(c) != std::string::npos;
}

std::string replay_command(const FoundCase& found) {
  return "sed -n " + std::to_string(found.line) + "p " + shell_word(found.file) + " | tribunal replay -";
}

/// 1 a hit, 0 a miss, and a dash where the method does not take the case or said nothing.
std::string letters(const Json& finding, const std::vector<std::string>& methods) {
  if (!finding.contains("answers")) return "";
  const Json& answers = finding["answers"];
  std::string text;
  for (const std::string& m : methods) {
    text += !answers.contains(m) || answers[m].is_null() ? '-' : answers[m] == 1 ? '1' : '0';
  }
  return text;
}

template <class K>
Json signs_by(const K& kernel, const Query& query) {
  Json signs = Json::array();
  for (const Sign s : five_signs(query, kernel)) signs.push_back(value(s));
  return signs;
}

Json signs_of(const Case& c) {
  if (c.query.operands() == Operands::polygons) return {};
  return {{"exact", signs_by(RationalKernel{}, c.query)},
          {"binary64", signs_by(FormulaKernel<double>{}, c.query)},
          {"binary32", c.format == Format::binary32 ? signs_by(FormulaKernel<float>{}, c.query) : Json()}};
}

Json or_null(std::string_view name) { return name.empty() ? Json() : Json(name); }

Json truth_json(const Truth& truth) {
  return {{"hit", truth.hit() ? 1 : 0},
          {"contact", name_of(truth.contact)},
          {"at", or_null(name_of(truth.at))},
          {"side", or_null(name_of(truth.facing))},
          {"planar", truth.operands() == Operands::polygons ? Json(truth.planar) : Json()},
          {"words", describe(truth)}};
}

/// What the finding says that its shape knows (shapes.h), without what stands elsewhere.
void add_finding(Json& view, const Json& finding) {
  for (const char* key :
       {"method", "outcome", "severity", "cause", "naive_right", "in_words", "contact", "contact_told", "side",
        "side_told", "planar_told", "answered", "expected", "convention", "readings", "fault", "detail"}) {
    if (finding.contains(key)) view[key] = finding[key];
  }
}

}  // namespace

std::string shell_word(const std::string& text) {
  if (!text.empty() && text[0] != '-' && std::ranges::all_of(text, is_harmless)) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

Json case_view(const FoundCase& found, const std::vector<std::string>& answer_methods) {
  Case bare = found.c;
  const Json finding = bare.finding.is_object() ? bare.finding : Json::object();
  bare.finding = Json();
  const Truth truth = exact_truth(bare.query);
  const Json origin = finding.contains("origin") ? finding["origin"] : Json();
  Json view = Json::object();
  add_finding(view, finding);
  view.update({{"case", from_case(bare)},
               {"run", found.run},
               {"file", found.file},
               {"line", found.line},
               {"replay", replay_command(found)},
               {"origin", origin},
               {"family", origin.is_object() && origin.contains("family") ? origin["family"] : Json()},
               {"class", truth.class_id == 0 ? Json() : Json(class_name(truth.class_id))},
               {"truth", truth_json(truth)},
               {"signs", signs_of(bare)},
               {"answers", letters(finding, answer_methods)}});
  return view;
}

}  // namespace tribunal
