// What was measured: chart.json of `chart`, and the JSON of a benchmark (`./run bench`).
#include <algorithm>

#include "exact/report/gathering.h"

namespace tribunal {

void gather_chart(Run& run, Gathering& g) {
  Json r = run.record;
  run.page["methods"] = Json::array();
  for (const Json& m : r.at("methods")) run.page["methods"].push_back(g.add_method(m));
  run.page["command"] = command_in(run);
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_bench(Run& run, Gathering&) {
  Json r = run.record;
  for (const char* key : {"executable", "host_name"}) r.at("context").erase(key);
  run.page["methods"] = Json::array();
  run.page["environment"] = {{"processor", std::to_string(r["context"].value("num_cpus", 0)) + " cores"}};
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
