// The Segura–Feito test on floating-point kernels: the methods on trial.
#pragma once

#include "core/method.h"

namespace tribunal {

Method sf_float();
Method sf_double();
Method sf_double_eps();

}  // namespace tribunal
