// The exact answer to a case of triangles by one certified way, with a share of cases judged by the oracles as well.
#pragma once

#include <cstdint>

#include "exact/trial/truth.h"

namespace tribunal {

/// The class of a query about a triangle, with finite operands.
using ClassBy = ClassId (*)(const Query&);

/// By the signs of the filtered kernel, each of which is certain: a fraction of a microsecond where the oracles take
/// twenty.
ClassId certified_class(const Query& query);

/// One case in so many is judged by the oracles too.
inline constexpr std::uint64_t audit_period = 256;

/// A number that a case's seed, stream and number are mixed into.
std::uint64_t hash_of_case(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);

/// Whether this case is one of them: by a hash of its number, so that no class, level or kind of probe is left out or
/// preferred, as it would be by a stride.
bool is_audited(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);

/// How many of the first n cases of a stream are.
std::uint64_t audited_among(std::uint64_t seed, std::uint64_t stream, std::uint64_t n);

/// By construction where the case knows its class, else by `quick`. `facing` is left unsaid.
Truth quick_truth(const Trial& trial, ClassBy quick);

/// The same with `facing`, which only methods that cull turn on.
Truth quick_truth_with_facing(const Trial& trial, ClassBy quick);

/// The same with `facing`, after exact_truth, all of whose ways must agree with it and with each other; else the run
/// ends with Exit::oracles_contradict.
Truth audited_truth(const Trial& trial, ClassBy quick);

}  // namespace tribunal
