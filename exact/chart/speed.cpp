#include "exact/chart/speed.h"

#include <algorithm>
#include <cstdio>

#include "exact/base/json.h"
#include "exact/chart/pairs.h"
#include "exact/chart/timing_json.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

struct Call {
  SpeedRow row;
  NativeLoop loop;
};

constexpr const char* set_up = "set-up";

void add_calls(std::vector<Call>& calls, const Method& m, ProbeKind kind) {
  const NativeLoops& native = loops_of(m, kind);
  const auto add = [&](const char* call, std::size_t bytes, NativeLoop loop) {
    calls.push_back({{m.name, kind, call, bytes, {}, false}, std::move(loop)});
  };
  add("single", native.prepared ? 0 : native.bytes, single_loop(m, kind));
  if (native.batch) add("batch", native.bytes, native.batch);
  if (!native.prepared) return;
  add("prepared", native.bytes, prepared_loop(m, kind));
  if (kind == ProbeKind::segment) add(set_up, native.bytes, set_up_loop(m));
}

bool takes(const Method& m, ProbeKind kind) {
  if (m.contract.triangles == Triangles::none) return false;
  return kind == ProbeKind::segment ? m.segment && m.contract.probes.segments : m.ray && m.contract.probes.rays;
}

/// A test that does nothing does the same about a ray.
std::vector<Call> calls_of(std::span<const Method> methods, ProbeKind kind) {
  std::vector<Call> calls = {{{"(empty loop)", kind, "single", 0, {}, true}, empty_loop()},
                             {{"(empty C function)", kind, "single", 0, {}, true}, empty_call_loop()}};
  for (const Method& m : methods) {
    if (takes(m, kind)) add_calls(calls, m, kind);
  }
  return calls;
}

bool is_of_yardstick(const Call& call) {
  return call.row.method == yardstick_method().name && call.row.call == std::string_view("single");
}

/// The yardstick's single tests first, whether or not it is among the methods, and not a second time if it is.
std::vector<SpeedRow> measure(std::span<const Method> methods, ProbeKind kind, int repetitions) {
  std::vector<Call> calls = calls_of(methods, kind);
  for (const int percent : hit_shares) {
    const std::vector<SegmentPair> pairs =
        kind == ProbeKind::segment ? random_pairs(timed_pairs, percent) : random_rays(timed_pairs, percent);
    std::vector<TimedTest> tests{timed_test(single_loop(yardstick_method(), kind), pairs)};
    for (const Call& call : calls) {
      if (!is_of_yardstick(call)) tests.push_back(timed_test(call.loop, pairs));
    }
    const std::vector<Timing> times =
        time_stretches(tests, {.cases = pairs.size(), .round = 100, .repetitions = repetitions, .yardstick = 0});
    std::size_t next = 1;
    for (Call& call : calls) call.row.times.push_back(times[is_of_yardstick(call) ? 0 : next++]);
  }
  std::vector<SpeedRow> rows;
  for (Call& call : calls) {
    if (call.row.call == set_up) call.row.times.resize(1);
    rows.push_back(std::move(call.row));
  }
  return rows;
}

std::string cell(const Timing& t) {
  char text[48];
  std::snprintf(
      text, sizeof text, "%9.1f %-15s", t.median,
      ("(" + std::to_string(t.lower_quartile).substr(0, 5) + "-" + std::to_string(t.upper_quartile).substr(0, 5) + ")")
          .c_str());
  return text;
}

}  // namespace

std::vector<SpeedRow> measure_speed(std::span<const Method> methods, int repetitions) {
  std::vector<SpeedRow> rows = measure(methods, ProbeKind::segment, repetitions);
  for (SpeedRow& row : measure(methods, ProbeKind::ray, repetitions)) rows.push_back(std::move(row));
  return rows;
}

Json to_json(const std::vector<SpeedRow>& rows) {
  Json array = Json::array();
  for (const SpeedRow& r : rows) {
    for (std::size_t i = 0; i < r.times.size(); ++i) {
      Json row = {{"method", r.method},
                  {"probe", r.call == set_up ? Json() : Json(name_of(r.probe))},
                  {"call", r.call},
                  {"nanoseconds", timing_json(r.times[i])}};
      if (r.does_nothing) row["nothing"] = true;
      row["bytes"] = r.bytes == 0 ? Json() : Json(r.bytes);
      row["percent_hits"] = r.call == set_up ? Json() : Json(hit_shares[i]);
      array.push_back(row);
    }
  }
  return array;
}

std::string to_table(const std::vector<SpeedRow>& rows) {
  std::string text =
      "Time of a test by the share of hits: random segments or rays, and triangles, native loops, ns (quartiles); "
      "set-up: ns a triangle\n";
  char line[200];
  std::snprintf(line, sizeof line, "  %-22s %-8s %-9s %5s", "method", "probe", "call", "bytes");
  text += line;
  for (const int percent : hit_shares) {
    std::snprintf(line, sizeof line, " %25s", (std::to_string(percent) + " % hits          ").c_str());
    text += line;
  }
  text += "\n";
  for (const SpeedRow& r : rows) {
    std::snprintf(line, sizeof line, "  %-22s %-8s %-9s %5s", r.method.c_str(),
                  r.call == set_up ? "" : name_of(r.probe).data(), r.call.c_str(),
                  r.bytes == 0 ? "" : std::to_string(r.bytes).c_str());
    text += line;
    for (const Timing& t : r.times) text += " " + cell(t);
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text + "\n";
}

}  // namespace tribunal
