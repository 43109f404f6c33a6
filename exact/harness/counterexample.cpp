#include "exact/harness/counterexample.h"

#include <cstdio>

#include "exact/classes/class_table.h"
#include "exact/harness/shrink.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

/// Where on the probe the plane of t lies: V(p) / (V(p) − V(q)) on a segment, V(o) / −V(d) on a ray.
HitParameter<Dyadic> parameter(const Ray& r, const Triangle& t) { return hit_parameter<Dyadic>(r, t); }

HitParameter<Dyadic> parameter(const Segment& s, const Triangle& t) {
  const Dyadic from_p = signed_volume<Dyadic>(t.a, t.b, t.c, s.p);
  return {from_p, from_p - signed_volume<Dyadic>(t.a, t.b, t.c, s.q)};
}

template <class P>
Json evidence(const P& probe, const Triangle& t) {
  const RationalKernel k;
  const Point3& p = source(probe);
  const auto& q = target(probe);
  Json object;
  object["abcp"] = value(k.orient3d(t.a, t.b, t.c, p));
  object["abcq"] = value(k.orient3d(t.a, t.b, t.c, q));
  object["pqab"] = value(k.orient3d(p, t.a, t.b, q));
  object["pqbc"] = value(k.orient3d(p, t.b, t.c, q));
  object["pqca"] = value(k.orient3d(p, t.c, t.a, q));
  const HitParameter<Dyadic> at = parameter(probe, t);
  if (sign_of(at.den) != Sign::zero) {
    object["t"] = mpq_class(at.num.fraction() / at.den.fraction()).get_str();
  }
  return object;
}

std::string describe(const Truth& truth) {
  std::string text = truth.hit() ? "hit (" + std::string(name_of(truth.contact)) + ")" : "no hit";
  if (truth.class_id != 0) {
    const ClassRow& row = class_row(truth.class_id);
    text = class_name(truth.class_id) + ": " + text + "; triangle " + row.triangle + ", segment " + row.segment +
           ", meet in: " + row.intersection;
  }
  return text;
}

std::string row(const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
  char line[160];
  std::snprintf(line, sizeof line, "  %-14s %-8s %-10s %s\n", a.c_str(), b.c_str(), c.c_str(), d.c_str());
  return line;
}

std::string decimal(const Point3& p) {
  char line[120];
  std::snprintf(line, sizeof line, "%.17g, %.17g, %.17g", p.x, p.y, p.z);
  return line;
}

std::string points_of(const Query& query) {
  std::string text;
  const auto add = [&](const char* name, const Point3& p) {
    text += std::string("  ") + name + " = (" + decimal(p) + ")\n";
  };
  if (const auto* s = std::get_if<Segment>(&query.probe)) {
    add("p", s->p);
    add("q", s->q);
  } else {
    add("o", std::get<Ray>(query.probe).o);
    add("d", std::get<Ray>(query.probe).d.v);
  }
  add("a", query.triangle.a);
  add("b", query.triangle.b);
  add("c", query.triangle.c);
  return text;
}

std::string verdict_of(const Method& method, Format format, const Truth& truth, const Answer& answer, bool& wrong) {
  if (answer.status != Status::ok) return std::string(name_of(answer.status));
  if (!takes(method, format)) return "not judged: operands are binary64";
  if (judge(method, truth, answer) == Judgement::wrong) {
    wrong = true;
    return "WRONG";
  }
  const bool by_convention = answer.hit != truth.hit();
  return by_convention ? "right by its convention (coplanar is a miss)" : "right";
}

}  // namespace

Json exact_evidence(const Query& query) {
  return std::visit([&](const auto& probe) { return evidence(probe, query.triangle); }, query.probe);
}

Json finding_of(const Method& method, const Query& query, const Truth& truth) {
  return finding_of(method.name, method.convention, method.ask(query).hit, query, truth);
}

Json finding_of(const std::string& method, Convention convention, bool answered, const Query& query,
                const Truth& truth) {
  Json finding;
  finding["method"] = method;
  finding["answered"] = answered ? 1 : 0;
  finding["expected"] = counts_as_hit(truth.contact, convention) ? 1 : 0;
  finding["convention"] = name_of(convention);
  finding["exact"] = exact_evidence(query);
  return finding;
}

Case to_counterexample(const FuzzPlan& plan, const Finding& f) {
  const Method& method = plan.methods[f.method];
  const Stream& stream = plan.streams[f.stream];
  Case c;
  c.format = stream.format;
  c.query = shrink(method, f.trial.query, stream.format);
  const Truth truth = exact_truth(c.query);
  c.expect = truth.hit();
  c.class_id = truth.class_id;
  const std::string origin = std::string(stream.family->name) + "-" + std::string(name_of(stream.format));
  c.id = method.name + "-" + class_name(truth.class_id) + "-" + origin + "-" + std::to_string(f.k);
  c.finding = finding_of(method, c.query, truth);
  c.finding["origin"] = {{"family", stream.family->name}, {"seed", plan.seed}, {"case", f.k}};
  return c;
}

std::string to_lines(const std::vector<Case>& cases) {
  std::string lines;
  for (const Case& c : cases) lines += from_case(c).dump() + "\n";
  return lines;
}

std::string mistaken_claim(const Case& c, const Truth& truth) {
  if (c.expect && *c.expect != truth.hit()) {
    return std::string("the case expects ") + (*c.expect ? "a hit" : "no hit") + ", the exact answer is " +
           describe(truth);
  }
  if (c.class_id != 0 && c.class_id != truth.class_id) {
    return "the case claims " + class_name(c.class_id) + ", the exact answer is " + describe(truth);
  }
  return "";
}

std::string replay(const Case& c, bool& wrong) {
  const Truth truth = exact_truth(c.query);
  std::string text = c.id + "  (" + std::string(name_of(c.format)) + ")\n" + points_of(c.query);
  text += "  exact " + exact_evidence(c.query).dump() + "\n  exact answer " + describe(truth) + "\n";
  if (const std::string error = mistaken_claim(c, truth); !error.empty()) {
    wrong = true;
    text += "  THE FILE IS WRONG: " + error + "\n";
  }
  text += row("method", "answer", "contact", "verdict");
  for (const Method& method : all_methods()) {
    const Answer answer = method.ask(c.query);
    const std::string said = answer.status != Status::ok ? "-" : answer.hit ? "hit" : "no hit";
    text += row(method.name, said, std::string(name_of(answer.contact)),
                verdict_of(method, c.format, truth, answer, wrong));
  }
  return text;
}

}  // namespace tribunal
