// A scene for POV-Ray, so that an independent renderer can draw it.
#pragma once

#include <string>

#include "tracer/render/render.h"

namespace tribunal {

/// The world as a scene description for POV-Ray 3.7 that gives the same rays through the same pixels: the camera by
/// its vectors, all faces as triangles (the world must be made triangulated), numbers with 17 digits. Colours are
/// similar but not equal: POV-Ray shades by other rules, and flaps are left out. With `Declare=Ids=1` each solid is
/// drawn in the flat grey level 1 + its number and nothing else is drawn; compare `ids_image`.
std::string to_pov(const World& world, int depth);

/// The solid that the ray of each pixel hits first: grey level 1 + its number, 0 for none. Only the first 255 solids
/// have levels of their own.
Image ids_image(const World& world, const Method& method);

}  // namespace tribunal
