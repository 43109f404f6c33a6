// What is noted of the user's own data that a run was made from.
#pragma once

#include "exact/base/json_fwd.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// One object a file: its family, `file`, `sha256` of its bytes, `numbers_sha256`, how many `items`, and what is
/// `left_out`. Empty if the plan has none.
Json data_of(const FuzzPlan& plan);

/// Names of the families asked, each once, in the order of their streams.
Json family_names_of(const FuzzPlan& plan);

}  // namespace tribunal
