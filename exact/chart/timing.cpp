#include "exact/chart/timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace tribunal {
namespace {

using Cases = std::span<const SegmentCase>;

/// Short against the slices in which a busy machine hands out its cores, so that most batches run undisturbed.
constexpr double batch_nanoseconds = 5e5;

struct Lap {
  double nanoseconds;  ///< per test
  std::uint64_t hits;
};

/// The hits are used, so no compiler may leave a test out.
Lap run(const Method& method, Cases cases) {
  using Clock = std::chrono::steady_clock;
  std::uint64_t hits = 0;
  const Clock::time_point start = Clock::now();
  for (const SegmentCase& c : cases) hits += method.segment(c.segment, c.triangle).hit;
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - start;
  return {elapsed.count() / static_cast<double>(cases.size()), hits};
}

/// Its batch takes about the time that every method's takes; the first lap also warms caches up.
Cases batch_of(const Method& method, Cases cases, std::size_t round) {
  const std::size_t probe = std::min(round, cases.size());
  run(method, cases.first(probe));
  const double affordable = batch_nanoseconds / run(method, cases.first(probe)).nanoseconds;
  const auto wanted = static_cast<std::size_t>(std::min(affordable, static_cast<double>(cases.size())));
  return cases.first(std::clamp(wanted / round * round, probe, cases.size()));
}

/// Linear interpolation between order statistics.
double quantile(const std::vector<double>& sorted, double q) {
  const double place = q * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

/// One method's samples so far.
struct Track {
  const Method* method;
  Cases batch;
  std::uint64_t hits;
  std::vector<double> samples{};

  void lap() {
    const Lap l = run(*method, batch);
    if (l.hits != hits) throw std::logic_error(method->name + " answers the same cases differently each time");
    samples.push_back(l.nanoseconds);
  }
};

}  // namespace

Timing summarise(std::vector<double> nanoseconds) {
  std::ranges::sort(nanoseconds);
  const auto at = [&](double q) { return quantile(nanoseconds, q); };
  return {0, static_cast<int>(nanoseconds.size()), at(0), at(0.25), at(0.5), at(0.75), at(1)};
}

std::vector<Timing> time_methods(std::span<const Method* const> methods, Cases cases, std::size_t round,
                                 int repetitions) {
  std::vector<Track> tracks;
  for (const Method* m : methods) {
    const Cases batch = batch_of(*m, cases, round);
    tracks.push_back({m, batch, run(*m, batch).hits});
  }
  for (int i = 0; i < repetitions; ++i) {
    for (Track& track : tracks) track.lap();
  }
  std::vector<Timing> timings;
  for (const Track& track : tracks) {
    Timing timing = summarise(track.samples);
    timing.batch = track.batch.size();
    timings.push_back(timing);
  }
  return timings;
}

}  // namespace tribunal
