// The stress axis "size of the mesh seen from afar": rays at the vertices, edges and faces of a closed mesh.
#pragma once

#include "exact/mesh/mesh.h"
#include "exact/sweep/sweep.h"

namespace tribunal {

inline constexpr std::string_view afar_name = "afar";
inline constexpr std::string_view afar_quantity = "distance of a ray's source over the size of a closed mesh (log2)";

/// The axis for this mesh, of triangles; `name` is for people. Values begin at the mesh and end where the whole mesh is
/// seen within rounding, so that nothing is a leak any more. Fails with Exit::bad_input if the mesh is not closed, or
/// is not within binary32 at its distances.
MeshAxis afar_axis(Mesh mesh, const std::string& name);

/// The axis for the mesh in this file; for a torus of the program's own if the name is empty.
MeshAxis afar_axis_of_file(const std::string& file);

}  // namespace tribunal
