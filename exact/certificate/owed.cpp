#include "exact/certificate/owed.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "exact/cases/family_table.h"
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

/// Whether a budget with the name of one of the program's has its numbers. Other names may have any. Logs before
/// version 3 have no relations.
bool is_as_named(const Budget& b, std::uint64_t version) {
  const auto named = std::ranges::find(budgets, b.name, &Budget::name);
  if (named == budgets.end()) return true;
  Budget due = *named;
  if (version < 3) due.relation_cases = 0;
  return due == b;
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

std::string kind_of(const Record& r) { return r.text("record"); }

bool is_own(const Record& r) { return r.text("family") == own_cases; }

std::string name_of_stream(const Record& r) { return r.text("family") + " " + r.text("fmt"); }

/// Older logs were judged by all oracles, but for what constructions say: that is more than is owed now.
bool is_judged_by_more(const Record& stream) {
  const std::string by = stream.text("judged_by");
  return by == "construction, 1 case in 257 also by the other oracles" || by == oracles_of(Operands::triangles);
}

/// The record of a stream as it is owed: without "taken", and judged by no more than is owed.
Json as_owed(const Record& stream, const Json& owed) {
  Json record = stream.json();
  record.erase("taken");
  if (is_judged_by_more(stream)) record["judged_by"] = owed["judged_by"];
  return record;
}

/// The streams owed must come first, in order; those of the user's own meshes and cases may follow.
void require_streams(Debts& debts, const LogRecords& log, const Owed& owed) {
  std::vector<Record> logged;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (kind_of(log[i]) == "stream" && !is_own(log[i])) logged.push_back(log[i]);
  }
  for (std::size_t i = 0; i < owed.streams.size(); ++i) {
    debts.unless(
        i < logged.size() && as_owed(logged[i], owed.streams[i]) == owed.streams[i],
        "the stream " + name_of_stream({owed.streams[i], {"what is owed"}}) + " is not as budget and seed owe it");
  }
}

/// Each count must be of a level that its family has; of families that this program does not know nothing is said.
void require_levels(Debts& debts, const Certificate& c, const LogRecords& log) {
  std::set<std::tuple<std::string, std::string, Format, std::size_t>> seen;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (kind_of(log[i]) != "sample") continue;
    const SampleRow row = to_sample_row(log[i]);
    const std::string whose = row.method + " on " + row.family + " " + std::string(name_of(row.format));
    // One's own cases of triangles and of polygons have a record each.
    const bool once = seen.emplace(row.method, row.family, row.format, row.level).second || row.family == own_cases;
    debts.unless(once, "the counts of " + whose + " at one level stand twice");
    const Family* const family = find_family(row.family);
    if (family == nullptr || c.version() < log_version) continue;
    const auto levels = family->levels(row.format);
    debts.unless(row.level < levels.size() && levels[row.level] == row.stress,
                 "the counts of " + whose + " are at a level that the family does not have");
  }
}

/// What the log says of a method that this program has must be so. Contracts of older logs may have changed.
void require_terms(Debts& debts, const Certificate& c) {
  const Method* const method = find_method(c.method());
  if (method == nullptr || c.version() < log_version || c.proved.empty()) return;
  debts.unless(c.contract == method->contract, "the terms are not the contract of " + method->name);
  debts.unless(std::ranges::equal(c.stages, method->stages), "the stages are not those of " + method->name);
}

/// The record without what was counted.
Json uncounted(Json record) {
  for (const char* key : {"asked", "broken", "faults", "first", "witness"}) record.erase(key);
  return record;
}

void require_relations(Debts& debts, const LogRecords& log, const Owed& owed) {
  std::vector<Json> logged;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (kind_of(log[i]) == "relation") logged.push_back(uncounted(log[i].json()));
  }
  debts.unless(logged == owed.relations, "the relations are not those that budget and seed owe");
}

void require_taken(Debts& debts, const Certificate& c) {
  const Method* const method = find_method(c.method());
  if (method == nullptr) return;
  for (const SampledStream& s : c.streams) {
    if (s.is_own()) continue;
    debts.unless(s.taken == takes(*method, s.format), "whether " + s.family + " was taken is changed");
  }
}

/// A method that gives numbers must have been asked for them in every stream of triangles that it takes.
void require_errors(Debts& debts, const Certificate& c) {
  const Method* const method = find_method(c.method());
  if (method == nullptr || !gives_numbers(*method) || c.operands() == Operands::polygons) return;
  std::vector<std::pair<std::string, Format>> owed, logged;
  for (const SampledStream& s : c.streams) {
    if (!s.is_own() && s.taken) owed.emplace_back(s.family, s.format);
  }
  for (const ErrorRow& e : c.errors) {
    if (e.family != own_cases) logged.emplace_back(e.family, e.format);
  }
  debts.unless(owed == logged, "the errors of numbers are not those of every stream");
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

std::vector<std::string> debts_of(const Certificate& c, const LogRecords& log) {
  Debts debts;
  const bool sampled = std::ranges::any_of(c.streams, [](const SampledStream& s) { return !s.is_own(); });
  if (!c.budget.is_object()) {
    debts.unless(c.proved.empty() && !sampled, "the log has sets or streams, and does not say what its budget owes");
    return std::move(debts).faults();
  }
  const Budget budget = to_budget({c.budget, {log.path, 3}});
  debts.unless(is_as_named(budget, c.version()) && c.plan["budget"] == budget.name,
               "the budget \"" + budget.name + "\" has other numbers");
  const Owed owed = owed_by(budget, c.seed(), c.operands());
  require_sets(debts, c, owed);
  require_streams(debts, log, owed);
  require_levels(debts, c, log);
  require_terms(debts, c);
  if (c.version() >= 3) require_relations(debts, log, owed);
  if (c.version() >= 3) require_errors(debts, c);
  require_taken(debts, c);
  require_calibration(debts, c);
  return std::move(debts).faults();
}

}  // namespace tribunal
