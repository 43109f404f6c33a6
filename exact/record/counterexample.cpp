#include "exact/record/counterexample.h"

#include <algorithm>
#include <cstdio>

#include "exact/base/failure.h"
#include "exact/base/record.h"
#include "exact/base/shown.h"
#include "exact/classes/class_table.h"
#include "exact/methods/methods.h"
#include "exact/record/contract_json.h"
#include "exact/record/environment.h"
#include "exact/shrink/shrink.h"
#include "exact/trial/describe.h"
#include "exact/trial/observe.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

/// What the method says within its contract; what it says of operands beyond its format does not count.
Answer answer_in_contract(const Method& method, Format format, const Query& query, const Truth& truth) {
  const Answer answer = within_contract(method, truth, try_ask(method, query).answer);
  return takes(method, format) ? answer : refusal(Status::unsupported);
}

/// 1, 0, or null where the method does not take the operands.
Json every_answer(const Case& c, const Truth& truth, const Method& on_trial, const Answer& its_answer) {
  Json answers = Json::object();
  for (const Method& method : all_methods()) {
    if (method.name == on_trial.name && is_fault(its_answer.status)) {
      answers[method.name] = Json();
      continue;
    }
    const Answer answer = answer_in_contract(method, c.format, c.query, truth);
    answers[method.name] = answer.status == Status::ok ? Json(answer.hit ? 1 : 0) : Json();
  }
  return answers;
}

/// Naive methods in binary64, Segura–Feito and Möller–Trumbore, which a sound test should not fall behind.
std::vector<Method> naive_beside(const Method& on_trial) {
  std::vector<Method> naive;
  for (const Role role : {Role::calibration, Role::charted}) {
    for (const Method& m : methods_with(role)) {
      const bool known = std::ranges::any_of(naive, [&](const Method& n) { return n.name == m.name; });
      if (!known && m.contract.format == Format::binary64 && m.name != on_trial.name) naive.push_back(m);
    }
  }
  return naive;
}

/// None of them is wrong. Of polygons, those that take none say nothing.
bool naive_are_right(const Method& on_trial, const Query& query, const Truth& truth) {
  return std::ranges::none_of(naive_beside(on_trial),
                              [&](const Method& m) { return is_wrong(judge(m, truth, try_ask(m, query).answer)); });
}

/// What the answer is and why, by words that `rank_of` reads.
void add_verdict(Json& finding, const Method& method, const Query& query, const Truth& truth, const Answer& answer) {
  const Outcome outcome = judge(method, truth, answer);
  const Severity severity = severity_of(query, truth);
  const Cause cause = is_wrong(outcome) ? cause_of(method, query, truth, outcome) : Cause::unknown;
  finding["outcome"] = name_of(outcome);
  finding["severity"] = name_of(severity);
  finding["cause"] = name_of(cause);
  finding["naive_right"] = naive_are_right(method, query, truth);
  finding["in_words"] = in_words(outcome, severity, cause);
  if (outcome == Outcome::wrong_contact) {
    finding["contact_told"] = name_of(answer.contact);
    finding["contact"] = name_of(truth.contact);
    if (answer.facing != truth.facing && answer.facing != Facing::unsaid) {
      finding["side_told"] = name_of(answer.facing);
      finding["side"] = name_of(truth.facing);
    }
    if (answer.planar != truth.planar) finding["planar_told"] = answer.planar;
  }
}

Json finding_of(const Case& c, const Method& method, const Truth& truth, const Answer& answer) {
  Json finding;
  finding["method"] = method.name;
  add_verdict(finding, method, c.query, truth, answer);
  if (!is_fault(answer.status)) finding["answered"] = answer.hit ? 1 : 0;
  finding["expected"] = due(method.contract, truth) == Due::hit ? 1 : 0;
  add_readings(finding, method.contract);
  finding["exact"] = exact_evidence(c.query);
  finding["answers"] = every_answer(c, truth, method, answer);
  finding["made_with"] = environment();
  return finding;
}

/// How often a case that blames a method for answering differently is asked again.
constexpr int times_for_known_fault = 32;

bool blames_a_fault(const Json& finding) { return finding.is_object() && finding.contains("fault"); }

/// In place of an answer, the fault. What it answered is not said: nothing, or one thing and then another.
Case with_fault(Case c, const Method& method, const Truth& truth, const Fault& fault) {
  c = with_finding(std::move(c), method, truth, refusal(fault.kind));
  c.finding["fault"] = fault_name(fault.kind);
  if (!fault.detail.empty()) c.finding["detail"] = fault.detail;
  return c;
}

/// What the method does on a query that it answered wrongly before: it is a fault if it now answers otherwise.
Asked observe_wrong(const Method& method, const Query& query, const Truth& truth) {
  Asked seen = observe(method, query);
  const bool right_now = !is_wrong(judge(method, truth, seen.answer));
  if (!seen.fault && right_now) seen.fault = Fault{Status::differs_when_repeated};
  return seen;
}

/// What is known of a fault that was seen before: the same again, or that it did not come again.
Fault known_fault(Status before, const Fault& now) {
  if (now.kind == before) return now;
  return {before, "once, not when asked again"};
}

/// The case, which the method answered wrongly, or by the fault `before`, with its finding; shrunk if the method
/// answers it the same every time.
Case with_shrunk_finding(Case c, const Method& method, Status before = Status::ok) {
  Truth truth = exact_truth(c.query);
  auto seen = observe_wrong(method, c.query, truth);
  if (is_fault(before)) seen.fault = known_fault(before, seen.fault);
  if (!seen.fault) {
    c.query = shrink(method, c.query, c.format);
    truth = exact_truth(c.query);
    seen = observe_wrong(method, c.query, truth);
  }
  if (seen.fault) return with_fault(std::move(c), method, truth, seen.fault);
  c = with_finding(std::move(c), method, truth, seen.answer);
  return c;
}

std::string row(const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
  char line[160];
  std::snprintf(line, sizeof line, "  %-22s %-8s %-10s %s\n", a.c_str(), b.c_str(), c.c_str(), d.c_str());
  return line;
}

/// Id, format and points.
std::string heading(const Case& c) {
  return shown(c.id) + "  (" + std::string(name_of(c.format)) + ")\n" + points_of(c.query);
}

/// "WRONG: false hit, rounding"
std::string wrong_in_words(const Method& method, const Query& query, const Truth& truth, Outcome outcome) {
  const Cause cause = cause_of(method, query, truth, outcome);
  const std::string text = "WRONG: " + std::string(name_of(outcome));
  return cause == Cause::unknown ? text : text + ", " + std::string(name_of(cause));
}

/// How one method did on a case, and whether that was wrong.
std::string verdict_of(const Method& method, const Case& c, const Truth& truth, bool& wrong) {
  const Asked seen = observe(method, c.query, blames_a_fault(c.finding) ? times_for_known_fault : 1);
  if (seen.fault) {
    wrong = true;
    return row(method.name, "-", "", "WRONG: " + describe(seen.fault));
  }
  const auto given = seen.answer;
  const Answer answer = given;
  if (answer.status != Status::ok) return row(method.name, "-", "", std::string(name_of(answer.status)));
  const auto says = [&](const char* verdict) {
    return row(method.name, answer.hit ? "hit" : "no hit", std::string(name_of(answer.contact)), verdict);
  };
  if (!takes(method, c.format)) return says("not judged: operands are binary64");
  const Outcome outcome = judge(method, truth, given);
  wrong |= is_wrong(outcome);
  if (!is_judged(outcome)) return says("not judged: outside its contract");
  if (is_wrong(outcome)) return says(wrong_in_words(method, c.query, truth, outcome).c_str());
  if (answer.hit == truth.hit()) return says("right");
  return says(truth.contact == Contact::coplanar ? "right by its convention (coplanar is a miss)"
                                                 : "right by its contract (such a contact is a miss)");
}

}  // namespace

Case with_finding(Case c, const Method& method, const Truth& truth, const Answer& answer) {
  c.expect = truth.hit();
  c.class_id = truth.class_id;
  c.finding = finding_of(c, method, truth, answer);
  return c;
}

Case with_steady_finding(Case c, const Method& method, const Truth& truth, const Answer& answer) {
  Fault fault{answer.status};
  if (fault && method.last_fault) fault.detail = method.last_fault();
  if (!fault && method.segment) fault = asked_again(method, c.query, answer);
  return fault ? with_fault(std::move(c), method, truth, fault) : with_finding(std::move(c), method, truth, answer);
}

Case to_counterexample(const Method& method, const Query& query, Format format, const std::string& source,
                       Status before) {
  Case c{.format = format, .query = query, .source = source};
  c = with_shrunk_finding(std::move(c), method, before);
  c.id = method.name + "-" + id_part(exact_truth(c.query));
  return c;
}

Case to_counterexample(const FuzzPlan& plan, const Finding& f) {
  const Stream& stream = plan.streams[f.stream];
  auto c = to_counterexample(plan.methods[f.method], f.trial.query, stream.format, "", f.answer.status);
  const std::string fmt(name_of(stream.format));
  c.id += "-" + std::string(stream.family->name) + "-" + fmt + "-" + std::to_string(f.k);
  c.finding["origin"] = {{"family", stream.family->name},
                         {"fmt", fmt},
                         {"seed", plan.seed},
                         {"case", f.k},
                         {"stress", stream.family->levels(stream.format)[f.trial.level]},
                         {"axis", stream.family->axis}};
  if (const auto& data = stream.family->data) {
    c.finding["origin"]["file"] = data->file;
    c.finding["origin"]["sha256"] = data->sha256;
  }
  return c;
}

void ask_again(const FuzzPlan& plan, FuzzReport& report) {
  for (Finding& f : report.findings) {
    const Method& method = plan.methods[f.method];
    f.fault = {f.answer.status};
    if (!f.fault) f.fault = observe_wrong(method, f.trial.query, f.truth).fault;
    f.cause = f.fault ? Cause::unknown : cause_of(method, f.trial.query, f.truth, f.outcome);
    f.naive_right = naive_are_right(method, f.trial.query, f.truth);
  }
  std::ranges::stable_sort(report.findings, {}, &Finding::rank);
}

Rank rank_of(const Case& c, const Where& where) {
  if (c.finding.is_null()) return {};
  const Record finding(c.finding, where);
  Rank rank;
  rank.contact_alone = finding.text_or("outcome", "") == name_of(Outcome::wrong_contact);
  rank.naive_wrong = !finding.truth_or("naive_right", false);
  const std::string severity = finding.text_or("severity", ""), cause = finding.text_or("cause", "");
  for (const Severity s : all_severities) {
    if (severity == name_of(s)) rank.severity = s;
  }
  for (const Cause known : {Cause::logic, Cause::rounding}) {
    if (cause == name_of(known)) rank.cause = known;
  }
  return rank;
}

Rank rank_of(const Case& c) { return rank_of(c, {c.id, 0, "finding"}); }

void sort_by_rank(std::vector<Case>& cases) {
  std::ranges::stable_sort(cases, {}, [](const Case& c) { return rank_of(c); });
}

Case shrunk(Case c, const Method& method) {
  const Truth truth = exact_truth(c.query);
  const Asked seen = observe(method, c.query, blames_a_fault(c.finding) ? times_for_known_fault : 1);
  if (!seen.fault && !is_wrong(judge(method, truth, seen.answer))) {
    throw Failure(Exit::bad_input, shown(c.id) + ": " + method.name + " answers it rightly, expected a counterexample");
  }
  const Json origin = c.finding.is_object() && c.finding.contains("origin") ? c.finding["origin"] : Json();
  c = seen.fault ? with_fault(std::move(c), method, truth, seen.fault) : with_shrunk_finding(std::move(c), method);
  if (!origin.is_null()) c.finding["origin"] = origin;
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
  if (c.class_id == 0 || c.class_id == truth.class_id) return "";
  return "the case claims " + class_name(c.class_id) + ", the exact answer is " + describe(truth);
}

namespace {

/// Of a case with numbers that are not finite, which every method must refuse.
std::string refusals(const Case& c, const std::vector<Method>& methods, bool& wrong) {
  std::string text = "  no exact answer: a number is not finite\n" + row("method", "answer", "contact", "verdict");
  for (const Method& method : methods) {
    const Answer answer = try_ask(method, c.query).answer;
    const bool refused = answer.status == Status::nonfinite;
    wrong |= !refused;
    text += row(method.name, "-", "", (refused ? "" : "WRONG: ") + std::string(name_of(answer.status)));
  }
  return text;
}

}  // namespace

std::string replay(const Case& c, const std::vector<Method>& methods, bool& wrong) {
  if (!is_finite(c.query)) return heading(c) + refusals(c, methods, wrong);
  const Truth truth = exact_truth(c.query);
  std::string text =
      heading(c) + "  exact " + exact_evidence(c.query).dump() + "\n  exact answer " + describe(truth) + "\n";
  if (const std::string error = mistaken_claim(c, truth); !error.empty()) {
    wrong = true;
    text += "  THE FILE IS WRONG: " + error + "\n";
  }
  text += row("method", "answer", "contact", "verdict");
  for (const Method& method : methods) text += verdict_of(method, c, truth, wrong);
  return text;
}

}  // namespace tribunal
