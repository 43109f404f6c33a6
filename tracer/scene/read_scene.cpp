#include "tracer/scene/read_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/record.h"
#include "exact/base/shown.h"
#include "exact/mesh/read_mesh.h"

namespace tribunal {
namespace {

constexpr double huge = std::numeric_limits<double>::max();

double number_in(const Json& value, double lo, double hi, const Where& where) {
  const double x = to_number(value, Format::binary64, where);
  if (!(x >= lo && x <= hi)) {
    const std::string range =
        hi < huge ? "in " + Json(lo).dump() + ".." + Json(hi).dump() : "at least " + Json(lo).dump();
    where.fail("expected a number " + range + ", found " + value.dump());
  }
  return x;
}

int integer_in(const Json& value, int lo, int hi, const Where& where) {
  const double x = number_in(value, lo, hi, where);
  if (x != std::floor(x)) where.fail("expected a whole number, found " + value.dump());
  return static_cast<int>(x);
}

Point3 point_at(const Json& object, const char* key, const Where& where) {
  return to_point(require(object, key, where), Format::binary64, where.key(key));
}

/// Reads a number into x, if the object has it; else x keeps its default.
void read_number(const Json& object, const char* key, double lo, double hi, double& x, const Where& where) {
  if (object.contains(key)) x = number_in(object[key], lo, hi, where.key(key));
}

void read_colour(const Json& object, const char* key, double hi, Colour& c, const Where& where) {
  if (!object.contains(key)) return;
  const Json& value = object[key];
  const Where here = where.key(key);
  const std::string range = hi < huge ? "three numbers in 0..1" : "three numbers, 0 or more";
  if (!value.is_array() || value.size() != 3) here.fail("expected " + range + ", found " + value.dump());
  double channels[3];
  for (std::size_t i = 0; i < 3; ++i) {
    channels[i] = to_number(value[i], Format::binary64, here.index(i));
    if (!(channels[i] >= 0 && channels[i] <= hi)) here.fail("expected " + range + ", found " + value.dump());
  }
  c = {channels[0], channels[1], channels[2]};
}

std::string text_at(const Json& value, const Where& where) { return Record(value, where).text(); }

const Json& array_at(const Json& object, const char* key, const Where& where) {
  const Json& value = require(object, key, where);
  if (!value.is_array()) where.key(key).fail("expected an array");
  return value;
}

// --- camera ----------------------------------------------------------------------------------------------------

/// v divided by the magnitude of its largest coordinate, so that no product below overflows or underflows.
Point3 scaled_to_one(const Point3& v) {
  const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  return size > 0 ? Point3(v.x / size, v.y / size, v.z / size) : v;
}

double view_height_of(const Json& object, const Where& where) {
  if (object.contains("fov") == object.contains("view_height")) {
    where.fail("expected either \"fov\" in degrees or \"view_height\" at unit distance");
  }
  if (object.contains("fov")) {
    const double degrees = number_in(object["fov"], 0, 180, where.key("fov"));
    if (!(degrees > 0 && degrees < 180)) where.key("fov").fail("expected degrees between 0 and 180, exclusive");
    return 2 * std::tan(degrees * (std::numbers::pi / 360));
  }
  const double height = number_in(object["view_height"], 0, 1e6, where.key("view_height"));
  if (height == 0) where.key("view_height").fail("expected a number greater than 0");
  return height;
}

Camera to_camera(const Json& object, const Where& where) {
  require_keys(object, {"eye", "look_at", "up", "fov", "view_height", "width", "height"}, where);
  Camera c;
  c.eye = point_at(object, "eye", where);
  c.look_at = point_at(object, "look_at", where);
  c.up = point_at(object, "up", where);
  c.view_height = view_height_of(object, where);
  c.width = integer_in(require(object, "width", where), 1, max_side, where.key("width"));
  c.height = integer_in(require(object, "height", where), 1, max_side, where.key("height"));
  if (static_cast<long>(c.width) * c.height > max_pixels) where.fail("expected at most 2^26 pixels in all");
  require_frame(c, where);
  return c;
}

// --- solids ----------------------------------------------------------------------------------------------------

std::vector<std::uint32_t> to_ring(const Json& value, std::size_t vertices, const Where& where) {
  if (!value.is_array() || value.size() < 3) where.fail("expected an array of at least 3 vertex indices");
  std::vector<std::uint32_t> ring;
  for (std::size_t i = 0; i < value.size(); ++i) {
    ring.push_back(static_cast<std::uint32_t>(Record(value[i], where.index(i)).count(vertices - 1)));
  }
  return ring;
}

/// Reads a face: a ring, or a list of rings, of which the first is the outer one and the others are holes.
Rings to_face(const Json& value, std::size_t vertices, const Where& where) {
  if (!value.is_array() || value.empty() || !value[0].is_array()) return {to_ring(value, vertices, where)};
  Rings face;
  for (std::size_t i = 0; i < value.size(); ++i) face.push_back(to_ring(value[i], vertices, where.index(i)));
  return face;
}

/// Reads "vertices" and "faces", of a solid in a scene or of a file in data/solids.
Mesh to_solid_mesh(const Json& object, const Where& where) {
  Mesh mesh;
  const Json& vertices = array_at(object, "vertices", where);
  const Json& faces = array_at(object, "faces", where);
  if (vertices.empty()) where.key("vertices").fail("expected at least one point");
  if (faces.empty()) where.key("faces").fail("expected at least one face");
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    mesh.vertices.push_back(to_point(vertices[i], Format::binary64, where.key("vertices").index(i)));
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    Rings face = to_face(faces[i], vertices.size(), where.key("faces").index(i));
    if (face.size() == 1 && face[0].size() == 3) {
      mesh.triangles.push_back({face[0][0], face[0][1], face[0][2]});
    } else {
      mesh.polygons.push_back(std::move(face));
    }
  }
  return mesh;
}

Mesh read_solid(const std::string& path) {
  const std::string text = read_file(path, std::size_t{1} << 30);
  if (text.empty()) throw bad_input(path, 0, "is empty, expected a solid");
  const Where where{path};
  const Json object = parse_json(text, where);
  require_keys(object, {"description", "vertices", "faces"}, where);
  if (object.contains("description")) text_at(object["description"], where.key("description"));
  return to_solid_mesh(object, where);
}

Mesh to_mesh(const Json& object, const Where& where) {
  if (object.contains("mesh") + object.contains("solid") + object.contains("vertices") != 1) {
    where.fail("expected either \"mesh\", \"solid\", or \"vertices\" and \"faces\"");
  }
  if (object.contains("vertices")) return to_solid_mesh(object, where);
  const char* const key = object.contains("mesh") ? "mesh" : "solid";
  if (object.contains("faces")) where.key("faces").fail("expected no faces beside \"" + std::string(key) + "\"");
  const std::string name = text_at(object[key], where.key(key));
  if (!shows_as_it_is(name)) where.key(key).fail("expected the name of a file, found " + object[key].dump());
  const std::string path = (std::filesystem::path(where.file).parent_path() / std::filesystem::path(name)).string();
  return object.contains("mesh") ? read_mesh(path) : read_solid(path);
}

Point3 scale_of(const Json& object, const Where& where) {
  if (!object.contains("scale")) return Point3(1);
  const Json& value = object["scale"];
  const Where here = where.key("scale");
  const Point3 s =
      value.is_array() ? to_point(value, Format::binary64, here) : Point3(to_number(value, Format::binary64, here));
  if (s.x == 0 || s.y == 0 || s.z == 0) here.fail("expected numbers other than 0");
  return s;
}

/// Scales the mesh, then translates it. If the scaling mirrors it, the faces are reversed, so that their normals keep
/// pointing outward.
void place(const Json& object, Mesh& mesh, const Where& where) {
  const Point3 scale = scale_of(object, where);
  const Point3 shift = object.contains("translate") ? point_at(object, "translate", where) : Point3(0);
  for (Point3& v : mesh.vertices) {
    v = v * scale + shift;
    if (!is_finite(v)) where.fail("scale and translate leave binary64, expected finite vertices");
  }
  const bool mirrored = ((scale.x < 0) != (scale.y < 0)) != (scale.z < 0);
  if (!mirrored) return;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  for (Rings& face : mesh.polygons) {
    for (auto& ring : face) std::reverse(ring.begin() + 1, ring.end());
  }
}

Material to_material(const Json& object, const Where& where) {
  Material m;
  read_colour(object, "colour", 1, m.colour, where);
  read_number(object, "ambient", 0, 1, m.ambient, where);
  read_number(object, "diffuse", 0, 1, m.diffuse, where);
  read_number(object, "specular", 0, 1, m.specular, where);
  read_number(object, "shininess", 0, 10000, m.shininess, where);
  read_number(object, "reflection", 0, 1, m.reflection, where);
  read_number(object, "transparency", 0, 1, m.transparency, where);
  read_number(object, "refractive_index", 0, 1000, m.refractive_index, where);
  if (m.refractive_index == 0) where.key("refractive_index").fail("expected a number greater than 0");
  return m;
}

Solid to_solid(const Json& object, std::size_t number, const Where& where) {
  require_keys(object,
               {"name", "mesh", "solid", "vertices", "faces", "scale", "translate", "colour", "ambient", "diffuse",
                "specular", "shininess", "reflection", "transparency", "refractive_index"},
               where);
  Solid s;
  s.name =
      object.contains("name") ? shown(text_at(object["name"], where.key("name"))) : "solid " + std::to_string(number);
  s.material = to_material(object, where);
  s.mesh = to_mesh(object, where);
  place(object, s.mesh, where);
  return s;
}

/// Reads flaps from {"x": [lo, hi], …} with any of the three axes.
Flaps to_flaps(const Json& object, const Where& where) {
  require_keys(object, {"x", "y", "z"}, where);
  Flaps flaps;
  for (const int axis : {0, 1, 2}) {
    const std::string key(1, "xyz"[axis]);
    if (!object.contains(key)) continue;
    const Json& pair = object[key];
    const Where here = where.key(key);
    if (!pair.is_array() || pair.size() != 2) here.fail("expected two numbers, found " + pair.dump());
    flaps.lo[axis] = to_number(pair[0], Format::binary64, here.index(0));
    flaps.hi[axis] = to_number(pair[1], Format::binary64, here.index(1));
    if (flaps.lo[axis] > flaps.hi[axis]) here.fail("expected the lesser number first, found " + pair.dump());
  }
  return flaps;
}

Light to_light(const Json& object, const Where& where) {
  require_keys(object, {"position", "colour", "aim", "concentration", "cone", "flaps"}, where);
  Light light{point_at(object, "position", where), {1, 1, 1}};
  read_colour(object, "colour", huge, light.colour, where);
  if (object.contains("flaps")) light.flaps = to_flaps(object["flaps"], where.key("flaps"));
  if (object.contains("aim")) light.aim = point_at(object, "aim", where);
  if (light.aim && *light.aim == light.position) where.key("aim").fail("expected another point than the position");
  for (const char* key : {"concentration", "cone"}) {
    if (object.contains(key) && !light.aim) where.key(key).fail("expected \"aim\" with it");
  }
  read_number(object, "concentration", 0, 10000, light.concentration, where);
  double degrees = 180;
  read_number(object, "cone", 0, 180, degrees, where);
  if (degrees < 180) light.cone_cosine = std::cos(degrees * (std::numbers::pi / 180));
  return light;
}

Scene to_scene(const Json& object, const Where& where) {
  require_keys(object, {"description", "camera", "solids", "lights", "background", "depth", "bias"}, where);
  Scene scene;
  scene.file = where.file;
  scene.camera = to_camera(require(object, "camera", where), where.key("camera"));
  read_colour(object, "background", 1, scene.background, where);
  if (object.contains("description")) text_at(object["description"], where.key("description"));
  if (object.contains("depth")) scene.depth = integer_in(object["depth"], 1, 16, where.key("depth"));
  read_number(object, "bias", 0, 0.01, scene.bias, where);
  const Json& solids = array_at(object, "solids", where);
  if (solids.empty()) where.key("solids").fail("expected at least one solid");
  for (std::size_t i = 0; i < solids.size(); ++i) {
    scene.solids.push_back(to_solid(solids[i], i, where.key("solids").index(i)));
  }
  if (!object.contains("lights")) return scene;
  const Json& lights = array_at(object, "lights", where);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    scene.lights.push_back(to_light(lights[i], where.key("lights").index(i)));
  }
  return scene;
}

}  // namespace

void require_frame(const Camera& c, const Where& where) {
  const Point3 view = c.look_at - c.eye;
  if (!is_finite(view)) where.fail("eye and look_at are too far apart");
  if (view == Point3(0)) where.fail("singular camera: expected look_at to differ from eye");
  if (c.up == Point3(0)) where.key("up").fail("singular camera: expected a direction, found [0,0,0]");
  const Point3 v = scaled_to_one(view), u = scaled_to_one(c.up);
  if (glm::length(glm::cross(v, u)) <= 0x1p-40 * glm::length(v) * glm::length(u)) {
    where.key("up").fail("singular camera: expected a direction that is not parallel to the view");
  }
}

Scene parse_scene(const std::string& text, const std::string& path) {
  const Where where{path};
  return to_scene(parse_json(text, where), where);
}

Scene read_scene(const std::string& path) {
  const std::string text = read_file(path, std::size_t{1} << 30);
  if (text.empty()) throw bad_input(path, 0, "is empty, expected a scene");
  return parse_scene(text, path);
}

}  // namespace tribunal
