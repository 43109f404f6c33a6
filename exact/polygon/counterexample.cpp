// Polygon counterexamples as cases, and what replay prints of them.
#include <cstdio>

#include "exact/methods.h"
#include "exact/polygon/fuzz.h"
#include "exact/polygon/shrink.h"

namespace tribunal {
namespace {

std::string describe(const PolygonTruth& truth) {
  return (truth.hit() ? "hit (" + std::string(name_of(truth.contact)) + ")" : "no hit") +
         std::string(truth.planar ? ", planar" : ", not planar");
}

std::string point(const char* name, const Point3& p) {
  char line[120];
  std::snprintf(line, sizeof line, "  %-6s (%.17g, %.17g, %.17g)\n", name, p.x, p.y, p.z);
  return line;
}

std::string points_of(const PolygonQuery& query) {
  std::string text;
  if (const auto* s = std::get_if<Segment>(&query.probe)) {
    text += point("p", s->p) + point("q", s->q);
  } else {
    text += point("o", std::get<Ray>(query.probe).o) + point("d", std::get<Ray>(query.probe).d.v);
  }
  const Polygon polygon = query.polygon;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    std::string name = r == 0 ? "outer" : "hole";
    for (const Point3& v : polygon.ring(r)) {
      text += point(name.c_str(), v);
      name.clear();
    }
  }
  return text;
}

std::string verdict_of(const Method& method, const PolygonCase& c, const PolygonTruth& truth,
                       const PolygonAnswer& answer, bool& wrong) {
  if (answer.answer.status != Status::ok) return std::string(name_of(answer.answer.status));
  if (!takes(method, c.format)) return "not judged: operands are binary64";
  const Judgement judgement = judge(method, truth, answer);
  if (judgement == Judgement::unsupported) return "not judged: outside its contract";
  if (judgement == Judgement::wrong) {
    wrong = true;
    return "WRONG";
  }
  return answer.answer.hit == truth.hit() ? "right" : "right by its convention (coplanar is a miss)";
}

}  // namespace

Json finding_of(const Method& method, const PolygonQuery& query, const PolygonTruth& truth) {
  Json finding;
  finding["method"] = method.name;
  finding["answered"] = method.ask(query).answer.hit ? 1 : 0;
  finding["expected"] = counts_as_hit(truth.contact, method.convention) ? 1 : 0;
  finding["convention"] = name_of(method.convention);
  finding["exact"] = {{"contact", name_of(truth.contact)}, {"planar", truth.planar}};
  return finding;
}

PolygonCase to_counterexample(const PolygonFuzzPlan& plan, const PolygonFinding& f) {
  const Method& method = plan.methods[f.method];
  const PolygonStream& stream = plan.streams[f.stream];
  PolygonCase c;
  c.format = stream.format;
  c.query = shrink(method, f.trial.query, stream.format);
  const PolygonTruth truth = exact_truth(c.query);
  c.expect = truth.hit();
  c.id = method.name + "-" + std::string(stream.family->name) + "-" + std::string(name_of(stream.format)) + "-" +
         std::to_string(f.k);
  c.finding = finding_of(method, c.query, truth);
  c.finding["origin"] = {{"family", stream.family->name}, {"seed", plan.seed}, {"case", f.k}};
  return c;
}

std::string replay(const PolygonCase& c, bool& wrong) {
  const PolygonTruth truth = exact_truth(c.query);
  std::string text = c.id + "  (" + std::string(name_of(c.format)) + ")\n" + points_of(c.query);
  text += "  exact answer " + describe(truth) + "\n";
  if (c.expect && *c.expect != truth.hit()) {
    wrong = true;
    text += std::string("  THE FILE IS WRONG: the case expects ") + (*c.expect ? "a hit" : "no hit") +
            ", the exact answer is " + describe(truth) + "\n";
  }
  for (const Method& method : all_methods()) {
    const PolygonAnswer answer = method.ask(c.query);
    const std::string said = answer.answer.status != Status::ok ? "-" : answer.answer.hit ? "hit" : "no hit";
    char line[160];
    std::snprintf(line, sizeof line, "  %-14s %-8s %-10s %s\n", method.name.c_str(), said.c_str(),
                  std::string(name_of(answer.answer.contact)).c_str(),
                  verdict_of(method, c, truth, answer, wrong).c_str());
    text += line;
  }
  return text;
}

}  // namespace tribunal
