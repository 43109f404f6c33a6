// What certificate.json must look like.
#include <map>
#include <string>
#include <utility>

#include "exact/record/contract_json.h"
#include "exact/report/shapes.h"

namespace tribunal {
namespace {

using namespace shape;

/// More than there are classes, or constructions and outcomes of polygons.
constexpr std::uint64_t most_groups = 10'000;

/// Judged ones of so many; the same by stage.
Check coverage() {
  return [](const Record& r) {
    const std::string judged = r.has("classes") ? "classes" : "judged";
    const std::uint64_t n = r.count(judged);
    if (r.has("of")) require_part(r, n, r.count("of", most_groups), judged.c_str());
    for (const auto& [key, value] : r.members()) {
      if (key.starts_with("from_")) require_part(r, value.count(), n, key.c_str());
    }
  };
}

Check proved() {
  return object({needed("set", text()), needed("size", count()), if_there("probes", text()),
                 if_there("classes", count()), if_there("answers_hash", text()), if_there("complete", truth()),
                 if_there("judged_by", text()), if_there("count", answers())},
                [](const Record& r) {
                  require_part(r, r.count_or("classes", 0), r.count("size"), "classes");
                  if (const auto given = r.find("count"))
                    require_part(r, given->count("asked"), r.count("size"), "asked");
                });
}

Check relation() {
  return object({needed("relation", text()), needed("fmt", format()), needed("n", count()), needed("broken", count()),
                 if_there("statement", text()), if_there("probe", text()), if_there("lower_95", share()),
                 if_there("upper_95", share()), if_there("faults", count()), if_there("witness", list(object({})))},
                [](const Record& r) { require_part(r, r.count("broken"), r.count("n"), "broken"); });
}

/// A stratum of a sample, or of one's own cases.
Check stratum() {
  return object(
      {needed("family", text()), needed("fmt", format()), needed("n", count()), needed("k", count()),
       if_there("class", text()), if_there("case", text()), if_there("probe", text()), if_there("unsupported", count()),
       if_there("upper_95", share()), if_there("upper_95_simultaneous", share())},
      [](const Record& r) {
        const std::uint64_t n = r.count("n"), k = r.count("k");
        require_part(r, k, n, "k");
        require_kinds(r, k, r.count_or("unsupported", 0));
        for (const auto& [key, value] : r.members()) {
          if (key.starts_with("from_")) require_part(r, value.count(), n, key.c_str());
        }
      });
}

Check stream() {
  return object({needed("family", text()), needed("fmt", format()), if_there("population", text()),
                 if_there("judged_by", text()), if_there("cases", count())});
}

Check gap() { return object({if_there("what", text()), if_there("reason", text()), if_there("explained", truth())}); }

Check nonfinite() {
  return object({needed("fmt", format()), needed("asked", count()), needed("refused", count()),
                 needed("answered", count()), if_there("first", either({text(), count()}, "a case"))},
                [](const Record& r) {
                  require_part(r, r.count("refused"), r.count("asked"), "refused");
                  require_part(r, r.count("answered"), r.count("asked") - r.count("refused"), "answered");
                });
}

/// By method, and in newer records by format.
Check calibration() {
  return named([](const Record& r) { r.has("asked") ? answers()(r) : named(answers())(r); });
}

using Sums = std::map<std::pair<std::string, std::string>, std::uint64_t>;

/// Every case of a stream is in one stratum at most.
void require_within_streams(const Record& r) {
  Sums left;
  for (const Record& one : r.items_or_none("streams")) {
    if (!one.has("cases")) return;
    std::uint64_t& cases = left[{one.text("family"), one.text("fmt")}];
    cases += one.count("cases", Record::most_count - cases);
  }
  if (left.empty()) return;
  for (const char* strata : {"sampled", "own_cases"}) {
    for (const Record& row : r.items_or_none(strata)) {
      const auto stream = left.find({row.text("family"), row.text("fmt")});
      if (stream == left.end()) row.fail_at("family", "is none of \"streams\"");
      const std::uint64_t asked = row.count("n") + row.count_or("unsupported", 0);
      require_part(row, asked, stream->second, "cases of the stream that are left");
      stream->second -= asked;
    }
  }
}

/// Of the errors of its numbers: no more hits than the stream had cases.
void require_errors_within_streams(const Record& r) {
  for (const Record& row : r.items_or_none("errors")) {
    std::uint64_t cases = 0;
    bool known = true;
    for (const Record& one : r.items_or_none("streams")) {
      if (one.text("family") != row.text("family") || one.text("fmt") != row.text("fmt")) continue;
      known = known && one.has("cases");
      cases += one.count_or("cases", 0, Record::most_count - cases);
    }
    if (known) require_part(row, row.count("hits"), cases, "hits");
  }
}

/// Counterexamples are of what was wrong, and there is at most one of each.
void require_findings(const Record& r) {
  if (!r.has("counterexamples")) return;
  std::uint64_t wrong = 0;
  const auto add = [&](std::uint64_t n) { wrong += std::min(n, Record::most_count - wrong); };
  for (const char* strata : {"sampled", "own_cases"}) {
    for (const Record& row : r.items_or_none(strata)) add(row.count("k"));
  }
  for (const Record& row : r.items_or_none("proved")) {
    if (const auto given = row.find("count")) add(given->count("wrong"));
  }
  for (const Record& row : r.items_or_none("nonfinite_cases")) add(row.count("answered"));
  require_part(r, r.count("counterexamples"), wrong, "counterexamples");
  if (const auto faults = r.find("faults")) require_part(r, sum_of(*faults), r.count("counterexamples"), "faults");
}

}  // namespace

void require_certificate_record(const Record& record) {
  static const Check terms = [](const Record& r) { to_contract(r); };
  static const Check shape =
      object({needed("method", name()),
              needed("verdict", word({"not refuted", "refuted", "incomplete"})),
              if_there("worst", text()),
              if_there("budget", text()),
              if_there("seed", whole()),
              if_there("version", count(1000)),
              if_there("number", text()),
              if_there("reference", text()),
              if_there("convention", text()),
              if_there("contract", text()),
              if_there("operands", text()),
              if_there("terms", terms),
              if_there("stages", list(text())),
              if_there("command", command()),
              if_there("classes_judged", named(coverage())),
              if_there("ray_classes_judged", named(coverage())),
              if_there("polygons_judged", named(named(coverage()))),
              if_there("proved", list(proved())),
              if_there("relations", list(relation())),
              if_there("errors", list(errors({needed("family", text()), needed("fmt", format())}))),
              if_there("streams", list(stream())),
              if_there("sampled", list(stratum())),
              if_there("own_cases", list(stratum())),
              if_there("nonfinite_cases", list(nonfinite())),
              if_there("not_covered", list(gap())),
              if_there("calibration", calibration()),
              if_there("counterexamples", count()),
              if_there("faults", named(count())),
              if_there("environment", environment()),
              if_there("log_sha256", text())},
             [](const Record& r) {
               require_within_streams(r);
               require_errors_within_streams(r);
               require_findings(r);
             });
  shape(record);
}

}  // namespace tribunal
