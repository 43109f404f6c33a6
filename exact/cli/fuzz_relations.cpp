#include "exact/cli/fuzz_relations.h"

#include <cstdio>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/interrupt.h"
#include "exact/base/output.h"
#include "exact/cases/case_io.h"
#include "exact/cli/command.h"
#include "exact/record/data_record.h"
#include "exact/relations/relation.h"

namespace tribunal {
namespace {

double share(const RelationCount& c) {
  return c.asked == 0 ? 0 : static_cast<double>(c.broken) / static_cast<double>(c.asked);
}

const Relation& relation_of(const FuzzPlan& plan, const RelationCount& c) {
  return relations_of(plan.operands())[c.relation];
}

/// One line for each method, relation and format. The counts come with those of segments and of rays side by side.
std::string table(const FuzzPlan& plan, const std::vector<RelationCount>& counts) {
  std::string text;
  char line[240];
  std::snprintf(line, sizeof line, "%-22s %-16s %-8s %10s %10s  %-10s %s\n", "method", "relation", "format", "asked",
                "broken", "share", "what must hold");
  text += line;
  for (std::size_t i = 0; i < counts.size(); i += 2) {
    RelationCount c = counts[i];
    c += counts[i + 1];
    if (c.asked == 0 && !takes(plan.methods[c.method], c.format)) continue;
    const Relation& relation = relation_of(plan, c);
    std::snprintf(line, sizeof line, "%-22s %-16s %-8s %10llu %10llu  %-8.4f %% %s\n",
                  plan.methods[c.method].name.c_str(), std::string(relation.name).c_str(),
                  std::string(name_of(c.format)).c_str(), static_cast<unsigned long long>(c.asked),
                  static_cast<unsigned long long>(c.broken), 100 * share(c), std::string(relation.statement).c_str());
    text += line;
  }
  return text;
}

Json to_json(const FuzzPlan& plan, const std::vector<RelationCount>& counts) {
  Json rows = Json::array();
  for (const RelationCount& c : counts) {
    rows.push_back({{"method", plan.methods[c.method].name},
                    {"relation", relation_of(plan, c).name},
                    {"fmt", name_of(c.format)},
                    {"probes", c.of_rays ? "ray" : "segment"},
                    {"asked", c.asked},
                    {"broken", c.broken}});
  }
  Json object = {{"seed", plan.seed}, {"cases", plan.cases}, {"families", family_names_of(plan)}, {"relations", rows}};
  if (const Json data = data_of(plan); !data.empty()) object["data"] = data;
  return object;
}

/// All queries of every first witness; replay shows which answer is wrong.
std::string witnesses(const FuzzPlan& plan, const std::vector<RelationCount>& counts) {
  std::string lines;
  for (const RelationCount& c : counts) {
    const std::string id = plan.methods[c.method].name + "-" + std::string(relation_of(plan, c).name) + "-" +
                           std::string(name_of(c.format)) + (c.of_rays ? "-ray" : "-segment");
    int n = 0;
    for (const auto& query : c.witness) {
      const Case witness{.id = id + "-" + std::to_string(++n), .format = c.format, .query = query};
      lines += from_case(witness).dump() + "\n";
    }
  }
  return lines;
}

}  // namespace

int run_relations(const FuzzPlan& plan, const std::string& out) {
  if (!out.empty()) make_directory(out);
  const auto counts = check_relations(plan);
  fail_if_interrupted("nothing was written");
  bool any_broken = false;
  for (const auto& c : counts) any_broken |= c.broken > 0;
  print(table(plan, counts));
  if (!out.empty()) {
    OutputSet set;
    set.add(out + "/witnesses.jsonl", witnesses(plan, counts));
    set.add(out + "/relations.json", to_json(plan, counts).dump(1) + "\n");
    set.commit();
  }
  return code(any_broken ? Exit::disagreement : Exit::ok);
}

}  // namespace tribunal
