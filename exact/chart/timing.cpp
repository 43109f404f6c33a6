#include "exact/chart/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace tribunal {
namespace {

using Pairs = std::span<const SegmentPair>;

/// Short against the slices in which a busy machine hands out its cores, so that most passes run undisturbed.
constexpr double pass_nanoseconds = 5e5;

/// A loop over a prefix of the pairs, with its samples so far.
class Track {
 public:
  Track(const NativeLoop& loop, Pairs pairs) : run_(loop(pairs)), hits_(pairs.size()) {}

  /// Nanoseconds per pair of one pass.
  double pass() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    step_ = next_step(step_, hits_.size());
    run_(hits_, step_);
    const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
    return elapsed.count() / static_cast<double>(hits_.size());
  }

  /// The first pass brings the data back into the cache, from which other loops have driven them.
  void sample() {
    pass();
    samples_.push_back(pass());
    const auto count = std::accumulate(hits_.begin(), hits_.end(), std::uint64_t{0});
    if (samples_.size() > 1 && count != count_) throw std::logic_error("the same pairs are answered differently");
    count_ = count;
  }

  Timing timing() const {
    Timing timing = summarise(samples_);
    timing.batch = hits_.size();
    return timing;
  }

 private:
  NativeRun run_;
  std::vector<std::uint8_t> hits_;
  std::size_t step_ = 0;
  std::uint64_t count_ = 0;
  std::vector<double> samples_{};
};

/// Its pass takes about the time that every loop's takes; the first pass also warms caches up.
Pairs prefix_for(const NativeLoop& loop, Pairs pairs, std::size_t round) {
  const std::size_t few = std::min(round, pairs.size());
  Track track(loop, pairs.first(few));
  track.pass();
  const double affordable = pass_nanoseconds / track.pass();
  const auto wanted = static_cast<std::size_t>(std::min(affordable, static_cast<double>(pairs.size())));
  return pairs.first(std::clamp(wanted / round * round, few, pairs.size()));
}

/// Linear interpolation between order statistics.
double quantile(const std::vector<double>& sorted, double q) {
  const double place = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

extern "C" int answers_no_hit(int, const double*) { return 0; }

/// Volatile, so that no compiler looks behind it.
int (*volatile const empty_function)(int, const double*) = answers_no_hit;

}  // namespace

Timing summarise(std::vector<double> nanoseconds) {
  std::ranges::sort(nanoseconds);
  const auto at = [&](double q) { return quantile(nanoseconds, q); };
  return {0, static_cast<int>(nanoseconds.size()), at(0), at(0.25), at(0.5), at(0.75), at(1)};
}

std::vector<Timing> time_loops(std::span<const NativeLoop> loops, Pairs pairs, std::size_t round, int repetitions) {
  std::vector<Track> tracks;
  for (const NativeLoop& loop : loops) tracks.emplace_back(loop, prefix_for(loop, pairs, round));
  for (int i = 0; i < repetitions; ++i) {
    for (Track& track : tracks) track.sample();
  }
  std::vector<Timing> timings;
  for (const Track& track : tracks) timings.push_back(track.timing());
  return timings;
}

const NativeLoops& loops_of(const Method& method, ProbeKind kind) {
  return kind == ProbeKind::segment ? method.native : method.native_rays;
}

NativeLoop single_loop(const Method& method, ProbeKind kind) {
  if (const NativeLoop& own = loops_of(method, kind).single) return own;
  if (kind == ProbeKind::ray) {
    return native_ray_loops([&method](const Ray& r, const Triangle& t) { return method.ray(r, t).hit; }).single;
  }
  return native_loops([&method](const Segment& s, const Triangle& t) { return method.segment(s, t).hit; }).single;
}

NativeLoop set_up_loop(const Method& method) {
  return [&method](Pairs pairs) -> NativeRun {
    return [prepared = method.native.prepared(pairs)](std::span<std::uint8_t>, std::size_t) { prepared.set_up(); };
  };
}

NativeLoop prepared_loop(const Method& method, ProbeKind kind) {
  return [loops = &loops_of(method, kind)](Pairs pairs) { return loops->prepared(pairs).ask; };
}

NativeLoop empty_loop() {
  return native_loops([](const Segment&, const Triangle&) { return false; }).single;
}

NativeLoop empty_call_loop() {
  return native_loops([](const Segment& s, const Triangle&) { return empty_function(0, &s.p.x) != 0; }).single;
}

}  // namespace tribunal
