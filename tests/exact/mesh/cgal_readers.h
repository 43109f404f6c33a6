// CGAL's readers of meshes as a second opinion. This header includes no CGAL.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "exact/mesh/soup.h"

namespace tribunal::testing {

/// What CGAL reads from a file of this name with these bytes; nothing where it refuses. It accepts more than it should
/// (indices out of range, coordinates that are not finite) and allocates whatever a header announces.
std::optional<PolygonSoup> cgal_soup(const std::string& file, const std::string& bytes);

}  // namespace tribunal::testing
