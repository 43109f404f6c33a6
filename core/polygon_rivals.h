// The classical tests of polygons as methods, each in binary32 and binary64.
#pragma once

#include "core/method.h"

namespace tribunal {

/// Plane intersection, then inclusion by crossing count.
Method haines_float();
Method haines_double();

/// Plane intersection, then inclusion by signed triangles.
Method feito_float();
Method feito_double();

}  // namespace tribunal
