#include "tests/bench/paper/contenders.h"

#include <optional>
#include <vector>

#include "core/rivals/adapter.h"
#include "core/rivals/badouel.h"
#include "core/rivals/baldwin_weber.h"
#include "core/rivals/chirkov.h"
#include "core/rivals/jimenez.h"
#include "core/rivals/moeller_trumbore.h"
#include "tests/bench/paper/segura_feito.h"

namespace tribunal::bench {
namespace {

using Vector = Vec3<double>;

/// A published test of the shelf, each pair prepared anew.
template <class Rival>
struct Unprepared {
  using Prepared = published::Corners<double>;
  static Prepared prepare(const Prepared& corners) { return corners; }
  static std::optional<double> meet(const Vector& p, const Vector& q, const Prepared& corners) {
    const auto hit = published::meet_between<Rival>(p, q, published::prepared_of<Rival>(corners));
    return hit ? std::optional(hit->t) : std::nullopt;
  }
};

/// With what it keeps of a triangle in place.
template <class Rival>
struct Kept {
  using Prepared = typename Rival::Prepared;
  static Prepared prepare(const published::Corners<double>& corners) { return Rival::prepare(corners); }
  static std::optional<double> meet(const Vector& p, const Vector& q, const Prepared& t) {
    const auto hit = published::meet_between<Rival>(p, q, t);
    return hit ? std::optional(hit->t) : std::nullopt;
  }
};

template <class Test>
struct Laid {
  Vector p, q;
  typename Test::Prepared triangle;
};

template <class Test, bool wants_point>
Run run(std::span<const SegmentPair> pairs) {
  std::vector<Laid<Test>> laid;
  for (const SegmentPair& pair : pairs) {
    laid.push_back({lift<double>(pair.segment.p), lift<double>(pair.segment.q),
                    Test::prepare(published::corners_of<double>(pair.triangle))});
  }
  return [laid](std::size_t step) {
    Pass pass;
    visit_by_steps(laid.size(), step, [&](std::size_t i) {
      const std::optional<double> t = Test::meet(laid[i].p, laid[i].q, laid[i].triangle);
      pass.hits += t.has_value();
      if constexpr (wants_point) pass.parameters += t.value_or(0);
    });
    return pass;
  };
}

template <class Test>
constexpr Contender contender(const char* name) {
  return {name, run<Test, false>, run<Test, true>};
}

constexpr Contender contenders[] = {
    contender<TunedSeguraFeito>("sf"),
    contender<PreparedSeguraFeito>("sf_prepared"),
    contender<Unprepared<published::Jimenez<double>>>("jimenez"),
    contender<Unprepared<published::MoellerTrumbore<double>>>("mt"),
    contender<Unprepared<published::Badouel<double>>>("badouel"),
    contender<Kept<published::Badouel<double>>>("badouel_prepared"),
    contender<Unprepared<published::ChirkovUnprepared<double>>>("chirkov2"),
    contender<Kept<published::ChirkovPrepared<double>>>("chirkov3_prepared"),
    contender<Kept<published::BaldwinWeber<double>>>("baldwin_weber_prepared"),
};

}  // namespace
}  // namespace tribunal::bench

extern "C" __attribute__((visibility("default"))) std::span<const tribunal::bench::Contender> TRIBUNAL_CONTENDERS() {
  return tribunal::bench::contenders;
}
