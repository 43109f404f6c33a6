#include "exact/report/case_book.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "exact/base/files.h"
#include "exact/base/record.h"
#include "exact/record/counterexample.h"
#include "exact/report/case_view.h"
#include "exact/report/shapes.h"

namespace tribunal {
namespace {

std::string family_of(const Json& finding) {
  return finding.is_object() && finding.contains("origin") ? text_in(finding["origin"], "family") : "";
}

/// What a group has in common.
auto group_of(const FoundCase& f) {
  const Json& finding = f.c.finding;
  return std::tuple(f.run, text_in(finding, "method"), text_in(finding, "outcome"), text_in(finding, "severity"),
                    family_of(finding), f.c.class_id, f.c.format);
}

}  // namespace

std::string text_in(const Json& object, const char* key) {
  const Record record(object, {});
  const bool has_text = object.is_object() && object.contains(key) && object[key].is_string();
  return has_text ? record.text(key) : "";
}

std::vector<std::size_t> worst_and_most_diverse(const std::vector<FoundCase>& found, std::size_t most) {
  std::vector<std::size_t> order(found.size()), place(found.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto by_rank = [&](std::size_t i) { return found[i].rank; };
  std::ranges::stable_sort(order, {}, by_rank);
  std::map<decltype(group_of(FoundCase{})), std::size_t> sizes;
  for (const std::size_t i : order) place[i] = sizes[group_of(found[i])]++;
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return place[i]; });
  if (order.size() > most) order.resize(most);
  std::ranges::sort(order);
  std::ranges::stable_sort(order, {}, by_rank);
  return order;
}

void CaseBook::read(std::size_t run, const std::string& file) {
  for_each_line_in(read_file(file), file, [&](const Json& object, const Where& where) {
    FoundCase found{run, file, where.line, to_case(object, where), {}};
    if (!found.c.finding.is_null()) require_finding({found.c.finding, where.key("finding")});
    found.rank = rank_of(found.c, where.key("finding"));
    Json short_form = object;
    if (short_form.contains("finding")) short_form.erase("finding");
    if (short_form.dump().size() > longest_line || !is_finite(found.c.query)) {
      ++not_shown_[run];
      return;
    }
    found_.push_back(std::move(found));
  });
}

void CaseBook::choose(std::size_t most) {
  chosen_ = worst_and_most_diverse(found_, most);
  for (std::size_t number = 0; number < chosen_.size(); ++number) {
    const FoundCase& f = found_[chosen_[number]];
    numbers_.emplace(std::pair(f.run, f.c.id), number);
    note_answers(f.c);
  }
}

void CaseBook::note_answers(const Case& c) {
  if (!c.finding.is_object() || !c.finding.contains("answers") || !c.finding["answers"].is_object()) return;
  for (const auto& [name, answer] : c.finding["answers"].items()) {
    if (std::ranges::find(answer_methods_, name) == answer_methods_.end()) answer_methods_.push_back(name);
  }
}

std::optional<std::size_t> CaseBook::number_of(std::size_t run, const std::string& id) const {
  const auto at = numbers_.find({run, id});
  return at == numbers_.end() ? std::nullopt : std::optional(at->second);
}

std::vector<std::size_t> CaseBook::numbers_of(std::size_t run) const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < chosen_.size(); ++i) {
    if (found_[chosen_[i]].run == run) numbers.push_back(i);
  }
  return numbers;
}

std::size_t CaseBook::found_in(std::size_t run) const {
  const auto of_run = [&](const FoundCase& f) { return f.run == run; };
  const auto others = not_shown_.find(run);
  return static_cast<std::size_t>(std::ranges::count_if(found_, of_run)) +
         (others == not_shown_.end() ? 0 : others->second);
}

Json CaseBook::shown() const {
  Json all = Json::array();
  for (const std::size_t i : chosen_) all.push_back(case_view(found_[i], answer_methods_));
  return all;
}

}  // namespace tribunal
