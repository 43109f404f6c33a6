// The exact methods, each behind the one file that includes its library.
#pragma once

#include "core/method.h"

namespace tribunal {

Method sf_rational();
Method sf_epick();
Method sf_epeck();
Method sf_expansion();
Method cgal_epick();
Method cgal_epeck();

}  // namespace tribunal
