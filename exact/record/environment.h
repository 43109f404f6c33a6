// What a result was made with.
#pragma once

#include "exact/base/json_fwd.h"

namespace tribunal {

/// Program version and revision, compiler, flags, processor, library versions.
Json environment();

}  // namespace tribunal
