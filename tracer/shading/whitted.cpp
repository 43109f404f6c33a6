#include "tracer/shading/whitted.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "tracer/shading/camera_rays.h"
#include "tracer/shading/warn_light.h"

namespace tribunal {
namespace {

/// The normal that sees the corners counter-clockwise; zero for a face that rounds to no area. The edges are
/// normalised first where their product may leave the range of doubles.
Point3 face_normal(const Triangle& t) {
  const Point3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const double square = glm::dot(normal, normal);
  if (square > 0x1p-900 && square < 0x1p900) return normal / std::sqrt(square);
  return normalised(glm::cross(normalised(t.b - t.a), normalised(t.c - t.a)));
}

/// The hit point is in the face's box, so the computed one is moved there; a parameter that is not a number (a
/// method may report hits that no formula confirms) leads to the box's corner.
Point3 hit_point(const Ray& r, const Triangle& t, const Box& b) {
  const double parameter = shading_parameter(r, t);
  const Point3 p = r.o + parameter * r.d.v;
  Point3 inside = b.lo;
  for (int i = 0; i < 3; ++i) {
    if (p[i] > b.lo[i]) inside[i] = std::min(p[i], b.hi[i]);
  }
  return inside;
}

Point3 mirrored(const Point3& v, const Point3& normal) { return 2 * glm::dot(v, normal) * normal - v; }

/// One step of splitmix64, a bijection of the sum.
std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
  std::uint64_t z = hash + value + 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

std::optional<Point3> refract(const Point3& view, const Point3& normal, double eta) {
  const double cosine = glm::dot(view, normal);
  const double k = 1 - eta * eta * (1 - cosine * cosine);
  if (k < 0) return std::nullopt;
  return -eta * view + (eta * cosine - std::sqrt(k)) * normal;
}

std::uint64_t WhittedTracer::take_hash() { return std::exchange(hash_, 0); }

void WhittedTracer::note(RayKind kind, const Probe& probe, std::int64_t outcome, bool hit) {
  const auto k = static_cast<std::size_t>(kind);
  ++tally_.rays[k];
  tally_.ray_hits[k] += hit;
  hash_ = mixed(hash_, static_cast<std::uint64_t>(outcome));
  if (log_) log_->push_back({kind, probe, outcome});
}

Colour WhittedTracer::trace(const Ray& wanted, RayKind kind, int depth, std::uint32_t apart) {
  const Ray ray{in_format(wanted.o, world_.format), {in_format(wanted.d.v, world_.format)}};
  const std::optional<std::uint32_t> hit = visibility_.first_hit(ray, apart);
  note(kind, ray, hit ? std::int64_t{*hit} : -1, hit.has_value());
  return hit ? shade(surface_at(ray, *hit), depth) : world_.scene->background;
}

WhittedTracer::Surface WhittedTracer::surface_at(const Ray& ray, std::uint32_t id) const {
  const Triangle& t = world_.triangles[id];
  const Point3 view = normalised(-ray.d.v);
  const Point3 normal = face_normal(t);
  const bool from_outside = glm::dot(normal, view) >= 0;
  const Point3 facing = normal == Point3(0) ? view : from_outside ? normal : -normal;
  return {{ray.o, id, hit_point(ray, t, world_.box(id)), facing}, view, from_outside, world_.material_of(id)};
}

const Start& WhittedTracer::near_start(Surface& s) {
  if (!s.near) s.near = departures_.near_side(s.at);
  return *s.near;
}

Colour WhittedTracer::shade(Surface s, int depth) {
  const Material& m = s.material;
  Colour colour = m.ambient * m.colour;
  for (const Light& light : world_.scene->lights) colour += light_on(s, light);
  if (depth <= 1) return colour;
  if (m.reflection > 0) colour += m.reflection * reflected(s, depth);
  if (m.transparency > 0) colour += m.transparency * refracted(s, depth);
  return colour;
}

Colour WhittedTracer::light_on(Surface& s, const Light& light) {
  const Point3 to_light = normalised(light.position - s.at.point);
  const double cosine = glm::dot(to_light, s.at.normal);
  if (!(cosine > 0)) return {};
  const double strength = strength_at(light, s.at.point);
  if (!(strength > 0)) return {};
  const Start& start = near_start(s);
  const Segment way{start.point, in_format(light.position, world_.format)};
  const bool blocked = visibility_.is_blocked(way, departures_.left_behind(s.at, start, way.q));
  note(RayKind::shadow, way, blocked, blocked);
  if (blocked) return {};
  const Material& m = s.material;
  Colour colour = m.diffuse * cosine * (m.colour * light.colour);
  if (m.specular > 0) {
    const double shine = std::max(0.0, glm::dot(mirrored(to_light, s.at.normal), s.view));
    colour += m.specular * power(shine, m.shininess) * light.colour;
  }
  return strength * colour;
}

Colour WhittedTracer::reflected(Surface& s, int depth) {
  const Start& start = near_start(s);
  const Direction direction{in_format(mirrored(s.view, s.at.normal), world_.format)};
  return trace({start.point, direction}, RayKind::reflection, depth - 1,
               departures_.left_behind(s.at, start, direction));
}

/// Total internal reflection sends the refracted share back inside.
Colour WhittedTracer::refracted(Surface& s, int depth) {
  const double eta = s.from_outside ? 1 / s.material.refractive_index : s.material.refractive_index;
  const std::optional<Point3> direction = refract(s.view, s.at.normal, eta);
  if (!direction) return reflected(s, depth);
  const Point3 start = departures_.far_side(s.at, near_start(s).point);
  return trace({start, {*direction}}, RayKind::refraction, depth - 1, Visibility::nobody);
}

}  // namespace tribunal
