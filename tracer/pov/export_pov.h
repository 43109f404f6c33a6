// A scene for POV-Ray, so that an independent renderer can draw it.
#pragma once

#include <string>

#include "tracer/render/render.h"

namespace tribunal {

/// The world as a scene description for POV-Ray 3.7, the same rays through the same pixels: camera by its vectors, all
/// faces as triangles (so make the world triangulated), numbers with 17 digits. Colours are alike but not the same:
/// POV-Ray shades by other rules, and flaps are left out. With `Declare=Ids=1` each solid has the flat grey
/// level 1 + its number, and nothing else shows; compare `ids_image`.
std::string to_pov(const World& world, int depth);

/// The solid that each pixel sees first: grey level 1 + its number, 0 for none. At most 255 solids are told apart.
Image ids_image(const World& world, const Method& method);

}  // namespace tribunal
