#include "exact/cli/fuzz_relations.h"

#include <cstdio>

#include "exact/cli/command.h"
#include "exact/harness/interrupt.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"
#include "exact/io/polygon_case_io.h"
#include "exact/polygon/relations.h"
#include "exact/relations/relation.h"

namespace tribunal {
namespace {

std::span<const Relation> relations_of(const FuzzPlan&) { return all_relations(); }
std::span<const PolygonRelation> relations_of(const PolygonFuzzPlan&) { return all_polygon_relations(); }

template <class C>
double share(const C& c) {
  return c.asked == 0 ? 0 : static_cast<double>(c.broken) / static_cast<double>(c.asked);
}

template <class P, class C>
std::string table(const P& plan, const std::vector<C>& counts) {
  std::string text;
  char line[240];
  std::snprintf(line, sizeof line, "%-14s %-16s %10s %10s  %-10s %s\n", "method", "relation", "asked", "broken",
                "share", "what must hold");
  text += line;
  for (const C& c : counts) {
    const auto& relation = relations_of(plan)[c.relation];
    std::snprintf(line, sizeof line, "%-14s %-16s %10llu %10llu  %-8.4f %% %s\n", plan.methods[c.method].name.c_str(),
                  std::string(relation.name).c_str(), static_cast<unsigned long long>(c.asked),
                  static_cast<unsigned long long>(c.broken), 100 * share(c), std::string(relation.statement).c_str());
    text += line;
  }
  return text;
}

template <class P, class C>
Json to_json(const P& plan, const std::vector<C>& counts) {
  Json rows = Json::array();
  for (const C& c : counts) {
    rows.push_back({{"method", plan.methods[c.method].name},
                    {"relation", relations_of(plan)[c.relation].name},
                    {"asked", c.asked},
                    {"broken", c.broken}});
  }
  return {{"seed", plan.seed}, {"cases", plan.cases}, {"relations", rows}};
}

/// All queries of every first witness; replay shows which answer is wrong.
template <class On, class C>
std::string witnesses(const BasicFuzzPlan<On>& plan, const std::vector<C>& counts) {
  std::string lines;
  for (const C& c : counts) {
    const std::string id = plan.methods[c.method].name + "-" + std::string(relations_of(plan)[c.relation].name);
    int n = 0;
    for (const auto& query : c.witness) {
      const typename On::Case witness{.id = id + "-" + std::to_string(++n), .query = query};
      lines += from_case(witness).dump() + "\n";
    }
  }
  return lines;
}

template <class On>
int run(const BasicFuzzPlan<On>& plan, const std::string& out) {
  if (!out.empty()) make_directory(out);
  const auto counts = check_relations(plan);
  bool any_broken = false;
  for (const auto& c : counts) any_broken |= c.broken > 0;
  print(table(plan, counts));
  if (!out.empty()) {
    write_file(out + "/relations.json", to_json(plan, counts).dump(1) + "\n");
    write_file(out + "/witnesses.jsonl", witnesses(plan, counts));
  }
  return exit_code_after(code(any_broken ? Exit::disagreement : Exit::ok), interrupted());
}

}  // namespace

int run_relations(const FuzzPlan& plan, const std::string& out) { return run(plan, out); }
int run_relations(const PolygonFuzzPlan& plan, const std::string& out) { return run(plan, out); }

}  // namespace tribunal
