#include "exact/certificate/owed.h"

#include <algorithm>

#include "exact/certificate/certify.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

/// Collects what a log lacks, one line each.
class Debts {
 public:
  void unless(bool paid, const std::string& fault) {
    if (!paid) faults_.push_back(fault);
  }
  std::vector<std::string> faults() && { return std::move(faults_); }

 private:
  std::vector<std::string> faults_;
};

/// Whether a budget with the name of one of the program's has its numbers. Other names may have any.
bool is_as_named(const Budget& b) {
  const auto named = std::ranges::find(budgets, b.name, &Budget::name);
  return named == budgets.end() || *named == b;
}

void require_sets(Debts& debts, const Certificate& c, const Owed& owed) {
  for (std::size_t i = 0; i < std::max(owed.sets.size(), c.proved.size()); ++i) {
    if (i >= c.proved.size()) {
      debts.unless(false, "the set \"" + owed.sets[i].name + "\" is owed and missing");
      continue;
    }
    const ProvedSet& logged = c.proved[i];
    const bool due = i < owed.sets.size() && logged.name == owed.sets[i].name && logged.size == owed.sets[i].size &&
                     logged.of_rays == owed.sets[i].of_rays;
    debts.unless(due, "the set \"" + logged.name + "\" is not the one that is owed in its place");
  }
}

bool is_own(const Json& stream) { return stream.value("family", "") == own_cases; }

std::string name_of_stream(const Json& r) { return r.value("family", "") + " " + r.value("fmt", ""); }

/// Older logs were judged by all oracles, but for what constructions say: that is more than is owed now.
bool is_judged_by_more(const Json& stream) {
  const std::string by = stream.value("judged_by", "");
  return by == "construction, 1 case in 257 also by the other oracles" || by == oracles_of(Operands::triangles);
}

/// The streams owed must come first, in order; those of the user's own meshes and cases may follow.
void require_streams(Debts& debts, const LogRecords& log, const Owed& owed) {
  std::vector<Json> logged;
  for (const Json& r : log.records) {
    if (r.value("record", "") == "stream" && !is_own(r)) logged.push_back(r);
  }
  for (std::size_t i = 0; i < owed.streams.size(); ++i) {
    Json found = i < logged.size() ? logged[i] : Json::object();
    found.erase("taken");
    if (is_judged_by_more(found)) found["judged_by"] = owed.streams[i]["judged_by"];
    debts.unless(found == owed.streams[i],
                 "the stream " + name_of_stream(owed.streams[i]) + " is not as budget and seed owe it");
  }
}

void require_taken(Debts& debts, const Certificate& c) {
  const Method* const method = find_method(c.method());
  if (method == nullptr) return;
  for (const SampledStream& s : c.streams) {
    if (s.is_own()) continue;
    debts.unless(s.taken == takes(*method, s.format), "whether " + s.family + " was taken is changed");
  }
}

/// Each naive method must have been asked every case that it takes, and no other method.
void require_calibration(Debts& debts, const Certificate& c) {
  const std::vector<Method> naive = calibration_beside(c.method());
  for (const Method& m : naive) {
    std::uint64_t due = 0;
    for (const SampledStream& s : c.streams) due += !s.is_own() && takes(m, s.format) ? s.cases : 0;
    const auto found = c.calibration.find(m.name);
    const std::uint64_t asked = found == c.calibration.end() ? 0 : found->second.total().asked;
    debts.unless(asked == due, "the calibration by " + m.name + " has " + std::to_string(asked) + " of " +
                                   std::to_string(due) + " cases that are owed");
  }
  debts.unless(c.calibration.size() == naive.size(), "the calibration has a method that is not owed");
}

}  // namespace

std::vector<std::string> debts_of(const Certificate& c, const LogRecords& log, const std::string& path) {
  Debts debts;
  const bool sampled = std::ranges::any_of(c.streams, [](const SampledStream& s) { return !s.is_own(); });
  if (!c.budget.is_object()) {
    debts.unless(c.proved.empty() && !sampled, "the log has sets or streams, and does not say what its budget owes");
    return std::move(debts).faults();
  }
  const Budget budget = to_budget(c.budget, {path});
  debts.unless(is_as_named(budget) && c.plan.at("budget") == budget.name,
               "the budget \"" + budget.name + "\" has other numbers");
  const Owed owed = owed_by(budget, number_of(c.plan, "seed", {path}), c.operands());
  require_sets(debts, c, owed);
  require_streams(debts, log, owed);
  require_taken(debts, c);
  require_calibration(debts, c);
  return std::move(debts).faults();
}

}  // namespace tribunal
