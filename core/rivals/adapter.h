// Makes a method of a published test: all functions of `Method` from the one or two that the test has.
//
// A rival R on the number type N has a `card` and a `contract`, says what it keeps of a triangle (`Prepared`, made by
// `prepare`; Corners<N> if it prepares nothing), and has one of
//   meet(origin, direction, prepared)          the hit of the line; the adapter compares t with the ends of the probe;
//   meet(origin, direction, t_max, prepared)   the hit with 0 ≤ t ≤ t_max, where comparing t is part of the test;
// and, where the test was published for the two ends of a segment,
//   meet_segment(p, q, prepared)               the hit with t from 0 at p to 1 at q.
// A rival with the last alone takes no rays, and its contract says so. One that prepares rays has `PreparedRay`, made
// by `prepare_ray`, and meet(prepared_ray, t_max, prepared).
//
// A test that was published for vector registers gives a Found in place of an optional hit, and so runs on them too
// (lanes.h).
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/method.h"
#include "core/rivals/batch.h"
#include "core/rivals/rival.h"

namespace tribunal::published {

template <class R>
concept PreparesRays = requires {
  typename R::PreparedRay;
};

template <class R>
concept PreparesTriangles = !std::is_same_v<typename R::Prepared, Corners<typename R::Number>>;

template <class R, class V = Vec3<typename R::Number>>
concept MeetsSegments = requires(V p, typename R::Prepared t) {
  R::meet_segment(p, p, t);
};

template <class R, class V = Vec3<typename R::Number>>
concept MeetsLines = requires(V o, typename R::Prepared t) {
  R::meet(o, o, t);
};

template <class R>
inline constexpr bool takes_rays = R::contract.probes.rays;

template <class R>
using HitOf = std::optional<RivalHit<typename R::Number>>;

template <class R>
typename R::Prepared prepared_of(const Corners<typename R::Number>& corners) {
  if constexpr (PreparesTriangles<R>) {
    return R::prepare(corners);
  } else {
    return corners;
  }
}

template <class R>
typename R::Prepared prepared(const Triangle& t) {
  return prepared_of<R>(corners_of<typename R::Number>(t));
}

namespace rival_detail {

template <class N>
std::optional<RivalHit<N>> as_hit(const Found<N>& found) {
  if (!found.hit) return std::nullopt;
  return RivalHit<N>{found.t, found.weights};
}

template <class N>
std::optional<RivalHit<N>> as_hit(std::optional<RivalHit<N>> hit) {
  return hit;
}

}  // namespace rival_detail

/// The hit of the probe {o + t·d, 0 ≤ t ≤ t_max}.
template <class R, class N = typename R::Number>
HitOf<R> meet_up_to(const Vec3<N>& o, const Vec3<N>& d, const N& t_max, const typename R::Prepared& t) {
  if constexpr (PreparesRays<R>) {
    return R::meet(R::prepare_ray(o, d), t_max, t);
  } else if constexpr (MeetsLines<R>) {
    HitOf<R> hit = rival_detail::as_hit(R::meet(o, d, t));
    if (!hit || !(hit->t >= 0 && hit->t <= t_max)) return std::nullopt;
    return hit;
  } else {
    return rival_detail::as_hit(R::meet(o, d, t_max, t));
  }
}

template <class N>
N unbounded() {
  return static_cast<N>(std::numeric_limits<double>::infinity());
}

/// The hit of the segment from p to q.
template <class R, class N = typename R::Number>
HitOf<R> meet_between(const Vec3<N>& p, const Vec3<N>& q, const typename R::Prepared& t) {
  if constexpr (MeetsSegments<R>) {
    return R::meet_segment(p, q, t);
  } else {
    return meet_up_to<R>(p, q - p, N(1), t);
  }
}

template <class R, class N = typename R::Number>
HitOf<R> meet(const Segment& s, const typename R::Prepared& t) {
  return meet_between<R>(lift<N>(s.p), lift<N>(s.q), t);
}

template <class R, class N = typename R::Number>
HitOf<R> meet(const Ray& r, const typename R::Prepared& t) {
  if constexpr (takes_rays<R>) {
    return meet_up_to<R>(lift<N>(r.o), lift<N>(r.d.v), unbounded<N>(), t);
  } else {
    return std::nullopt;
  }
}

template <class R, class P>
HitOf<R> meet(const P& probe, const Triangle& t) {
  return meet<R>(probe, prepared<R>(t));
}

/// The hit of the ray with tmin ≤ t ≤ tmax, in the test's own arithmetic: the bounds are rounded to its number type,
/// and its own t is compared with them.
template <class R, class N = typename R::Number>
HitOf<R> meet(const Ray& r, const Bounds& bounds, const Triangle& t) {
  const N least = static_cast<N>(bounds.tmin);
  const N most = std::isinf(bounds.tmax) ? unbounded<N>() : static_cast<N>(bounds.tmax);
  HitOf<R> hit = meet_up_to<R>(lift<N>(r.o), lift<N>(r.d.v), most, prepared<R>(t));
  if (!hit || !(hit->t >= least && hit->t <= most)) return std::nullopt;
  return hit;
}

/// A hit of a test that culls is one from the front.
template <class R>
Answer hit_of_rival() {
  Answer answer = hit_at(Contact::unsaid);
  if (R::contract.culling == Culling::back_faces) answer.facing = Facing::front;
  return answer;
}

/// A rival computes coordinates of the hit, not signs, so it does not say which contact a hit is.
template <class R, class P, class T>
Answer answer_of(const P& probe, const T& t) {
  if (std::is_same_v<P, Ray> && !takes_rays<R>) return refusal(Status::unsupported);
  return meet<R>(probe, t) ? hit_of_rival<R>() : miss();
}

template <class R>
Answer answer_within(const Ray& r, const Bounds& bounds, const Triangle& t) {
  if constexpr (takes_rays<R>) return meet<R>(r, bounds, t) ? hit_of_rival<R>() : miss();
  return refusal(Status::unsupported);
}

/// The answer to a query about a triangle, as `Method::ask` gives it.
template <class R>
Answer answer_to(const Query& query) {
  if (!is_finite(query)) return refusal(Status::nonfinite);
  if (query.operands() != Operands::triangles) return refusal(Status::unsupported);
  if (query.bounds) return answer_within<R>(std::get<Ray>(query.probe), *query.bounds, query.triangle());
  return std::visit([&](const auto& probe) { return answer_of<R>(probe, query.triangle()); }, query.probe);
}

namespace rival_detail {

template <class R>
Sign nearer(const Ray& r, const Triangle& s, const Triangle& t) {
  const HitOf<R> f = meet<R>(r, s), g = meet<R>(r, t);
  return f && g ? sign_of(f->t - g->t) : Sign::zero;
}

template <class R>
std::optional<HitAt> hit_of(const Ray& r, const Triangle& t) {
  const HitOf<R> hit = meet<R>(r, t);
  if (!hit) return std::nullopt;
  HitAt at{.t = hit->t};
  if (hit->weights) at.weights = BarycentricWeights{hit->weights->b, hit->weights->c};
  return at;
}

/// The parameter of the hit; nothing if it is a NaN.
template <class R>
std::optional<double> parameter_of(const Ray& r, const Triangle& t) {
  const std::optional<HitAt> hit = hit_of<R>(r, t);
  return hit && !std::isnan(hit->t) ? std::optional(hit->t) : std::nullopt;
}

template <class R>
PreparedTriangle prepare_triangle(const Triangle& triangle) {
  const typename R::Prepared t = prepared<R>(triangle);
  return {.segment = [t](const Segment& s) { return answer_of<R>(s, t); },
          .ray = [t](const Ray& r) { return answer_of<R>(r, t); }};
}

template <class R, class N = typename R::Number>
PreparedRay prepare_ray(const Ray& ray) {
  const typename R::PreparedRay r = R::prepare_ray(lift<N>(ray.o), lift<N>(ray.d.v));
  return
      [r](const Triangle& t) { return R::meet(r, unbounded<N>(), prepared<R>(t)) ? hit_at(Contact::unsaid) : miss(); };
}

/// The segments, and what the test keeps of each triangle, on its own number type.
template <class R, class N = typename R::Number>
struct PairsOf {
  struct Ends {
    Vec3<N> p, q;
  };
  std::vector<Ends> segments{};
  std::vector<Corners<N>> triangles{};
  std::vector<typename R::Prepared> prepared{};

  explicit PairsOf(std::span<const SegmentPair> pairs) {
    for (const auto& [segment, triangle] : pairs) {
      segments.push_back({lift<N>(segment.p), lift<N>(segment.q)});
      triangles.push_back(corners_of<N>(triangle));
      if constexpr (PreparesTriangles<R>) prepared.push_back(R::prepare(triangles.back()));
    }
  }

  void prepare_all() {
    for (std::size_t i = 0; i < triangles.size(); ++i) prepared[i] = R::prepare(triangles[i]);
  }
};

/// Inlined as a whole: a user's loop has no call in it either, nor a hit that goes through memory.
template <class R, class N = typename R::Number>
[[gnu::flatten]] bool meets(const Vec3<N>& p, const Vec3<N>& q, const typename R::Prepared& t) {
  return meet_between<R>(p, q, t).has_value();
}

/// The same with the triangle prepared on the way.
template <class R, class N = typename R::Number>
[[gnu::flatten]] bool prepares_and_meets(const Vec3<N>& p, const Vec3<N>& q, const Corners<N>& corners) {
  return meet_between<R>(p, q, prepared_of<R>(corners)).has_value();
}

template <class R>
NativeLoops native_loops_of() {
  using Pairs = PairsOf<R>;
  NativeLoops native{.bytes = sizeof(typename R::Prepared)};
  native.single = [](std::span<const SegmentPair> given) -> NativeRun {
    return [pairs = Pairs(given)](std::span<std::uint8_t> hits, std::size_t step) {
      visit_by_steps(hits.size(), step, [&](std::size_t i) {
        const auto& [p, q] = pairs.segments[i];
        hits[i] = prepares_and_meets<R>(p, q, pairs.triangles[i]);
      });
    };
  };
  if constexpr (PreparesTriangles<R>) {
    native.prepared = [](std::span<const SegmentPair> given) -> PreparedRun {
      const auto pairs = std::make_shared<Pairs>(given);
      return {.set_up = [pairs] { pairs->prepare_all(); },
              .ask =
                  [pairs](std::span<std::uint8_t> hits, std::size_t step) {
                    visit_by_steps(hits.size(), step, [&](std::size_t i) {
                      const auto& [p, q] = pairs->segments[i];
                      hits[i] = meets<R>(p, q, pairs->prepared[i]);
                    });
                  }};
    };
  }
  return native;
}

}  // namespace rival_detail

/// The method, without its name. R is a rival on float or double.
template <class R>
Method rival_method() {
  static_assert(std::is_floating_point_v<typename R::Number>);
  const Format format = std::is_same_v<typename R::Number, float> ? Format::binary32 : Format::binary64;
  Method m{.card = {.number = std::string(name_of(format)), .summary = R::card.summary, .reference = R::card.reference},
           .contract = R::contract,
           .segment = answer_of<R, Segment, Triangle>,
           .ray = answer_of<R, Ray, Triangle>};
  m.contract.format = format;
  m.tells_side = R::contract.culling == Culling::back_faces;
  if constexpr (takes_rays<R>) {
    m.contract.probes.bounds = true;
    m.contract.bounds = R::contract.ends;
    m.within = answer_within<R>;
    m.compare_hits = rival_detail::nearer<R>;
    m.parameter = rival_detail::parameter_of<R>;
    m.hit = rival_detail::hit_of<R>;
  }
  m.native = rival_detail::native_loops_of<R>();
  if constexpr (runs_on_lanes<R>) {
    m.batch = answer_batch<R>;
    m.native.batch = batch_loop<R>;
  }
  if constexpr (PreparesTriangles<R>) m.prepare_triangle = rival_detail::prepare_triangle<R>;
  if constexpr (PreparesRays<R>) m.prepare_ray = rival_detail::prepare_ray<R>;
  return m;
}

}  // namespace tribunal::published
