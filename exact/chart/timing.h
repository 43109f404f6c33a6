// Time per test, of many methods on the same pairs.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/method.h"

namespace tribunal {

/// Nanoseconds per pair over the repetitions, nothing subtracted.
struct Timing {
  std::uint64_t batch = 0;  ///< pairs in one repetition: a prefix of all
  int repetitions = 0;
  double min = 0, lower_quartile = 0, median = 0, upper_quartile = 0, max = 0;
};

/// One Timing a loop. Each repetition times a pass of every loop in turn, so that a change of the machine's speed meets
/// all of them. A slow loop gets a shorter pass, of whole rounds of `round` pairs where there are as many. Throws
/// std::logic_error if a pass answers otherwise than the one before.
std::vector<Timing> time_loops(std::span<const NativeLoop> loops, std::span<const SegmentPair> pairs, std::size_t round,
                               int repetitions);

/// The method's loops of these probes.
const NativeLoops& loops_of(const Method& method, ProbeKind kind);

/// The method's own loop of single tests, or one that calls its `segment`, or its `ray`, for each pair.
NativeLoop single_loop(const Method& method, ProbeKind kind = ProbeKind::segment);

/// The part of `prepared` that prepares, and the part that asks. The method has both.
NativeLoop set_up_loop(const Method& method);
NativeLoop prepared_loop(const Method& method, ProbeKind kind = ProbeKind::segment);

/// What a clock shows of a test that does nothing: in a loop of its own, and as a C function, asked through a pointer
/// as a plugin's is.
NativeLoop empty_loop();
NativeLoop empty_call_loop();

/// The quartiles of the samples, of which there must be at least one.
Timing summarise(std::vector<double> nanoseconds);

}  // namespace tribunal
