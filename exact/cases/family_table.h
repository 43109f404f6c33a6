// The table of all families.
#pragma once

#include <span>
#include <string_view>

#include "exact/cases/families/family.h"

namespace tribunal {

/// All families of cases with these operands.
std::span<const Family> families_of(Operands operands);

/// Of either operands; nullptr if there is none of the name.
const Family* find_family(std::string_view name);

}  // namespace tribunal
