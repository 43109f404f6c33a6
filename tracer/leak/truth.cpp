#include "tracer/leak/truth.h"

#include <algorithm>
#include <utility>

#include "exact/filtered/crossing.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"
#include "tracer/leak/nearness.h"

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

/// Gathers one passage from a face on.
class Gathering {
 public:
  Gathering(const Surface& surface, const Ray& ray) : surface_(surface), near_(ray, surface.format()) {}

  Passage from(std::span<const Crossed> crossed) {
    for (const Crossed& c : crossed) add(c.face);
    for (std::size_t i = 0; i < passage_.faces.size(); ++i) spread(surface_.corners(passage_.faces[i]));
    std::ranges::sort(passage_.faces);
    return std::move(passage_);
  }

 private:
  void add(std::uint32_t face) {
    if (std::ranges::find(passage_.faces, face) == passage_.faces.end()) passage_.faces.push_back(face);
  }

  bool is_near(std::uint32_t vertex) {
    return known(vertices_, vertex, [&] { return near_.has(surface_.vertices()[vertex]); });
  }

  bool is_near(std::uint32_t a, std::uint32_t b) {
    const Surface::Edge edge = {std::min(a, b), std::max(a, b)};
    return known(edges_, edge, [&] { return near_.has(surface_.vertices()[edge[0]], surface_.vertices()[edge[1]]); });
  }

  /// The answer that the list has for the key; else it is found, and kept.
  template <class Key, class Find>
  static bool known(std::vector<std::pair<Key, bool>>& list, const Key& key, const Find& find) {
    const auto entry = std::ranges::find(list, key, &std::pair<Key, bool>::first);
    if (entry != list.end()) return entry->second;
    list.emplace_back(key, find());
    return list.back().second;
  }

  void spread(const Surface::Corners& corners) {
    for (const std::uint32_t v : corners) {
      if (is_near(v)) spread_from(v);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
      if (a != b && !is_near(a) && !is_near(b) && is_near(a, b)) spread_from(a, b);
    }
  }

  void spread_from(std::uint32_t v) {
    passage_.at_opening |= surface_.is_at_opening(v);
    for (const std::uint32_t f : surface_.faces_of_vertex(v)) add(f);
  }

  void spread_from(std::uint32_t a, std::uint32_t b) {
    std::size_t count = 0;
    for (const std::uint32_t f : surface_.faces_of_vertex(a)) {
      if (!surface_.has_vertex(f, b)) continue;
      add(f);
      ++count;
    }
    passage_.at_opening |= count % 2 == 1;
  }

  const Surface& surface_;
  Nearness near_;
  Passage passage_{};
  std::vector<std::pair<std::uint32_t, bool>> vertices_{};
  std::vector<std::pair<Surface::Edge, bool>> edges_{};
};

/// Sets the passages, and to which of them each place belongs.
void find_passages(const Surface& surface, const Ray& ray, RayTruth& truth) {
  constexpr std::size_t none = SIZE_MAX;
  for (Place& p : truth.places) p.passage = none;
  for (std::size_t i = 0; i < truth.places.size(); ++i) {
    if (truth.places[i].passage != none) continue;
    Passage passage = Gathering(surface, ray).from(truth.at(truth.places[i]));
    for (std::size_t j = i; j < truth.places.size(); ++j) {
      const auto crossed = truth.at(truth.places[j]);
      if (!passage.has(crossed.front().face)) continue;
      truth.places[j].passage = truth.passages.size();
      passage.places.push_back(j);
      for (const Crossed& c : crossed) {
        passage.crossings += c.direction != 0;
        passage.entered -= c.direction;
      }
    }
    truth.passages.push_back(std::move(passage));
  }
}

}  // namespace

bool RayTruth::crosses(std::uint32_t face) const { return std::ranges::binary_search(crossed_faces, face); }

bool RayTruth::meets(std::uint32_t face) const {
  return crosses(face) || std::ranges::binary_search(along, face) || std::ranges::binary_search(flat, face);
}

Facing facing_of(const Surface& surface, const Ray& ray, std::uint32_t face) {
  const Triangle& t = surface.triangle(face);
  const Sign side = FilteredKernel().orient3d(t.a, t.b, t.c, ray.o);
  if (side == Sign::zero) return Facing::unsaid;
  return side == Sign::positive ? Facing::front : Facing::back;
}

RayTruth truth_of(const Surface& surface, const AimedRay& aimed, std::span<const std::uint32_t> candidates) {
  RayTruth truth;
  const Nearness near(aimed.ray, surface.format());
  int crossings = 0;
  for (const std::uint32_t f : candidates) {
    truth.starts_near |= near.source_is_at(surface.triangle(f));
    const Answer answer = intersect(aimed.ray, surface.triangle(f));
    if (!answer.hit) continue;
    const Crossing how = crossing(aimed.ray, surface.triangle(f));
    truth.on_surface |= how.holds_source;
    if (answer.contact == Contact::coplanar) {
      (surface.is_flat(f) ? truth.flat : truth.along).push_back(f);
      continue;
    }
    crossings += how.direction != 0;
    truth.crossed_faces.push_back(f);
    truth.crossed.push_back({f, answer.contact, facing_of(surface, aimed.ray, f), how.direction});
  }
  if (truth.on_surface) return truth;
  truth.inside = crossings % 2 == 1 && surface.topology().closed();
  order(surface, aimed.ray, truth);
  find_passages(surface, aimed.ray, truth);
  return truth;
}

namespace {

bool has_opening(const Surface& surface, std::span<const Crossed> crossed) {
  return std::ranges::any_of(crossed, [&](const Crossed& c) {
    return std::ranges::any_of(surface.corners(c.face), [&](std::uint32_t v) { return surface.is_at_opening(v); });
  });
}

}  // namespace

bool is_passed(const Surface& surface, const RayTruth& truth, const Place& place, Culling culling) {
  const bool culls = culling != Culling::none;
  int crossings = 0, entered = 0;
  for (const Crossed& c : truth.at(place)) {
    if (c.contact == Contact::interior && (!culls || c.facing == Facing::front)) return true;
    crossings += c.direction != 0;
    entered -= c.direction;
  }
  // In the plane of a neighbour the ray leaves it elsewhere than it enters: parity is of the whole way, not of a place.
  if (!truth.along.empty() || has_opening(surface, truth.at(place))) return false;
  return culls ? surface.topology().oriented() && entered > 0 : crossings % 2 == 1;
}

bool is_passed(const Surface& surface, const RayTruth& truth, const Passage& passage, Culling culling) {
  if (passage.at_opening || truth.starts_near) return false;
  const bool oriented = surface.topology().oriented();
  if (culling == Culling::none) return oriented ? passage.entered != 0 : passage.crossings % 2 == 1;
  if (oriented) return passage.entered > 0;
  return passage.faces.size() == 1 && truth.at(truth.places[passage.places.front()]).front().facing == Facing::front;
}

}  // namespace tribunal::leak
