#include "tracer/leak/truth.h"

#include <algorithm>
#include <cmath>

#include "exact/cases/families/ulp.h"
#include "exact/filtered/crossing.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"

namespace tribunal::leak {
namespace {

/// Sorts the crossed faces by exact parameter, those of one parameter by number, and sets the places.
void order(const Surface& surface, const Ray& ray, RayTruth& truth) {
  const auto compare = [&](const Crossed& a, const Crossed& b) {
    return compare_hits(ray, surface.triangle(a.face), surface.triangle(b.face));
  };
  std::ranges::stable_sort(truth.crossed,
                           [&](const Crossed& a, const Crossed& b) { return compare(a, b) == Sign::negative; });
  for (std::size_t i = 0; i < truth.crossed.size(); ++i) {
    const bool same = i > 0 && compare(truth.crossed[i - 1], truth.crossed[i]) == Sign::zero;
    if (!same) truth.places.push_back({i, i});
    truth.places.back().end = i + 1;
  }
}

bool is_at_outline(const Surface& surface, const AimedRay& aimed) {
  if (aimed.aim == Aim::face) return false;
  const auto around = aimed.aim == Aim::vertex ? surface.faces_of_vertex(aimed.at) : surface.faces_of_edge(aimed.at);
  bool front = false, back = false;
  for (const std::uint32_t f : around) {
    if (surface.is_flat(f)) continue;
    const Facing facing = facing_of(surface, aimed.ray, f);
    front |= facing != Facing::back;
    back |= facing != Facing::front;
  }
  return front && back;
}

}  // namespace

bool RayTruth::crosses(std::uint32_t face) const {
  return std::ranges::find(crossed, face, &Crossed::face) != crossed.end();
}

bool RayTruth::meets(std::uint32_t face) const {
  return crosses(face) || std::ranges::find(along, face) != along.end() || std::ranges::find(flat, face) != flat.end();
}

Facing facing_of(const Surface& surface, const Ray& ray, std::uint32_t face) {
  const Triangle& t = surface.triangle(face);
  const Sign side = FilteredKernel().orient3d(t.a, t.b, t.c, ray.o);
  if (side == Sign::zero) return Facing::unsaid;
  return side == Sign::positive ? Facing::front : Facing::back;
}

bool is_edge_on(const Surface& surface, const Ray& ray, std::uint32_t face) {
  const Facing facing = facing_of(surface, ray, face);
  const Triangle& t = surface.triangle(face);
  double most = 0;
  for (const Point3& p : {ray.o, t.a, t.b, t.c}) {
    for (int axis = 0; axis < 3; ++axis) most = std::max(most, std::abs(p[axis]));
  }
  const double step = 16 * (moved_by_ulps(most, 1, surface.format()) - most);
  for (int signs = 0; signs < 8; ++signs) {
    const Point3 move((signs & 1) != 0 ? step : -step, (signs & 2) != 0 ? step : -step,
                      (signs & 4) != 0 ? step : -step);
    if (facing_of(surface, {ray.o + move, ray.d}, face) != facing) return true;
  }
  return false;
}

RayTruth truth_of(const Surface& surface, const AimedRay& aimed, std::span<const std::uint32_t> candidates) {
  RayTruth truth;
  int crossings = 0;
  for (const std::uint32_t f : candidates) {
    const Answer answer = intersect(aimed.ray, surface.triangle(f));
    if (!answer.hit) continue;
    const Crossing how = crossing(aimed.ray, surface.triangle(f));
    truth.on_surface |= how.holds_source;
    if (answer.contact == Contact::coplanar) {
      (surface.is_flat(f) ? truth.flat : truth.along).push_back(f);
      continue;
    }
    crossings += how.direction != 0;
    truth.crossed.push_back({f, answer.contact, facing_of(surface, aimed.ray, f), how.direction});
  }
  if (truth.on_surface) return truth;
  truth.inside = crossings % 2 == 1 && surface.topology().closed();
  truth.at_outline = is_at_outline(surface, aimed);
  order(surface, aimed.ray, truth);
  return truth;
}

bool is_passed(const Surface& surface, const RayTruth& truth, const Place& place, Culling culling) {
  const bool culls = culling != Culling::none;
  int crossings = 0, entered = 0;
  bool at_opening = false;
  for (const Crossed& c : truth.at(place)) {
    if (c.contact == Contact::interior && (!culls || c.facing == Facing::front)) return true;
    at_opening |= surface.is_at_opening(c.face);
    crossings += c.direction != 0;
    entered -= c.direction;
  }
  // In the plane of a neighbour the ray leaves it elsewhere than it enters: parity is of the whole way, not of a place.
  if (at_opening || !truth.along.empty()) return false;
  return culls ? surface.topology().oriented() && entered > 0 : crossings % 2 == 1;
}

}  // namespace tribunal::leak
