#include "tracer/shading/whitted.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "tracer/shading/camera_rays.h"
#include "tracer/shading/warn_light.h"

namespace tribunal {
namespace {

/// The hit point by shading_parameter, clamped to the face's box, in which the exact one lies. A parameter that is
/// NaN (a method may report hits that no formula confirms) gives a corner of the box.
Point3 hit_point(const Ray& r, const Triangle& t, const Box& b) {
  const double parameter = shading_parameter(r, t);
  const Point3 p = r.o + parameter * r.d.v;
  Point3 inside = b.lo;
  for (int i = 0; i < 3; ++i) {
    if (p[i] > b.lo[i]) inside[i] = std::min(p[i], b.hi[i]);
  }
  return inside;
}

constexpr std::size_t most_paths = 1 << 16;  ///< the most paths of one batch; each hit leads to at most two more

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

void WhittedTracer::trace(std::span<const Ray> primaries, int depth, std::span<TracedPixel> pixels) {
  const std::size_t together = std::max<std::size_t>(1, most_paths >> std::min(depth, 63));
  for (std::size_t from = 0; from < primaries.size(); from += together) {
    const std::size_t count = std::min(together, primaries.size() - from);
    trace_together(primaries.subspan(from, count), depth, pixels.subspan(from, count));
  }
}

void WhittedTracer::trace_together(std::span<const Ray> primaries, int depth, std::span<TracedPixel> pixels) {
  pixels_ = pixels;
  paths_.clear();
  shadows_.clear();
  for (std::uint32_t i = 0; i < primaries.size(); ++i) {
    pixels[i] = {};
    add_path(primaries[i], RayKind::primary, i, {});
  }
  for (std::size_t begin = 0; begin < paths_.size(); --depth) {
    const std::size_t end = paths_.size();
    find_faces(begin);
    find_shines(begin);
    find_starts(begin, depth > 1);
    add_light();
    if (depth > 1) send_on(begin);
    begin = end;
  }
  for (std::size_t i = 0; i < primaries.size(); ++i) {
    pixels[i].colour = gather(paths_[i]);
    pixels[i].decisions = std::exchange(hash_, 0);
  }
}

std::uint32_t WhittedTracer::add_path(const Ray& ray, RayKind kind, std::uint32_t pixel, Behind behind) {
  Path& p = paths_.emplace_back();
  p.ray.o = in_format(ray.o, world_.format);
  p.ray.d.v = in_format(ray.d.v, world_.format);
  p.kind = kind;
  p.pixel = pixel;
  p.at.behind = behind;
  shadows_.insert(shadows_.end(), lights_.size(), Shadow::unasked);
  return static_cast<std::uint32_t>(paths_.size() - 1);
}

void WhittedTracer::find_faces(std::size_t begin) {
  rays_.clear();
  for (std::size_t i = begin; i < paths_.size(); ++i) {
    RayQuestion& q = rays_.emplace_back();
    q.ray = paths_[i].ray;
    q.excluded = paths_[i].at.behind.face;
  }
  visibility_.first_hits(rays_);
  for (const RayQuestion& q : rays_) {
    Path& p = paths_[begin++];
    pixels_[p.pixel].cost += q.cost;
    p.face = q.face;
    if (p.face) look_at(p);
  }
}

void WhittedTracer::look_at(Path& p) {
  const KnownFace& face = faces_[*p.face];
  p.view = normalised(-p.ray.d.v);
  p.from_outside = glm::dot(face.normal, p.view) >= 0;
  p.at.origin = p.ray.o;
  p.at.face = face.id;
  p.at.point = hit_point(p.ray, face.triangle, face.box);
  p.at.normal = face.normal == Point3(0) ? p.view : p.from_outside ? face.normal : -face.normal;
  p.material = face.material;
  p.colour = face.material->ambient * face.material->colour;
}

/// Lists the lights that may shine on the new surfaces, light by light, so that neighbours in the list have similar
/// shadow rays.
void WhittedTracer::find_shines(std::size_t begin) {
  shines_.clear();
  for (std::uint32_t l = 0; l < lights_.size(); ++l) {
    for (std::size_t i = begin; i < paths_.size(); ++i) {
      Path& p = paths_[i];
      if (!p.face) continue;
      const Point3 to_light = normalised(lights_[l].light().position - p.at.point);
      const double cosine = glm::dot(to_light, p.at.normal);
      if (!(cosine > 0)) continue;
      const double strength = lights_[l].strength_at(p.at.point, to_light);
      if (!(strength > 0)) continue;
      p.departs = true;
      Shine& s = shines_.emplace_back();
      s.path = static_cast<std::uint32_t>(i);
      s.light = l;
      s.to_light = to_light;
      s.cosine = cosine;
      s.strength = strength;
    }
  }
}

/// Finds starts on the surfaces that a light may shine on and, if sends_on, on those that reflect or transmit light.
void WhittedTracer::find_starts(std::size_t begin, bool sends_on) {
  starts_.clear();
  for (std::size_t i = begin; i < paths_.size(); ++i) {
    Path& p = paths_[i];
    if (p.face && sends_on) p.departs |= p.material->reflection > 0 || p.material->transparency > 0;
    if (p.departs) starts_.emplace_back().at = &p.at;
  }
  departures_.near_sides(starts_);
  for (const NearQuestion& q : starts_) {
    while (!paths_[begin].departs) ++begin;
    Path& p = paths_[begin++];
    pixels_[p.pixel].cost += q.cost;
    p.near = q.start;
  }
}

void WhittedTracer::add_light() {
  ways_.clear();
  for (const Shine& s : shines_) {
    const Path& p = paths_[s.path];
    SegmentQuestion& q = ways_.emplace_back();
    q.way.p = p.near.point;
    q.way.q = in_format(lights_[s.light].light().position, world_.format);
    q.excluded[0] = departures_.left_behind(p.at, p.near, q.way.q).face;
  }
  visibility_.blocked(ways_);
  for (std::size_t i = 0; i < shines_.size(); ++i) {
    const Shine& s = shines_[i];
    Path& p = paths_[s.path];
    pixels_[p.pixel].cost += ways_[i].cost;
    shadow_of(s.path, s.light) = ways_[i].met ? Shadow::blocked : Shadow::lit;
    if (!ways_[i].met) p.colour += light_of(s);
  }
}

Colour WhittedTracer::light_of(const Shine& s) const {
  const Path& p = paths_[s.path];
  const Light& light = lights_[s.light].light();
  const Material& m = *p.material;
  Colour colour = m.diffuse * s.cosine * (m.colour * light.colour);
  if (m.specular > 0) {
    const double shine = std::max(0.0, glm::dot(mirrored(s.to_light, p.at.normal), p.view));
    colour += m.specular * power(shine, m.shininess) * light.colour;
  }
  return s.strength * colour;
}

/// Adds the reflected and refracted rays of the new surfaces. Under total internal reflection the refracted share is
/// reflected.
void WhittedTracer::send_on(std::size_t begin) {
  const std::size_t end = paths_.size();
  const auto reflect = [&](std::size_t i) {
    const Path& p = paths_[i];
    const Direction direction{in_format(mirrored(p.view, p.at.normal), world_.format)};
    return add_path({p.near.point, direction}, RayKind::reflection, p.pixel,
                    departures_.left_behind(p.at, p.near, direction));
  };
  std::vector<FarQuestion> questions;
  std::vector<std::pair<std::size_t, Direction>> directions;
  for (std::size_t i = begin; i < end; ++i) {
    if (!paths_[i].face) continue;
    const Material& m = *paths_[i].material;
    if (m.reflection > 0) paths_[i].reflected = reflect(i);
    if (!(m.transparency > 0)) continue;
    const Path& p = paths_[i];
    const double eta = p.from_outside ? 1 / m.refractive_index : m.refractive_index;
    if (const std::optional<Point3> direction = refract(p.view, p.at.normal, eta)) {
      questions.push_back({nullptr, p.near});
      directions.emplace_back(i, Direction{in_format(*direction, world_.format)});
    } else {
      paths_[i].refracted = reflect(i);
    }
  }
  for (std::size_t k = 0; k < questions.size(); ++k) questions[k].at = &paths_[directions[k].first].at;
  departures_.far_sides(questions);
  for (std::size_t k = 0; k < questions.size(); ++k) {
    const auto& [i, direction] = directions[k];
    const FarQuestion& q = questions[k];
    const std::uint32_t pixel = paths_[i].pixel;
    pixels_[pixel].cost += q.cost;
    paths_[i].refracted = add_path({q.start.point, direction}, RayKind::refraction, pixel,
                                   departures_.left_behind(paths_[i].at, q.start, direction));
  }
}

Colour WhittedTracer::gather(const Path& p) {
  note(p.kind, p.face ? std::int64_t{*p.face} : -1, p.face.has_value(), [&] { return p.ray; });
  if (!p.face) return world_.scene->background;
  for (std::size_t l = 0; l < lights_.size(); ++l) {
    const Shadow shadow = shadow_of(static_cast<std::size_t>(&p - paths_.data()), l);
    if (shadow == Shadow::unasked) continue;
    const bool blocked = shadow == Shadow::blocked;
    note(RayKind::shadow, blocked, blocked, [&] {
      return Segment{p.near.point, in_format(lights_[l].light().position, world_.format)};
    });
  }
  Colour colour = p.colour;
  if (p.reflected != nothing) colour += p.material->reflection * gather(paths_[p.reflected]);
  if (p.refracted != nothing) colour += p.material->transparency * gather(paths_[p.refracted]);
  return colour;
}

template <class ProbeOf>
void WhittedTracer::note(RayKind kind, std::int64_t outcome, bool hit, const ProbeOf& probe) {
  const auto k = static_cast<std::size_t>(kind);
  ++tally_.rays[k];
  tally_.ray_hits[k] += hit;
  hash_ = mixed(hash_, static_cast<std::uint64_t>(outcome));
  if (log_) log_->push_back({kind, probe(), outcome});
}

}  // namespace tribunal
