// The part of kill_tree.cpp that is about boxes, the probes that are made ready for them, and the tree that is built of
// them.
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include "tests/mutation/kill.h"
#include "tracer/accel/boxed_faces.h"
#include "tracer/accel/wide/bins.h"
#include "tracer/accel/wide/box.h"
#include "tracer/accel/wide/traversal.h"
#include "tracer/accel/wide/tree.h"

using namespace tribunal;
using namespace tribunal::killing;

namespace {

// --- one box --------------------------------------------------------------------------------------------------------

/// The parameters at which a line o + t·d is in a box, t from 0 to `end`, as fractions; empty if first > last.
struct Exact {
  mpq_class first = 0, last;
  bool endless = true, empty = false;
};

Exact exact_span(const Point3& o, const mpq_class (&d)[3], bool endless, const Box& b) {
  Exact s;
  s.endless = endless;
  s.last = 1;
  for (int i = 0; i < 3; ++i) {
    const mpq_class lo = mpq_class(b.lo[i]) - mpq_class(o[i]), hi = mpq_class(b.hi[i]) - mpq_class(o[i]);
    if (d[i] == 0) {
      s.empty |= lo > 0 || hi < 0;
      continue;
    }
    const mpq_class in = (d[i] > 0 ? lo : hi) / d[i], out = (d[i] > 0 ? hi : lo) / d[i];
    s.first = std::max(s.first, in);
    s.last = s.endless ? out : std::min(s.last, out);
    s.endless = false;
  }
  s.empty |= !s.endless && s.first > s.last;
  return s;
}

/// Whether no difference, direction or parameter is so small or so large that steps to neighbours are no small share of
/// it.
bool is_ordinary(const Point3& o, const Point3& d, const Box& b) {
  for (int i = 0; i < 3; ++i) {
    for (const double x : {d[i], b.lo[i] - o[i], b.hi[i] - o[i]}) {
      if (x != 0 && (std::fabs(x) < 0x1p-500 || std::fabs(x) > 0x1p500)) return false;
    }
  }
  return true;
}

/// The span holds the exact one, and is hardly wider.
void require_span(const Span& s, const Exact& exact, bool ordinary) {
  if (!exact.empty) {
    require(!s.empty() && s.first >= 0, "a box that is met");
    require(mpq_class(s.first) <= exact.first, "not entered before");
    require(std::isinf(s.last) || (!exact.endless && mpq_class(s.last) >= exact.last), "not left after");
    require(!ordinary || mpq_class(s.first) >= exact.first * (1 - mpq_class(0x1p-49)) - mpq_class(0x1p-1060),
            "hardly before");
    require(
        !ordinary || exact.endless || mpq_class(s.last) <= exact.last * (1 + mpq_class(0x1p-49)) + mpq_class(0x1p-1060),
        "hardly after");
  } else if (ordinary && !exact.endless &&
             exact.first - exact.last > (abs(exact.first) + abs(exact.last)) * mpq_class(0x1p-48)) {
    require(s.empty(), "a box that is clearly missed");
  }
}

void check_box(Draw& draw, int kind) {
  Box b;
  const Point3 u = draw.point_of(kind), v = draw.point_of(kind), p = draw.point_of(kind),
               q = draw.point_of(draw.below(3) == 0 ? kind : 0);
  if (!is_finite(u) || !is_finite(v) || !is_finite(p) || !is_finite(q)) return;
  b.add(u);
  b.add(v);
  for (int i = 0; i < 3; ++i) require(b.lo[i] == std::min(u[i], v[i]) && b.hi[i] == std::max(u[i], v[i]), "a box");
  const Triangle t{u, v, p};
  Box of_three = b;
  of_three.add(p);
  require(box_of(t).lo == of_three.lo && box_of(t).hi == of_three.hi, "a triangle's box");
  mpq_class d[3], way[3];
  for (int i = 0; i < 3; ++i) d[i] = q[i], way[i] = mpq_class(q[i]) - mpq_class(p[i]);
  require_span(BoxProbe(Ray{p, {q}}).span(b), exact_span(p, d, true, b), is_ordinary(p, q, b));
  require_span(BoxProbe(Segment{p, q}).span(b), exact_span(p, way, false, b), is_ordinary(p, q - p, b));
  // From a corner along an edge, and within a face.
  Point3 edge(0);
  edge[draw.below(3)] = draw.below(2) == 0 ? 1 : -1;
  for (int i = 0; i < 3; ++i) d[i] = edge[i];
  require_span(BoxProbe(Ray{b.lo, {edge}}).span(b), exact_span(b.lo, d, true, b), is_ordinary(b.lo, edge, b));
  require(above(u.x) > u.x && below(u.x) < u.x && above(infinity) == infinity && below(-infinity) == -infinity,
          "neighbours");
  require(above(u.x) == std::nextafter(u.x, infinity) && below(u.x) == std::nextafter(u.x, -infinity),
          "the next numbers");
}

// --- the tree -------------------------------------------------------------------------------------------------------

Box box_between(const Point3& u, const Point3& v) {
  Box b;
  b.add(u);
  b.add(v);
  return b;
}

std::vector<Primitive> drawn_primitives(Draw& draw, int count, int kind, bool with_boxes) {
  std::vector<Primitive> all;
  while (static_cast<int>(all.size()) < count) {
    const Triangle t{draw.point_of(kind), draw.point_of(kind), draw.point_of(kind)};
    if (!is_finite(t)) continue;
    const bool alone = with_boxes && draw.below(3) == 0;
    all.push_back({box_of(t), alone ? std::optional<Triangle>() : std::optional<Triangle>(t)});
    if (draw.below(6) == 0) all.push_back(all.back());  // equal centres
  }
  return all;
}

WideTree tree_of(const std::vector<Primitive>& all) {
  return WideTree(static_cast<std::uint32_t>(all.size()), [&](std::uint32_t i) { return all[i]; });
}

/// Every primitive is in one place, bit for bit, with those of its kind.
void require_places(const WideTree& tree, const std::vector<Primitive>& all) {
  std::vector<int> found(all.size());
  tree.for_each_place([&](Place p) {
    const std::uint32_t id = tree.id(p);
    ++found[id];
    const auto& t = all[id].triangle;
    require(p.leaf.holds_triangles() == t.has_value() && (t || p.leaf.count() == 1), "the kind of a leaf");
    const Triangle kept = tree.triangle(p);
    require(t ? kept.a == t->a && kept.b == t->b && kept.c == t->c : std::isnan(kept.a.x) && std::isnan(kept.c.z),
            "kept");
  });
  require(std::all_of(found.begin(), found.end(), [](int n) { return n == 1; }), "every primitive in one place");
  require(tree.bytes() >= all.size() * 80 && (tree.empty() == all.empty()), "bytes");
}

struct Collector final : CandidateQuery {
  explicit Collector(const WideTree& t) : tree(t) {}
  bool found(const Candidate& f) override {
    ids.insert(tree.id(f.place));
    return ids.size() >= most;
  }
  const WideTree& tree;
  std::size_t most = ~std::size_t{0};
  std::set<std::uint32_t> ids{};
};

/// Every primitive whose box is met at t ≤ the limit is a candidate, and not all others are.
std::size_t require_candidates(const WideTree& tree, const std::vector<Primitive>& all, const Ray& ray, double limit) {
  const WideProbe probe(ray, tree.frame());
  Collector collector(tree);
  collector.limit = probe.limit_at(limit);
  WalkCounts counts;
  tree_target().visit_all(tree, probe, collector, counts);
  mpq_class d[3];
  for (int i = 0; i < 3; ++i) d[i] = ray.d.v[i];
  for (std::uint32_t id = 0; id < all.size(); ++id) {
    const Exact s = exact_span(ray.o, d, true, all[id].box);
    const bool due = !s.empty && (std::isinf(limit) || s.first <= mpq_class(limit));
    require(!due || collector.ids.contains(id), "a primitive that is met");
  }
  // The filtering walks leave out triangles alone.
  Collector filtered(tree), along(tree);
  filtered.limit = collector.limit;
  tree_target().filter_ray(tree, probe, ray, filtered, counts);
  const Segment way{ray.o, ray.o + ray.d.v};
  const bool has_way = is_finite(way) && way.q != way.p;
  if (has_way) tree_target().filter_segment(tree, WideProbe(way, tree.frame()), way, along, counts);
  for (const std::uint32_t id : collector.ids) {
    require(all[id].triangle || filtered.ids.contains(id), "a primitive that no filter rules out");
  }
  for (const std::uint32_t id : filtered.ids) require(collector.ids.contains(id), "a candidate of the filter");
  for (std::uint32_t id = 0; has_way && id < all.size(); ++id) {
    mpq_class to[3];
    for (int i = 0; i < 3; ++i) to[i] = mpq_class(way.q[i]) - mpq_class(way.p[i]);
    const bool due = !all[id].triangle && !exact_span(way.p, to, false, all[id].box).empty;
    require(!due || along.ids.contains(id), "a primitive on the way");
  }
  Collector one(tree);
  one.most = 1;
  tree_target().visit_all(tree, probe, one, counts);
  require(one.ids.size() == std::min<std::size_t>(1, collector.ids.size()) || !std::isinf(limit),
          "a walk that is stopped");
  return collector.ids.size();
}

bool same(const WideProbe& a, const WideProbe& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    const WideProbe::Axis &x = a.axes[i], &y = b.axes[i];
    if (x.r != y.r || x.near_c != y.near_c || x.far_c != y.far_c || x.near_plane != y.near_plane ||
        x.far_plane != y.far_plane)
      return false;
  }
  return a.scale == b.scale;
}

void check_tree(Draw& draw, int count, int kind, bool with_boxes) {
  const std::vector<Primitive> all = drawn_primitives(draw, count, kind, with_boxes);
  const WideTree tree = tree_of(all);
  require_places(tree, all);
  std::vector<Ray> rays;
  std::size_t candidates = 0, asked = 0;
  for (int n = 0; n < 40; ++n) {
    const Point3 o = draw.point_of(kind), d = draw.point_of(draw.below(2) == 0 ? kind : 6);
    if (!is_finite(o) || !is_finite(d)) continue;
    const Primitive& p = all[static_cast<std::size_t>(draw.below(static_cast<int>(all.size())))];
    rays.push_back(n % 2 == 0 ? Ray{o, {d}} : Ray{o, {p.box.lo - o}});
    if (!is_finite(rays.back().d.v)) rays.back().d.v = d;
    candidates += require_candidates(tree, all, rays.back(), n % 3 == 0 ? 1.0 : infinity);
    asked += all.size();
  }
  if (kind == 4 && count > 200) require(candidates < asked / 2, "most primitives are left out");
  std::vector<WideProbe> probes(rays.size());
  tree_target().make_probes(rays, tree.frame(), probes.data());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    require(same(probes[i], WideProbe(rays[i], tree.frame())), "probes made together");
  }
  rays.resize(3, Ray{});
  rays[1].o.y = not_a_number;
  probes.resize(3);
  tree_target().make_probes(rays, tree.frame(), probes.data());
  require(std::isnan(probes[1].scale) && !std::isnan(probes[0].scale), "a probe that is no number");
}

/// Too many for one thread's work; and so many cuts that the rest is halved by number, along each axis.
void check_large_trees(Draw& draw) {
  const std::vector<Primitive> many = drawn_primitives(draw, 40'000, 4, false);
  const WideTree tree = tree_of(many);
  require_places(tree, many);
  require_candidates(tree, many, Ray{{2, 2, 2}, {{-1, -1.5, -1.25}}}, infinity);
  for (int least = 0; least < 3; ++least) {
    // Ever nearer to 0 on each axis, the frame's centre, towards which binary32 tells ever smaller distances apart:
    // each cut takes a few from the end of one axis, of which one ends sooner.
    std::vector<Primitive> nested{{box_between(Point3(-2), Point3(2)), {}}};
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < (axis == least ? 50 : 98); ++i) {
        Point3 at(0);
        at[axis] = std::ldexp(1.0, -i);
        for (int copy = 0; copy < 2; ++copy) nested.push_back({box_between(at, at), {}});
      }
    }
    const WideTree deep = tree_of(nested);
    require_places(deep, nested);
    require_candidates(deep, nested, Ray{{4, 4, 4}, {{-1, -1, -1}}}, infinity);
    require_candidates(deep, nested, Ray{{4, 0, 0}, {{-1, 0, 0}}}, infinity);
  }
  const Float4 p{1, 2, 3, 0};
  std::vector<FrameBox> boxes(1);
  FrameBox& box = boxes[0];
  require(box.area() == 0, "an empty box has no area");
  box.add(p);
  box.add(2 * p);
  require(box.area() == 2 + 6 + 3, "half of the surface");
}

void check_refs() {
  for (const std::uint32_t first : {0U, 5U, NodeRef::most_primitives - 1}) {
    for (std::uint32_t count = 1; count <= 8; ++count) {
      for (const bool triangles : {false, true}) {
        const NodeRef r = NodeRef::leaf(first, count, triangles);
        require(r.is_leaf() && r.first() == first && r.count() == count && r.holds_triangles() == triangles, "a leaf");
      }
    }
    require(!NodeRef::node(first).is_leaf() && NodeRef::node(first).index() == first, "a node");
  }
  require(half_of(9) == 4 && half_of(8) == 4 && most_halvings(1) == 0 && most_halvings(5) == 3, "halves");
  try {
    const WideTree too_large(NodeRef::most_primitives + 1, [](std::uint32_t) { return Primitive{}; });
    require(false, "too many primitives");
  } catch (const std::length_error&) {
  }
}

// --- faces by mode --------------------------------------------------------------------------------------------------

void check_faces(Draw& draw, Accel mode) {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> solid_of;
  std::vector<std::int32_t> polygon_of;
  std::vector<Box> polygon_boxes;
  for (std::uint32_t solid = 0; solid < 6; ++solid) {
    const Point3 at = draw.point(20);
    for (int n = draw.within(1, 5); n > 0; --n) {
      const Triangle t{at + draw.point(3), at + draw.point(3), at + draw.point(3)};
      triangles.push_back(t);
      solid_of.push_back(solid);
      polygon_of.push_back(draw.below(3) == 0 ? static_cast<std::int32_t>(polygon_boxes.size()) : -1);
      if (polygon_of.back() < 0) continue;
      polygon_boxes.push_back(box_of(t));
      polygon_boxes.back().add(at + draw.point(9));
    }
  }
  const FaceList list{triangles, solid_of, polygon_of, polygon_boxes};
  const BoxedFaces faces(mode, list);
  require(faces.size() == triangles.size() && (faces.tree() != nullptr) == (mode == Accel::bvh) && faces.bytes() > 0,
          "faces");
  for (std::uint32_t id = 0; id < triangles.size(); ++id) {
    require(faces[id].a == triangles[id].a && faces[id].b == triangles[id].b && faces[id].c == triangles[id].c,
            "a face by id");
  }
  if (mode == Accel::bvh) return;
  for (int n = 0; n < 60; ++n) {
    const Ray ray{draw.point(25), {draw.point(5)}};
    const BoxProbe probe(ray);
    const double limit = n % 2 == 0 ? infinity : 2.5;
    BoxedFaces::Waiting waiting{{7.0, 7}};
    RayTally tally;
    std::vector<std::uint32_t> visited;
    faces.visit(probe, limit, waiting, tally, [&](std::uint32_t id) {
      visited.push_back(id);
      return false;
    });
    require(tally.box_tests == (mode == Accel::boxes ? 6U : 0U), "a box a solid");
    std::set<std::uint32_t> due;
    std::vector<double> entries;
    for (std::uint32_t id = 0; id < triangles.size(); ++id) {
      Box solid;
      for (std::uint32_t other = 0; other < triangles.size(); ++other) {
        if (solid_of[other] == solid_of[id]) solid.add(list.box(other));
      }
      const Span s = probe.span(solid);
      if (mode == Accel::none || (!s.empty() && s.first <= limit)) due.insert(id);
    }
    require(std::set<std::uint32_t>(visited.begin(), visited.end()) == due && visited.size() == due.size(),
            "faces visited");
    if (visited.empty()) continue;
    int count = 0;
    faces.visit(probe, limit, waiting, tally, [&](std::uint32_t) { return ++count == 2; });
    require(count == static_cast<int>(std::min<std::size_t>(2, visited.size())), "a visit that ends");
  }
}

void check_names() {
  require(name_of(Accel::none) == "none" && name_of(Accel::boxes) == "boxes" && name_of(Accel::bvh) == "bvh", "names");
  require(BoxedFaces().size() == 0 && BoxedFaces().tree() == nullptr, "no faces");
}

}  // namespace

void check_boxes() {
  Draw draw;
  for (int n = 0; n < 100 * Draw::kinds; ++n) check_box(draw, n % Draw::kinds);
  for (const int kind : {0, 4, 5, 6, 7}) {
    for (const int count : {1, 2, 9, 70, 300}) check_tree(draw, count, kind, count % 2 == 0);
  }
  check_tree(draw, 5'000, 4, false);
  check_large_trees(draw);
  check_refs();
  for (int n = 0; n < 10; ++n) {
    for (const Accel mode : {Accel::none, Accel::boxes, Accel::bvh}) check_faces(draw, mode);
  }
  check_names();
}
