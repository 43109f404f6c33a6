#include "exact/sweep/sweep.h"

#include <algorithm>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"

namespace tribunal {
namespace {

constexpr Format formats[] = {Format::binary32, Format::binary64};

constexpr int one_level[] = {0};
std::span<const int> no_levels(Format) { return one_level; }

std::size_t index_of(SweptOutcome o) { return static_cast<std::size_t>(o); }

/// The cases of an axis at one value, as a family of their own.
Family family_at(const StressAxis& axis, int value) {
  return {.name = axis.name,
          .stresses = axis.quantity,
          .population = axis.population,
          .axis = axis.quantity,
          .constructs = false,
          .levels = no_levels,
          .make = [&axis, value](Format format, std::uint64_t seed,
                                 std::uint64_t k) { return case_at(axis, format, seed, value, k); },
          .operands = axis.operands};
}

/// All values of one axis in both formats: each is a stream of the harness.
struct Streams {
  std::vector<Family> families{};
  std::vector<Stream> streams{};
  std::vector<int> values{};
};

Streams streams_of(const StressAxis& axis, const std::vector<Method>& methods) {
  Streams s;
  std::vector<Format> of_family;
  for (const Format format : formats) {
    const auto is_taken = [&](const Method& m) { return takes(m, format); };
    if (std::ranges::none_of(methods, is_taken)) continue;
    for (const int value : axis.values(format)) {
      s.families.push_back(family_at(axis, value));
      s.values.push_back(value);
      of_family.push_back(format);
    }
  }
  for (std::size_t i = 0; i < s.families.size(); ++i) s.streams.push_back({&s.families[i], of_family[i]});
  return s;
}

void add(Sweep& sweep, const SweepPlace& place, const Contract& contract, const JudgedAnswer& a) {
  sweep.counts[place].add(a, contract);
  if (a.outcome == Outcome::right || a.outcome == Outcome::not_owed) return;
  sweep.note(place, swept(a.outcome), {a.k, a.trial.query, a.answer.status});
}

std::string label_of(const SweepPlan& plan, std::size_t axis) {
  return "sweep " + std::string(plan.axes[axis]->name) + " (" + std::to_string(axis + 1) + " of " +
         std::to_string(plan.axes.size()) + ")";
}

void sweep_axis(const SweepPlan& plan, std::size_t axis, Sweep& result) {
  const StressAxis& a = *plan.axes[axis];
  std::vector<std::size_t> asked;  // of the plan's methods
  FuzzPlan trial{.methods = {}, .streams = {}, .seed = plan.seed, .threads = plan.threads};
  trial.label = label_of(plan, axis);
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    if (!takes(plan.methods[m], a)) continue;
    asked.push_back(m);
    trial.methods.push_back(plan.methods[m]);
  }
  const Streams s = streams_of(a, trial.methods);
  if (s.streams.empty()) return;
  trial.streams = s.streams;
  trial.cases = plan.cases * s.streams.size();
  trial.quick = quick_class_for(trial.methods, a.operands);
  std::vector<Sweep> parts(plan.threads);  // one a worker
  trial.watch = [&](unsigned worker, const JudgedAnswer& j) {
    const ProbeKind probe = is_of_ray(j.trial.query) ? ProbeKind::ray : ProbeKind::segment;
    const SweepPlace place{asked[j.method], axis, s.streams[j.stream].format, s.values[j.stream], probe};
    add(parts[worker], place, trial.methods[j.method].contract, j);
  };
  result.audited += fuzz(trial).audited;
  if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no record written");
  for (const Sweep& part : parts) result += part;
}

}  // namespace

void SweepCount::add(const JudgedAnswer& a, const Contract& contract) {
  count.add(a.outcome, a.answer.stage);
  due_hits += is_judged(a.outcome) && due(contract, a.truth) == Due::hit;
  if (a.outcome == Outcome::right || a.outcome == Outcome::not_owed) return;
  ++of[index_of(swept(a.outcome))];
  if (!is_wrong(a.outcome)) return;
  count.add_wrong(a.severity, a.cause);
  plain[index_of(swept(a.outcome))] += a.severity == Severity::plain;
}

void SweepCount::add(const MeshAnswer& a) {
  ++mesh_rays;
  ++count.asked;
  parity_judged += a.parity_judged;
  std::optional<Severity> worst;
  for (std::size_t o = 0; o < a.errors.size(); ++o) {
    if (!a.errors[o]) continue;
    ++of[o];
    plain[o] += *a.errors[o] == Severity::plain;
    if (!worst || *a.errors[o] < *worst) worst = a.errors[o];
  }
  if (!worst) return;
  ++count.wrong;
  count.add_wrong(*worst, Cause::unknown);
}

SweepCount& SweepCount::operator+=(const SweepCount& other) {
  count += other.count;
  due_hits += other.due_hits;
  mesh_rays += other.mesh_rays;
  parity_judged += other.parity_judged;
  for (std::size_t i = 0; i < of.size(); ++i) {
    of[i] += other.of[i];
    plain[i] += other.plain[i];
  }
  return *this;
}

std::uint64_t SweepCount::chances(SweptOutcome o) const {
  const bool is_of_mesh = std::ranges::find(mesh_outcomes, o) != mesh_outcomes.end();
  if (mesh_rays > 0) return o == SweptOutcome::parity ? parity_judged : is_of_mesh ? mesh_rays : 0;
  switch (o) {
    case SweptOutcome::false_hit:
      return count.judged() - due_hits;
    case SweptOutcome::false_miss:
      return due_hits;
    case SweptOutcome::wrong_contact:
    case SweptOutcome::fault:
      return count.judged();
    case SweptOutcome::refused:
      return count.judged() + count.refused;
    default:
      return 0;
  }
}

void Sweep::note(const SweepPlace& place, SweptOutcome outcome, const Witness& witness) {
  const auto [entry, fresh] = witnesses.try_emplace({place, outcome}, witness);
  if (!fresh && witness.k < entry->second.k) entry->second = witness;
}

Sweep& Sweep::operator+=(const Sweep& other) {
  for (const auto& [place, c] : other.counts) counts[place] += c;
  for (const auto& [key, witness] : other.witnesses) note(key.first, key.second, witness);
  audited += other.audited;
  return *this;
}

bool takes(const Method& method, const StressAxis& axis) {
  const Probes& probes = method.contract.probes;
  if (!(probes.rays || (axis.has_segments() && probes.segments))) return false;
  if (axis.operands == Operands::polygons) return static_cast<bool>(method.polygon);
  return method.contract.triangles != Triangles::none;
}

Sweep sweep(const SweepPlan& plan) {
  Sweep result;
  for (std::size_t axis = 0; axis < plan.axes.size(); ++axis) {
    if (plan.axes[axis]->is_of_mesh()) {
      plan.of_mesh->run(plan, axis, result);
    } else {
      sweep_axis(plan, axis, result);
    }
  }
  return result;
}

}  // namespace tribunal
