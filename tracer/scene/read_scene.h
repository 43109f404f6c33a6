// Scene files.
//
// A scene is one JSON object. Numbers are JSON numbers or C99 hex-float strings ("0x1.8p+1"); both are read
// exactly rounded. Points, directions and colours are arrays of three. Unknown keys are errors.
//
//   "description"  text for people (optional)
//   "camera"       object, required:
//     "eye", "look_at", "up"   points and a direction; the eye must not be at look_at, nor up along the view
//     "fov"                    vertical field of view in degrees, between 0 and 180; or instead, exactly,
//     "view_height"            height of the picture at unit distance, > 0  (2·tan(fov/2))
//     "width", "height"        pixels, 1 to 16384 each and at most 2^26 in all
//   "solids"       array, at least one; each an object:
//     "name"                   text (optional; "solid N" otherwise)
//     "mesh"                   path of an .off, .obj, .ply or .stl file, relative to the scene file; or
//     "solid"                  path of a solid, a JSON object with "description", "vertices" and "faces"; or instead
//     "vertices", "faces"      inline: array of points; array of faces, each a ring of at least 3 vertex indices
//                              from 0, or an array of such rings: the outer one and the holes
//     "scale"                  number ≠ 0, or three of them, applied first (optional)
//     "translate"              point, added after scaling (optional); each operation rounds once to binary64
//     "colour"                 0..1 each (0.8, 0.8, 0.8)
//     "ambient", "diffuse", "specular", "reflection", "transparency"   0..1 (0.1, 0.7, 0.2, 0, 0)
//     "shininess"              0..10000, Phong's exponent (20)
//     "refractive_index"       > 0 (1), of the inside
//   "lights"       array (optional); each an object:
//     "position", "colour"     a point; 0 or more each (white)
//     "aim"                    the point that it shines at (none: equally in all directions); only with it:
//     "concentration"          exponent of the cosine of the angle to the aim, 0..10000 (0)
//     "cone"                   half angle beyond which there is no light, degrees (180)
//     "flaps"                  {"x": [lo, hi], …}: only points between these planes are lit (everywhere)
//   "background"   colour of rays that leave the scene, 0..1 each (black)
//   "depth"        generations of rays, 1 to 16 (4)
//   "bias"         relative step by which an inexact method's secondary rays leave a surface, 0 to 0.01 (2^-16)
//
// Faces should be counter-clockwise seen from outside, as refraction needs to know the inside.
#pragma once

#include <string>

#include "exact/base/json.h"
#include "tracer/scene/scene.h"

namespace tribunal {

/// Reads the scene in this file and its meshes. Fails with Exit::bad_input and a message of one line, which names the
/// line of text that is not JSON, or else the place in the object (`scene.json: solids[1].colour: …`).
Scene read_scene(const std::string& path);

/// The same from text; meshes are looked for relative to `path`.
Scene parse_scene(const std::string& text, const std::string& path);

/// Refuses a camera whose view and up are parallel up to 2⁻⁴⁰: their cross product, from which the frame is built,
/// would be mostly rounding error.
void require_frame(const Camera& camera, const Where& where);

}  // namespace tribunal
