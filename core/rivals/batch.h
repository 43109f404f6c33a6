// Many pairs at once, for rivals that run on vector lanes: each lane holds a probe and a triangle of its own. The
// sources have one ray, or one triangle, in all lanes; so they read less, and compute the same.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "core/answer.h"
#include "core/native.h"
#include "core/rivals/lanes.h"

namespace tribunal::published {

namespace batch_detail {

template <class R>
struct OnLanes;

template <template <class> class Rival, class N>
struct OnLanes<Rival<N>> {
  using type = Rival<Lanes<N>>;
};

/// As many pairs as there are lanes: the lines of the probes, where they end, and what is kept of the triangles.
template <class R, class N = typename R::Number>
struct Group {
  using L = Lanes<N>;
  using OfLanes = typename OnLanes<R>::type;
  static constexpr std::size_t size = L::count;

  Vec3<L> origin, direction;
  L t_max{};
  Corners<L> corners;
  typename OfLanes::Prepared triangle{};

  void put(std::size_t lane, const Segment& s) { put(lane, lift<N>(s.p), lift<N>(s.q) - lift<N>(s.p), 1); }
  void put(std::size_t lane, const Ray& r) {
    put(lane, lift<N>(r.o), lift<N>(r.d.v), std::numeric_limits<N>::infinity());
  }
  void put(std::size_t lane, const Triangle& t) {
    set(corners.a, lane, lift<N>(t.a));
    set(corners.b, lane, lift<N>(t.b));
    set(corners.c, lane, lift<N>(t.c));
  }

  void prepare() {
    if constexpr (requires { OfLanes::prepare(corners); }) {
      triangle = OfLanes::prepare(corners);
    } else {
      triangle = corners;
    }
  }

  LaneMask<N> hits() const {
    if constexpr (requires { OfLanes::meet(origin, direction, t_max, triangle); }) {
      return OfLanes::meet(origin, direction, t_max, triangle).hit;
    } else {
      const Found<L> found = OfLanes::meet(origin, direction, triangle);
      return found.hit & (found.t >= 0) & (found.t <= t_max);
    }
  }

 private:
  static void set(Vec3<L>& v, std::size_t lane, const Vec3<N>& x) {
    v.x.set(lane, x.x);
    v.y.set(lane, x.y);
    v.z.set(lane, x.z);
  }
  void put(std::size_t lane, const Vec3<N>& o, const Vec3<N>& d, N end) {
    set(origin, lane, o);
    set(direction, lane, d);
    t_max.set(lane, end);
  }
};

/// The pair's segment, or the ray that it is read as.
template <class P>
P probe_of(const SegmentPair& pair) {
  if constexpr (std::is_same_v<P, Segment>) {
    return pair.segment;
  } else {
    return ray_of(pair);
  }
}

}  // namespace batch_detail

/// The answers of R, as the adapter gives them one by one.
template <class R>
[[gnu::flatten]] void answer_batch(std::span<const TrianglePair> pairs, std::span<Answer> answers) {
  using Group = batch_detail::Group<R>;
  for (std::size_t first = 0; first < pairs.size(); first += Group::size) {
    Group group;
    for (std::size_t lane = 0; lane < Group::size; ++lane) {
      const TrianglePair& pair = pairs[std::min(first + lane, pairs.size() - 1)];
      std::visit([&](const auto& probe) { group.put(lane, probe); }, pair.probe);
      group.put(lane, pair.triangle);
    }
    group.prepare();
    const auto hits = group.hits();
    for (std::size_t lane = 0; lane < Group::size && first + lane < pairs.size(); ++lane) {
      answers[first + lane] = hits[lane] ? hit_at(Contact::unsaid) : miss();
    }
  }
}

/// The same for a clock, with all triangles prepared, of segments or of rays.
template <class R, class P>
NativeRun batch_loop(std::span<const SegmentPair> pairs) {
  using Group = batch_detail::Group<R>;
  std::vector<Group> groups((pairs.size() + Group::size - 1) / Group::size);
  for (std::size_t i = 0; i < groups.size() * Group::size; ++i) {
    const SegmentPair& pair = pairs[std::min(i, pairs.size() - 1)];
    groups[i / Group::size].put(i % Group::size, batch_detail::probe_of<P>(pair));
    groups[i / Group::size].put(i % Group::size, pair.triangle);
  }
  for (Group& group : groups) group.prepare();
  return [groups = std::move(groups)](std::span<std::uint8_t> hits, std::size_t) {
    for (std::size_t g = 0; g < groups.size() && g * Group::size < hits.size(); ++g) {
      const auto hit = groups[g].hits();
      const std::size_t first = g * Group::size, n = std::min(Group::size, hits.size() - first);
      for (std::size_t lane = 0; lane < n; ++lane) hits[first + lane] = hit[lane];
    }
  };
}

}  // namespace tribunal::published
