// The table of all families.
#pragma once

#include <span>
#include <string_view>

#include "exact/cases/families/family.h"

namespace tribunal {

/// All families of cases with these operands.
std::span<const Family> families_of(Operands operands);

/// The family of this name, of triangles or of polygons; nullptr if there is none.
const Family* find_family(std::string_view name);

}  // namespace tribunal
