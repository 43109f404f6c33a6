// The families of polygon cases, as rows of the table of families.
#pragma once

#include <span>

#include "exact/families/family.h"

namespace tribunal {

std::span<const Family> polygon_families();

}  // namespace tribunal
