#include "exact/chart/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/certificate/bounds.h"

namespace tribunal {
namespace {

/// Short against the slices in which a busy machine hands out its cores, so that most passes run undisturbed.
constexpr double pass_nanoseconds = 5e5;

/// 480 KB of pairs: they fit a second-level cache. No power of two: columns a multiple of 4 KB apart would fight for
/// the same cache lines.
constexpr std::size_t most_at_once = 4000;

/// Cases that a test is asked before the clock runs, so that it knows its own code again, but not the cases to come.
constexpr std::size_t most_warming = 500;

/// Nanoseconds per case of one pass.
double pass(const NativeRun& run, std::span<std::uint8_t> hits) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  run(hits, 1);
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  return elapsed.count() / static_cast<double>(hits.size());
}

/// Equal parts of the population, which the repetitions take in turn, the same part for every test. They are as short
/// as it takes for each repetition to have its own and one to be left, on which tests are asked before their first
/// pass.
class Stretches {
 public:
  explicit Stretches(const TimedRun& run)
      : least_(std::min(run.round, run.cases)),
        length_(rounds(run, run.cases / (static_cast<std::size_t>(run.repetitions) + 1))),
        count_(run.cases / length_) {}

  std::size_t length() const { return length_; }
  std::size_t count() const { return count_; }
  std::size_t first_case(std::size_t i) const { return i % count_ * length_; }

  /// So many cases in whole rounds, and no more than a stretch has.
  std::size_t part(const TimedRun& run, double affordable) const {
    return std::min(length_, rounds(run, static_cast<std::size_t>(affordable)));
  }

 private:
  std::size_t rounds(const TimedRun& run, std::size_t n) const {
    return std::max(least_, std::min(n, most_at_once) / run.round * run.round);
  }

  std::size_t least_, length_, count_;
};

/// A test on one stretch after the other, or on the first cases of each, with its samples so far.
class Track {
 public:
  Track(const TimedTest& test, const TimedRun& run, const Stretches& stretches)
      : test_(test), stretches_(stretches), length_(length_for(test, run, stretches)) {}

  /// Before the clock runs the test is asked cases of the stretch before, whose time is taken already.
  void sample() {
    std::vector<std::uint8_t> hits(length_);
    const std::size_t i = samples_.size(), warming = std::min(length_, most_warming);
    const std::size_t first = stretches_.first_case(i), before = stretches_.first_case(i + stretches_.count() - 1);
    pass(test_(before, warming), std::span(hits).first(warming));
    samples_.push_back(pass(test_(first, length_), hits));
    const auto count = std::accumulate(hits.begin(), hits.end(), std::uint64_t{0});
    const auto [known, is_new] = hits_from_.try_emplace(first, count);
    if (!is_new && known->second != count) throw std::logic_error("the same pairs are answered differently");
  }

  const std::vector<double>& samples() const { return samples_; }

  Timing timing(const Track* yardstick) const {
    Timing timing = summarise(samples_);
    timing.batch = length_;
    timing.stretches = std::min(stretches_.count(), samples_.size());
    if (yardstick == nullptr) return timing;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < samples_.size(); ++i) ratios.push_back(samples_[i] / yardstick->samples_[i]);
    timing.ratio = median_of(ratios);
    return timing;
  }

 private:
  /// A pass takes about the time that every test's takes; the first pass warms caches up.
  static std::size_t length_for(const TimedTest& test, const TimedRun& run, const Stretches& stretches) {
    const std::size_t few = std::min(run.round, stretches.length());
    const NativeRun trial = test(stretches.first_case(stretches.count() - 1), few);
    std::vector<std::uint8_t> hits(few);
    pass(trial, hits);
    return stretches.part(run, std::min(pass_nanoseconds / pass(trial, hits), static_cast<double>(most_at_once)));
  }

  TimedTest test_;
  Stretches stretches_;
  std::size_t length_;
  std::vector<double> samples_{};
  std::map<std::size_t, std::uint64_t> hits_from_{};  ///< by the first case of a stretch
};

/// Linear interpolation between order statistics of sorted samples.
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
  return {0, 0, static_cast<int>(nanoseconds.size()), at(0), at(0.25), at(0.5), at(0.75), at(1), {}};
}

bool Median::has_interval() const { return std::isfinite(upper); }

Median median_of(std::vector<double> samples) {
  std::ranges::sort(samples);
  const double value = quantile(samples, 0.5);
  const std::size_t rank = median_rank(samples.size(), confidence_alpha);
  if (rank == 0) return {value, 0, std::numeric_limits<double>::infinity()};
  return {value, samples[rank - 1], samples[samples.size() - rank]};
}

std::vector<Timing> time_stretches(std::span<const TimedTest> tests, const TimedRun& run) {
  const Stretches stretches(run);
  std::vector<Track> tracks;
  for (const TimedTest& test : tests) tracks.emplace_back(test, run, stretches);
  for (int i = 0; i < run.repetitions; ++i) {
    for (Track& track : tracks) track.sample();
    fail_if_interrupted("no times");
  }
  std::vector<Timing> timings;
  for (const Track& track : tracks) timings.push_back(track.timing(run.yardstick ? &tracks[*run.yardstick] : nullptr));
  return timings;
}

TimedTest timed_test(const NativeLoop& loop, std::span<const SegmentPair> pairs) {
  return [loop, pairs](std::size_t first, std::size_t count) { return loop(pairs.subspan(first, count)); };
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
  return [&method](std::span<const SegmentPair> pairs) -> NativeRun {
    return [prepared = method.native.prepared(pairs)](std::span<std::uint8_t>, std::size_t) { prepared.set_up(); };
  };
}

NativeLoop prepared_loop(const Method& method, ProbeKind kind) {
  return [loops = &loops_of(method, kind)](std::span<const SegmentPair> pairs) { return loops->prepared(pairs).ask; };
}

NativeLoop empty_loop() {
  return native_loops([](const Segment&, const Triangle&) { return false; }).single;
}

NativeLoop empty_call_loop() {
  return native_loops([](const Segment& s, const Triangle&) { return empty_function(0, &s.p.x) != 0; }).single;
}

}  // namespace tribunal
