// Whitted's recursion. Source: Whitted, "An improved illumination model for shaded display", CACM 23(6), 1980;
// Phong, "Illumination for computer generated pictures", CACM 18(6), 1975.
//
// All decisions (hit, nearer, blocked) are the method's. All constructions (point, normal, colour, the next ray) are
// double arithmetic, the same lines for every method. So two methods get the same pixel unless they decide
// differently somewhere, and at the first such place they were asked the same question.
//
// Rays are cast generation by generation: all primary rays of a tile, then their shadow rays, then all rays that these
// surfaces send on, and so forth, since similar queries are cheaper together (visibility.h). The light is
// gathered depth first, ray by ray, as the recursion would.
//
// Secondary rays start where departure.h says: proved right for exact methods, by the customary bias for others. So
// two exact methods cast the same rays; of an exact and another, secondary rays differ a little in their starts.
#pragma once

#include <vector>

#include "tracer/shading/departure.h"
#include "tracer/shading/warn_light.h"

namespace tribunal {

/// The result of tracing one primary ray.
struct TracedPixel {
  Colour colour;            ///< light that arrives along it
  std::uint64_t decisions;  ///< a hash of the outcomes of all decisions
  Cost cost;
};

/// Traces rays of one world with one method. One object a thread.
class WhittedTracer {
 public:
  /// If `log` is given, every decision is appended to it.
  WhittedTracer(const World& world, const Method& method, RayTally& tally, std::vector<Decision>* log = nullptr)
      : world_(world),
        visibility_(world, method, tally),
        faces_(world),
        departures_(world, method, visibility_, faces_, tally),
        lights_(world.scene->lights.begin(), world.scene->lights.end()),
        tally_(tally),
        log_(log) {}
  WhittedTracer(const WhittedTracer&) = delete;

  /// Traces each primary ray through this many generations of rays. Works on as many primary rays at once as may lead
  /// to 2^16 rays in all (16 MB), and at least on one.
  void trace(std::span<const Ray> primaries, int depth, std::span<TracedPixel> pixels);

  /// The same for a single ray.
  TracedPixel trace(const Ray& primary, int depth) {
    TracedPixel pixel;
    trace({&primary, 1}, depth, {&pixel, 1});
    return pixel;
  }

 private:
  static constexpr std::uint32_t nothing = ~std::uint32_t{0};

  /// A ray on its way, and what shading knows of the surface that it hit. `normal` faces the viewer.
  struct Path {
    Path() {}  // members without initialiser are set before they are read

    Ray ray;
    RayKind kind;
    std::uint32_t pixel;
    std::optional<std::uint32_t> face;
    HitPoint at;
    Point3 view;
    const Material* material = nullptr;
    bool from_outside = false, departs = false;
    Departure near;  ///< on the viewer's side, if a ray departs
    Colour colour;
    std::uint32_t reflected = nothing, refracted = nothing;  ///< the paths of the rays that departed from the hit
  };

  /// A light that shines on the surface that a path hit, unless a face blocks it.
  struct Shine {
    std::uint32_t path, light;
    Point3 to_light;
    double cosine, strength;
  };

  enum class Shadow : std::uint8_t { unasked, lit, blocked };

  void trace_together(std::span<const Ray> primaries, int depth, std::span<TracedPixel> pixels);
  std::uint32_t add_path(const Ray& ray, RayKind kind, std::uint32_t pixel, Behind behind);
  void find_faces(std::size_t begin);
  void look_at(Path& p);
  void find_shines(std::size_t begin);
  void find_starts(std::size_t begin, bool all);
  void add_light();
  Colour light_of(const Shine& s) const;
  void send_on(std::size_t begin);
  Colour gather(const Path& p);
  template <class ProbeOf>
  void note(RayKind kind, std::int64_t outcome, bool hit, const ProbeOf& probe);

  const Material& material_of(const Path& p) const { return world_.material_of(*p.face); }
  Shadow& shadow_of(std::size_t path, std::size_t light) {
    return shadows_[path * world_.scene->lights.size() + light];
  }

  const World& world_;
  Visibility visibility_;
  KnownFaces faces_;
  Departures departures_;
  std::vector<WarnLight> lights_;
  RayTally& tally_;
  std::vector<Decision>* log_;
  std::uint64_t hash_ = 0;
  std::span<TracedPixel> pixels_;
  std::vector<Path> paths_;  ///< all rays of the primaries at work, by generation
  std::vector<Shadow> shadows_;
  std::vector<Shine> shines_;

  // Queries of the current generation; members, so that their memory is reused.
  std::vector<RayQuestion> rays_;
  std::vector<NearQuestion> starts_;
  std::vector<SegmentQuestion> ways_;
};

/// The direction of a refracted ray, or nothing under total internal reflection. `view` and `normal` are unit vectors
/// that face each other's way (view·normal ≥ 0); `eta` is the refractive index on the viewer's side over the other.
std::optional<Point3> refract(const Point3& view, const Point3& normal, double eta);

}  // namespace tribunal
