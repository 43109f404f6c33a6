// Whitted's recursion. Source: Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980;
// Phong, "Illumination for computer generated pictures", CACM 18(6), 1975.
//
// All decisions (hit, nearer, blocked) are the method's. All constructions (point, normal, colour, the next ray) are
// double arithmetic, the same lines for every method. So two methods get the same pixel unless they decide
// differently somewhere, and at the first such place they were asked the same question.
//
// Secondary rays start where departure.h says: proved right for exact methods, by the customary bias for others. So
// two exact methods cast the same rays; of an exact and another, secondary rays differ a little in their starts.
#pragma once

#include <vector>

#include "tracer/shading/departure.h"

namespace tribunal {

/// Traces rays of one world with one method. One object a thread.
class WhittedTracer {
 public:
  /// If `log` is given, every decision is appended to it.
  WhittedTracer(const World& world, const Method& method, RayTally& tally, std::vector<Decision>* log = nullptr)
      : world_(world),
        visibility_(world, method, tally),
        departures_(world, method, visibility_, tally),
        tally_(tally),
        log_(log) {}
  WhittedTracer(const WhittedTracer&) = delete;

  /// Light that arrives along a primary ray, with this many generations of rays.
  Colour trace(const Ray& primary, int depth) { return trace(primary, RayKind::primary, depth, Visibility::nobody); }

  /// A hash of the outcomes of all decisions since the last call.
  std::uint64_t take_hash();

 private:
  /// What shading knows of a hit. `normal` faces the viewer.
  struct Surface {
    Landing at;
    Point3 view;
    bool from_outside;
    const Material& material;
    std::optional<Start> near{};  ///< start on the viewer's side, once it is needed
  };

  Colour trace(const Ray& ray, RayKind kind, int depth, std::uint32_t apart);
  Surface surface_at(const Ray& ray, std::uint32_t id) const;
  Colour shade(Surface s, int depth);
  Colour light_on(Surface& s, const Light& light);
  Colour reflected(Surface& s, int depth);
  Colour refracted(Surface& s, int depth);
  const Start& near_start(Surface& s);
  void note(RayKind kind, const Probe& probe, std::int64_t outcome, bool hit);

  const World& world_;
  Visibility visibility_;
  Departures departures_;
  RayTally& tally_;
  std::vector<Decision>* log_;
  std::uint64_t hash_ = 0;
};

/// The direction of a refracted ray, or nothing under total internal reflection. `view` and `normal` are unit vectors
/// that face each other's way (view·normal ≥ 0); `eta` is the refractive index on the viewer's side over the other.
std::optional<Point3> refract(const Point3& view, const Point3& normal, double eta);

}  // namespace tribunal
