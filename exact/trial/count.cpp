#include "exact/trial/count.h"

#include <algorithm>
#include <functional>

namespace tribunal {
namespace {

using Number = std::function<std::uint64_t(const Count&)>;

template <std::size_t n>
void add_each(std::array<std::uint64_t, n>& to, const std::array<std::uint64_t, n>& from) {
  for (std::size_t i = 0; i < n; ++i) to[i] += from[i];
}

/// "3 plain", or nothing for 0, after a comma.
void list(std::string& text, std::uint64_t n, const std::string& one, const std::string& many) {
  if (n == 0) return;
  text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + (n == 1 ? one : many);
}

void list(std::string& text, std::uint64_t n, std::string_view what) {
  list(text, n, std::string(what), std::string(what));
}

std::string outcomes_of(const Count& c) {
  std::string text;
  list(text, c.at(Outcome::false_hit), "false hit", "false hits");
  list(text, c.at(Outcome::false_miss), "false miss", "false misses");
  list(text, c.at(Outcome::wrong_contact), "wrong contact", "wrong contacts");
  list(text, c.at(Outcome::fault), "fault", "faults");
  return text;
}

std::string severities_of(const Count& c) {
  std::string text;
  for (const Severity s : all_severities) list(text, c.at(s), name_of(s));
  return text;
}

std::string causes_of(const Count& c) {
  std::string text;
  list(text, c.logic, name_of(Cause::logic));
  list(text, c.rounding, name_of(Cause::rounding));
  const std::uint64_t asked = c.logic + c.rounding;
  return text.empty() || asked == c.wrong ? text : text + " of " + std::to_string(asked) + " asked";
}

/// " 3 of 45 (binary64), 1 of 45 (binary32)": where the number is not 0.
std::string listed(const std::vector<Counted>& counts, const Number& number) {
  std::string text;
  for (const Counted& c : counts) {
    if (number(c.count) == 0) continue;
    text += (text.empty() ? " " : ", ") + std::to_string(number(c.count)) + " of " + std::to_string(c.count.judged()) +
            " (" + c.population + ")";
  }
  return text;
}

std::string all_right(const std::vector<Counted>& counts) {
  std::string text;
  for (const Counted& c : counts) {
    if (c.count.judged() == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(c.count.judged()) + " (" + c.population + ")";
  }
  return text.empty() ? "nothing was judged" : "nothing wrong of " + text;
}

}  // namespace

Count& Count::operator+=(const Count& other) {
  asked += other.asked;
  wrong += other.wrong;
  unsupported += other.unsupported;
  refused += other.refused;
  add_each(by_stage, other.by_stage);
  add_each(by_outcome, other.by_outcome);
  add_each(by_severity, other.by_severity);
  logic += other.logic;
  rounding += other.rounding;
  return *this;
}

std::string breakdown(const Count& count) {
  std::string text = outcomes_of(count);
  for (const std::string& part : {severities_of(count), causes_of(count)}) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  }
  if (count.unsaid() > 0) text += (text.empty() ? "" : "; ") + std::to_string(count.unsaid()) + " of a kind not said";
  if (count.refused > 0) text += (text.empty() ? "" : "; ") + std::to_string(count.refused) + " refused";
  return text;
}

std::string headline(const std::vector<Counted>& counts) {
  constexpr const char* where[] = {"wrong in plain general position", "wrong on boundaries", "wrong at extreme scales"};
  if (std::string text = listed(counts, &Count::unsaid); !text.empty()) {
    return "wrong:" + listed(counts, &Count::wrong) + "; in what position is not said";
  }
  for (const Severity s : all_severities) {
    const std::string text = listed(counts, [s](const Count& c) { return c.at(s); });
    if (text.empty()) continue;
    const bool alone = std::ranges::all_of(counts, [s](const Counted& c) { return c.count.at(s) == c.count.wrong; });
    const std::string begin = where[static_cast<std::size_t>(s)];
    if (alone) return begin + (s == Severity::plain ? ":" : " only:") + text;
    return begin + ":" + text + "; in all" + listed(counts, &Count::wrong);
  }
  return all_right(counts);
}

}  // namespace tribunal
