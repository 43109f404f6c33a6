// The published rivals, each in binary32 and binary64.
#pragma once

#include <vector>

#include "core/method.h"

namespace tribunal {

Method moeller_trumbore_float();
Method moeller_trumbore_double();

}  // namespace tribunal
