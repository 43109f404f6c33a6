#include "tracer/pov/export_pov.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

std::string formatted(const char* format, auto... values) {
  char line[400];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

std::string vector(const Point3& v) { return formatted("<%.17g, %.17g, %.17g>", v.x, v.y, v.z); }

std::string rgb(const Colour& c) { return formatted("rgb <%.17g, %.17g, %.17g>", c.r, c.g, c.b); }

int level_of(std::uint32_t solid) { return 1 + static_cast<int>(solid % 255); }

/// POV-Ray casts location + direction + x·right + y·up with x, y in (−½, ½): our picture plane at unit distance.
std::string camera_text(const Camera& c) {
  const CameraRays rays(c);
  const double width = c.view_height * c.width / c.height;
  return "camera { perspective location " + vector(c.eye) + " direction " + vector(rays.forward()) + " right " +
         vector(width * rays.right()) + " up " + vector(c.view_height * rays.up()) + " }\n";
}

std::string light_text(const Light& light) {
  std::string text = "light_source { " + vector(light.position) + " color " + rgb(light.colour);
  if (light.aim) {
    const double cone = std::acos(light.cone_cosine) * (180 / std::numbers::pi);
    text += " spotlight point_at " + vector(*light.aim) +
            formatted(" radius %.17g falloff %.17g tightness %.17g", cone, cone, light.concentration);
  }
  return text + " }\n";
}

std::string material_text(const Material& m, std::uint32_t solid) {
  return "#ifdef (Ids) pigment { rgb " + formatted("%d/255", level_of(solid)) +
         " } finish { ambient 1 diffuse 0 }\n#else pigment { " + rgb(m.colour) +
         formatted(
             " transmit %.17g } finish { ambient %.17g diffuse %.17g phong %.17g phong_size %.17g reflection %.17g }",
             m.transparency, m.ambient, m.diffuse, m.specular, m.shininess, m.reflection) +
         formatted(" interior { ior %.17g }\n#end\n", m.refractive_index);
}

/// POV-Ray drops triangles without area itself.
std::string mesh_text(const World& world, std::uint32_t& id) {
  const std::uint32_t solid = world.solid_of[id];
  std::string text = "// " + std::to_string(solid) + "\nmesh {\n";
  for (; id < world.triangles.size() && world.solid_of[id] == solid; ++id) {
    const Triangle& t = world.triangles[id];
    text += "triangle { " + vector(t.a) + ", " + vector(t.b) + ", " + vector(t.c) + " }\n";
  }
  return text + material_text(world.scene->solids[solid].material, solid) + "}\n";
}

}  // namespace

std::string to_pov(const World& world, int depth) {
  const Scene& scene = *world.scene;
  std::string text = "#version 3.7;\nglobal_settings { assumed_gamma 1 " + formatted("max_trace_level %d", depth) +
                     " }\n" + camera_text(scene.camera) + "#ifndef (Ids)\nbackground { " + rgb(scene.background) +
                     " }\n";
  for (const Light& light : scene.lights) text += light_text(light);
  text += "#end\n";
  for (std::uint32_t id = 0; id < world.triangles.size();) text += mesh_text(world, id);
  return text;
}

Image ids_image(const World& world, const Method& method) {
  const Camera& c = world.scene->camera;
  const CameraRays camera(c);
  RayTally uncounted;
  Visibility eye(world, method, uncounted);
  Image image(c.width, c.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const int pixel = static_cast<int>(i);
    const Ray wanted = camera.through(pixel % c.width, pixel / c.width);
    const auto id = eye.first_hit({in_format(wanted.o, world.format), {in_format(wanted.d.v, world.format)}});
    if (id) image.pixels[i].fill(static_cast<std::uint8_t>(level_of(world.solid_of[*id])));
  }
  return image;
}

}  // namespace tribunal
