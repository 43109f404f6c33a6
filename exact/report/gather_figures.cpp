// What was measured: chart.json of `chart`, and the JSON of a benchmark (`./run bench`).
#include <algorithm>

#include "exact/report/gathering.h"
#include "exact/report/shapes.h"

namespace tribunal {

void gather_chart(Run& run, Gathering& g) {
  require_chart_record(run.all());
  Json r = run.record;
  run.page["methods"] = Json::array();
  for (const Record& m : run.all().items("methods")) run.page["methods"].push_back(g.add_method(m));
  run.page["command"] = command_in(run);
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_bench(Run& run, Gathering&) {
  require_bench_record(run.all());
  const Record context = run.all().member("context").object();
  run.page["environment"] = {{"processor", std::to_string(number_in(context, "num_cpus")) + " cores"}};
  run.page["methods"] = Json::array();
  Json r = run.record;
  for (const char* key : {"executable", "host_name"}) r["context"].erase(key);
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
