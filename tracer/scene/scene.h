// A scene as its file describes it. The file format is documented in read_scene.h.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "exact/mesh/mesh.h"
#include "tracer/image/colour.h"

namespace tribunal {

/// Pixels that a picture may have, on a side and in all.
inline constexpr int max_side = 16384;
inline constexpr long max_pixels = 1L << 26;

/// Pinhole camera. The picture is `view_height` high at unit distance from the eye; pixels are square.
struct Camera {
  Point3 eye{}, look_at{}, up{};
  double view_height = 0;
  int width = 0, height = 0;
};

/// Phong's and Whitted's coefficients, all in 0..1 but the exponent `shininess` ≥ 0 and the refractive index > 0
/// (of the inside, against 1 outside; the inside is where the faces' normals point away from).
struct Material {
  Colour colour{0.8, 0.8, 0.8};
  double ambient = 0.1, diffuse = 0.7, specular = 0.2, shininess = 20;
  double reflection = 0, transparency = 0, refractive_index = 1;
};

struct Solid {
  std::string name;
  Mesh mesh;
  Material material;
};

/// Pairs of flaps: on each axis, only points between two planes at right angles to it are lit. Unbounded where not
/// given.
struct Flaps {
  Point3 lo{-std::numeric_limits<double>::infinity()};
  Point3 hi{std::numeric_limits<double>::infinity()};
};

/// A point light without attenuation, directed as Warn's: its light falls off as the `concentration`-th power of the
/// cosine of the angle to its aim, ends at the cone, and only reaches points between the flaps.
/// Source: Warn, "Lighting controls for synthetic images", SIGGRAPH 1983.
struct Light {
  Point3 position;
  Colour colour;
  std::optional<Point3> aim{};  ///< the point that it shines at; if none, it shines equally in all directions
  double concentration = 0;     ///< exponent ≥ 0
  double cone_cosine = -1;      ///< cosine of the cone's half angle; −1 for no cone
  Flaps flaps{};
};

struct Scene {
  std::string file;  ///< the file that it was read from, for messages
  Camera camera;
  std::vector<Solid> solids;
  std::vector<Light> lights;
  Colour background;
  int depth = 4;          ///< generations of rays: 1 = primary rays and their shadow rays only
  double bias = 0x1p-16;  ///< relative step of inexact methods' secondary rays, see tracer/shading/departure.h
};

}  // namespace tribunal
