// Kills mutants of the tree's traversal, on lanes one number wide: returns 0 iff every question to a tree is answered
// as a test of every triangle answers it. Triangles and rays are of small integers, on which int64 is exact; what the
// tree gets is their image by a power of two and an offset. Where digits matter GMP's fractions decide.
#include <gmpxx.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/segura_feito.h"
#include "exact/filtered/batch/batch_target.h"
#include "tests/mutation/kill_scenes.h"
#include "tracer/accel/certified.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/accel/wide/packet.h"
#include "tracer/accel/wide/traversal.h"

using namespace tribunal;
using namespace tribunal::killing;

namespace tribunal {

// One target only: what is measured, and mutated, are the lanes compiled for no vector instructions.
const BatchTarget batch_avx512{}, batch_avx2{}, batch_portable{};
const BatchTarget& batch_target() { return batch_portable; }
const TreeTarget tree_avx512{}, tree_avx2{};
const PacketTarget packet_avx512{}, packet_avx2{};

}  // namespace tribunal

void check_boxes();
void check_packets();

namespace {

// --- closed meshes --------------------------------------------------------------------------------------------------

/// The surface of the box from lo to hi, its faces counterclockwise as seen from outside.
void add_box(std::vector<Triangle>& mesh, const Point3& lo, const Point3& hi) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool far : {false, true}) {
      Point3 a = far ? hi : lo;
      a[u] = lo[u], a[v] = lo[v];
      Point3 b = a, c = a, d = a;
      b[u] = hi[u], c[u] = hi[u], c[v] = hi[v], d[v] = hi[v];
      if (!far) std::swap(b, d);
      mesh.push_back({a, b, c});
      mesh.push_back({a, c, d});
    }
  }
}

bool strictly_between(const Point3& lo, const Point3& x, const Point3& hi) {
  return lo.x < x.x && x.x < hi.x && lo.y < x.y && x.y < hi.y && lo.z < x.z && x.z < hi.z;
}

bool weakly_between(const Point3& lo, const Point3& x, const Point3& hi) {
  return lo.x <= x.x && x.x <= hi.x && lo.y <= x.y && x.y <= hi.y && lo.z <= x.z && x.z <= hi.z;
}

/// Boxes that overlap: the winding number of a point is the number of boxes that hold it.
void check_inside(Draw& draw, const Image& image) {
  std::vector<Triangle> mesh;
  std::vector<std::pair<Point3, Point3>> boxes;
  for (int i = 0; i < 4; ++i) {
    const Point3 lo = draw.point(3), hi = lo + Point3(draw.within(1, 4), draw.within(1, 4), draw.within(1, 4));
    boxes.emplace_back(lo, hi);
    add_box(mesh, image(lo), image(hi));
  }
  const TriangleTree tree(mesh);
  std::vector<Point3> points;
  for (int i = 0; i < 300; ++i) points.push_back(draw.point(8) * 0.5 + Point3(1));
  std::vector<Side> due;
  for (const Point3& p : points) {
    int winding = 0;
    bool surface = false;
    for (const auto& [lo, hi] : boxes) {
      winding += strictly_between(lo, p, hi);
      surface |= weakly_between(lo, p, hi) && !strictly_between(lo, p, hi);
    }
    due.push_back(surface ? Side::boundary : winding % 2 == 1 ? Side::inside : Side::outside);
    require(tree.inside(image(p)) == due.back(), "inside");
    for (const Point3& d : {draw.point(3), draw.point(1), Point3(0), Point3(1, 0, 0)}) {
      const Parity c = tree.parity(Ray{image(p), {d}});
      require(c.on_surface == surface, "on the surface");
      require(surface ? c.winding == 0 && c.crossings == 0 : c.winding == winding, "winding");
      require(surface || c.crossings % 2 == static_cast<unsigned>(winding % 2), "parity");
    }
  }
  for (Point3& p : points) p = image(p);
  require(together<Side>(points, [&](auto q, auto a) { tree.inside(q, a); }) == due, "inside, in a batch");
}

// --- odd questions --------------------------------------------------------------------------------------------------

template <class Ask>
void require_refusal(const Ask& ask) {
  try {
    ask();
  } catch (const std::invalid_argument&) {
    return;
  }
  require(false, "lists that differ in length");
}

void check_odd_questions() {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const TriangleTree tree(std::span(&t, 1)), none(std::span<const Triangle>{});
  const Ray down{{1, 1, 1}, {{0, 0, -1}}};
  require(tree.closest(down)->id == 0 && tree.closest(down)->t == 1 && tree.bytes() > 0, "one triangle");
  require(!none.closest(down) && !none.any(down) && none.all(down).empty() && none.parity(down) == Parity{}, "none");
  require(none.inside({1, 1, 1}) == Side::outside && none.bytes() == 0, "no memory for none");
  for (const double x : {not_a_number, infinity, -infinity}) {
    std::vector<Ray> rays(20, down);
    rays[3].o.x = rays[7].d.v.z = x;
    require(!tree.closest(rays[3]) && !tree.any(rays[7]) && tree.all(rays[3]).empty(), "rays that are not finite");
    require(tree.parity(rays[7]) == Parity{} && tree.inside({x, 0, 0}) == Side::outside, "points that are not finite");
    require(!tree.any(Segment{{1, 1, 1}, {1, 1, -x}}), "segments that are not finite");
    const auto hits = together<std::optional<Nearest>>(rays, [&](auto q, auto a) { tree.closest(q, a); });
    for (std::size_t i = 0; i < 20; ++i) require(hits[i].has_value() == (i != 3 && i != 7), "beside finite ones");
  }
  std::vector<Ray> rays(2, down);
  std::vector<Segment> ways(2);
  std::vector<Point3> points(2);
  std::vector<std::optional<Nearest>> hits(1);
  std::vector<std::uint8_t> met(3);
  std::vector<Parity> parities(1);
  std::vector<Side> sides(1);
  std::vector<std::vector<Nearest>> all(1);
  require_refusal([&] { tree.closest(rays, hits); });
  require_refusal([&] { tree.any(std::span<const Ray>(rays), met); });
  require_refusal([&] { tree.any(std::span<const Segment>(ways), met); });
  require_refusal([&] { tree.parity(rays, parities); });
  require_refusal([&] { tree.inside(points, sides); });
  require_refusal([&] { tree.all(rays, all); });
}

/// The caller's rounding mode is no business of the tree.
void check_rounding() {
  for (const int mode : {FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
    Draw draw;
    const Scene s = drawn_scene(draw, 20, 12);
    std::vector<Triangle> placed = s.triangles;
    std::vector<std::optional<Nearest>> plain, turned;
    const auto ask = [&] {
      const TriangleTree tree(placed);
      std::vector<std::optional<Nearest>> hits;
      for (const Ray& r : s.rays) hits.push_back(tree.closest(r));
      return hits;
    };
    plain = ask();
    std::fesetround(mode);
    turned = ask();
    const bool kept = std::fegetround() == mode;
    std::fesetround(FE_TONEAREST);
    require(kept, "the rounding mode stays");
    for (std::size_t i = 0; i < plain.size(); ++i) {
      require(plain[i].has_value() == turned[i].has_value() &&
                  (!plain[i] || (plain[i]->id == turned[i]->id && plain[i]->t == turned[i]->t)),
              "in every rounding mode");
    }
  }
}

/// Many that are not alike walk as a stream; those that are not finite among them hit nothing.
void check_streams() {
  Draw draw;
  const Scene s = drawn_scene(draw, 60, 1);
  const TriangleTree tree(s.triangles), none(std::span<const Triangle>{});
  for (const std::size_t count : {3, 8, 9, 100, 1'500}) {
    std::vector<Ray> rays;
    while (rays.size() < count) rays.push_back({draw.point(60), {draw.point(9)}});
    if (count > 20) rays[17].o.z = infinity, rays[count - 1].d.v.x = not_a_number;
    const auto hits = together<std::optional<Nearest>>(rays, [&](auto q, auto a) { tree.closest(q, a); });
    const auto nothing = together<std::optional<Nearest>>(rays, [&](auto q, auto a) { none.closest(q, a); });
    for (std::size_t i = 0; i < count; ++i) {
      const auto alone = tree.closest(rays[i]);
      require(hits[i].has_value() == alone.has_value() && (!alone || hits[i]->id == alone->id), "a stream");
      require(!nothing[i], "a stream through nothing");
    }
  }
}

/// Triangles of which each is half as large as the one before, around one point: the deepest of trees, all boxes of
/// which are met by the rays through that point.
void check_deep() {
  Draw draw;
  Scene s;
  for (int i = 0; i < 100; ++i) {
    for (int copy = 0; copy < 9; ++copy) {
      const double size = std::ldexp(1.0, -i), height = size * (copy - 4) / 16;
      s.triangles.push_back({{-size, -size, height}, {size, -size, height}, {0, size, height}});
    }
  }
  for (int i = 0; i < 12; ++i) {
    const Point3 from(draw.within(-8, 8), draw.within(-8, 8), 8 + i);
    s.rays.push_back({from, {-from}});
  }
  check_scene(s, here, fractions);
}

/// A judge whose word is not exact: a hit may lie outside of its face's box.
struct Inexact : CertifiedRay {
  using CertifiedRay::CertifiedRay;
  static bool is_exact() { return false; }
  Span span(Place p, std::uint32_t id) const { return id % 2 == 0 ? Span{1, 0} : CertifiedRay::span(p, id); }
};

void check_inexact() {
  Draw draw;
  const Scene s = slivers(draw);
  const WideTree tree(static_cast<std::uint32_t>(s.triangles.size()), [&](std::uint32_t i) {
    return Primitive{box_of(s.triangles[i]), s.triangles[i]};
  });
  for (const Ray& r : s.rays) {
    const WideProbe probe(r, tree.frame());
    Inexact judge(tree, r);
    ClosestQuery<Inexact> query(tree, probe, judge);
    WalkCounts counts;
    tree_target().filter_ray(tree, probe, r, query, counts);
    const std::vector<std::uint32_t> due = seen(r, s.triangles, fractions);
    require(query.best().has_value() == !due.empty(), "an inexact judge");
    require(due.empty() || query.best()->id == due[0], "the closest hit of an inexact judge");
    require(query.certain() <= due.size(), "certain hits are hits");
  }
}

void check_parities() {
  require(Parity{} == Parity{} && !(Parity{true} == Parity{}), "on the surface or not");
  require(!(Parity{false, 1} == Parity{}) && !(Parity{false, 0, 1} == Parity{}), "crossings and windings");
}

}  // namespace

int main() {
  Draw draw;
  for (const Image& image : {here, Image{0x1p-40, 0}, Image{0x1p-1040, 0}, Image{0x1p600, 0}, Image{0x1p1013, 0},
                             Image{1, 0x1p20}, Image{1, 0x1p44}}) {
    check_scene(drawn_scene(draw, 40, 60), image, integers);
    check_scene(drawn_scene(draw, 3, 20), image, integers);
    check_inside(draw, image);
  }
  check_scene(drawn_scene(draw, 400, 60), here, integers);
  check_scene(slivers(draw), here, fractions);
  Scene many = drawn_scene(draw, 5'000, 3);
  many.rays.resize(std::min<std::size_t>(many.rays.size(), 12));
  many.ways.resize(std::min<std::size_t>(many.ways.size(), 12));
  check_scene(many, here, integers);
  check_odd_questions();
  check_rounding();
  check_streams();
  check_deep();
  check_inexact();
  check_parities();
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  check_scene(drawn_scene(draw, 40, 10), here, integers);
  check_boxes();
  check_packets();
}
