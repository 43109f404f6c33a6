// The exact answer to a case of triangles by three formulations on integers, which must agree.
#pragma once

#include "exact/trial/truth.h"

namespace tribunal {

/// The exact answer to a query about a triangle.
using TruthBy = Truth (*)(const Query&);

/// By the signs' class, by the Segura–Feito decision and by Carathéodory's theorem, on the narrowest integers that hold
/// the operands; GMP's where none of fixed width does. Ends the run where two of the three differ. Rays with bounds: by
/// exact_truth.
Truth truth_by_formulations(const Query& query);

/// Who they are, for reports.
const char* formulations_in_words();

/// By the formulations, and it must be what the construction proves; where a case knows its class, by that alone, but
/// for one case in 257, as in truth_of. `needs_facing`: else it may be left unsaid.
Truth formulated_truth(const Trial& trial, std::uint64_t k, bool needs_facing, TruthBy formulations);

/// By all of exact_truth, with which the formulations must agree, whether or not a case knows its class; else the run
/// ends with Exit::oracles_contradict.
Truth audited_by_oracles(const Trial& trial, TruthBy formulations);

/// The exact answer to case `number` of a file from elsewhere, of finite operands: of a triangle by the formulations,
/// and of one case in 256, drawn by a hash, by all of exact_truth too; else by exact_truth.
Truth truth_of_own(const Query& query, std::uint64_t number);

/// Who they are, for reports.
const char* judges_of_own(Operands operands);

}  // namespace tribunal
