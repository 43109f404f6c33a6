// The certified test as a row of the table of methods.
#pragma once

#include "core/method.h"

namespace tribunal {

Method sf_filtered();

}  // namespace tribunal
