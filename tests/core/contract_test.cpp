// The prose of a contract, and what it owes, for each value of its fields.
#include "core/contract.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/capability.h"
#include "core/due.h"
#include "core/rivals/adapter.h"
#include "core/rivals/moeller_trumbore.h"

namespace tribunal {
namespace {

TEST(Contract, ProseIsMadeOfEveryValue) {
  EXPECT_EQ(in_words({}), "segment, ray; any triangle");
  EXPECT_EQ(in_words({.polygons = Polygons::any}), "segment, ray; any triangle or polygon");
  EXPECT_EQ(in_words({.polygons = Polygons::planar}), "segment, ray; any triangle, planar polygon");
  EXPECT_EQ(in_words({.probes = {.rays = false}, .triangles = Triangles::proper}),
            "segment; triangle, no degenerate operand");
  EXPECT_EQ(in_words({.probes = {.segments = false}, .culling = Culling::back_faces}),
            "ray; any triangle, back faces culled");
  EXPECT_EQ(
      in_words({.triangles = Triangles::none, .polygons = Polygons::planar, .polygon_boundary = Boundary::unspecified}),
      "segment, ray; planar polygon, no boundary");
  EXPECT_EQ(in_words({.polygons = Polygons::any, .polygon_boundary = Boundary::unspecified}),
            "segment, ray; any triangle or polygon, no polygon boundary");
  EXPECT_EQ(in_words({.polygons = Polygons::any, .boundary = Boundary::open, .polygon_boundary = Boundary::open}),
            "segment, ray; any triangle or polygon, open boundary");
  EXPECT_EQ(in_words({.boundary = Boundary::half_open, .ends = Ends::open}),
            "segment, ray; any triangle, half-open edges, open ends");
  EXPECT_EQ(in_words({.ends = Ends::unspecified}), "segment, ray; any triangle, no ends");
  EXPECT_EQ(in_words({.probes = {.bounds = true}}), "segment, ray, bounded ray; any triangle");
  EXPECT_EQ(in_words({.probes = {.bounds = true}, .bounds = Ends::open}),
            "segment, ray, bounded ray; any triangle, open bounds");
  EXPECT_EQ(in_words({.probes = {.bounds = true}, .bounds = Ends::unspecified}),
            "segment, ray, bounded ray; any triangle, bounds unspecified");
}

/// Two contracts with different restrictions have different prose.
TEST(Contract, ProseTellsRestrictionsApart) {
  std::set<std::string> words;
  std::size_t contracts = 0;
  for (const Boundary of_triangles : {Boundary::closed, Boundary::open, Boundary::half_open, Boundary::unspecified}) {
    for (const Boundary of_polygons : {Boundary::closed, Boundary::open, Boundary::half_open, Boundary::unspecified}) {
      for (const Ends ends : {Ends::closed, Ends::open, Ends::unspecified}) {
        for (const Culling culling : {Culling::none, Culling::back_faces}) {
          for (const Triangles triangles : {Triangles::any, Triangles::proper}) {
            ++contracts;
            words.insert(in_words({.triangles = triangles,
                                   .polygons = Polygons::any,
                                   .boundary = of_triangles,
                                   .polygon_boundary = of_polygons,
                                   .ends = ends,
                                   .culling = culling}));
          }
        }
      }
    }
  }
  EXPECT_EQ(words.size(), contracts);
}

constexpr Facts crossing(Contact contact, Facing facing = Facing::front, At at = At::between) {
  return {.contact = contact, .boundary = contact != Contact::interior, .at = at, .facing = facing};
}

constexpr Facts coplanar(bool boundary) { return {.contact = Contact::coplanar, .boundary = boundary}; }

TEST(Due, PointSetsMeetOrTheyDoNot) {
  for (const Contact c : {Contact::interior, Contact::edge, Contact::vertex}) {
    EXPECT_EQ(due({}, crossing(c)), Due::hit);
    EXPECT_EQ(due({.convention = Convention::transversal}, crossing(c)), Due::hit);
    EXPECT_EQ(due({}, crossing(c, Facing::back, At::source)), Due::hit);
  }
  EXPECT_EQ(due({}, {}), Due::miss);
}

TEST(Due, CoplanarContactsByConvention) {
  for (const bool boundary : {false, true}) {
    EXPECT_EQ(due({}, coplanar(boundary)), Due::hit);
    EXPECT_EQ(due({.convention = Convention::transversal}, coplanar(boundary)), Due::miss);
    EXPECT_EQ(due({.convention = Convention::unspecified}, coplanar(boundary)), Due::nothing);
  }
  EXPECT_EQ(due({.boundary = Boundary::open}, coplanar(true)), Due::nothing) << "the boundary alone may be met";
  EXPECT_EQ(due({.boundary = Boundary::open}, coplanar(false)), Due::hit);
  EXPECT_EQ(due({.ends = Ends::open}, coplanar(false)), Due::nothing);
  EXPECT_EQ(due({.culling = Culling::back_faces}, coplanar(false)), Due::nothing) << "seen from neither side";
}

TEST(Due, BoundaryContacts) {
  struct Row {
    Boundary boundary;
    Due owed;
  };
  for (const auto& [boundary, owed] :
       {Row{Boundary::closed, Due::hit}, Row{Boundary::open, Due::miss}, Row{Boundary::half_open, Due::nothing},
        Row{Boundary::unspecified, Due::nothing}}) {
    const Contract c{.boundary = boundary};
    EXPECT_EQ(due(c, crossing(Contact::edge)), owed);
    EXPECT_EQ(due(c, crossing(Contact::vertex)), owed);
    EXPECT_EQ(due(c, crossing(Contact::interior)), Due::hit) << "away from the boundary nothing is excused";
    EXPECT_EQ(due(c, {}), Due::miss);
    Facts ring_edge = crossing(Contact::edge);
    ring_edge.of_polygon = true;
    EXPECT_EQ(due({.polygons = Polygons::any, .boundary = boundary}, ring_edge), Due::hit) << "polygons have their own";
    EXPECT_EQ(due({.polygons = Polygons::any, .polygon_boundary = boundary}, ring_edge), owed);
  }
}

TEST(Due, BackFacesAreMissed) {
  const Contract c{.culling = Culling::back_faces};
  for (const Contact contact : {Contact::interior, Contact::edge, Contact::vertex}) {
    EXPECT_EQ(due(c, crossing(contact, Facing::front)), Due::hit);
    EXPECT_EQ(due(c, crossing(contact, Facing::back)), Due::miss);
  }
  const Contract half_open{.boundary = Boundary::half_open, .culling = Culling::back_faces};
  EXPECT_EQ(due(half_open, crossing(Contact::edge, Facing::back)), Due::miss) << "culled, whoever owns the edge";
  EXPECT_EQ(due(half_open, crossing(Contact::edge, Facing::front)), Due::nothing);
  Facts polygon = crossing(Contact::interior, Facing::unsaid);
  polygon.of_polygon = true;
  EXPECT_EQ(due({.polygons = Polygons::any, .culling = Culling::back_faces}, polygon), Due::nothing);
}

TEST(Due, EndsOfTheProbe) {
  for (const At at : {At::source, At::target}) {
    EXPECT_EQ(due({.ends = Ends::open}, crossing(Contact::interior, Facing::front, at)), Due::miss);
    EXPECT_EQ(due({.ends = Ends::unspecified}, crossing(Contact::interior, Facing::front, at)), Due::nothing);
  }
  for (const Ends ends : {Ends::open, Ends::unspecified}) {
    EXPECT_EQ(due({.ends = ends}, crossing(Contact::edge)), Due::hit);
    EXPECT_EQ(due({.ends = ends}, crossing(Contact::edge, Facing::front, At::unsaid)), Due::nothing);
  }
}

TEST(Due, NothingOutsideTheOperands) {
  Facts ray = crossing(Contact::interior);
  ray.of_ray = true;
  EXPECT_EQ(due({.probes = {.rays = false}}, ray), Due::nothing);
  EXPECT_EQ(due({.probes = {.segments = false}}, ray), Due::hit);
  EXPECT_EQ(due({.probes = {.segments = false}}, crossing(Contact::interior)), Due::nothing);
  Facts flat{.degenerate = true};
  EXPECT_EQ(due({.triangles = Triangles::proper}, flat), Due::nothing);
  EXPECT_EQ(due({.triangles = Triangles::none}, crossing(Contact::interior)), Due::nothing);
  EXPECT_EQ(due({}, flat), Due::miss);
  Facts warped{.of_polygon = true, .planar = false};
  EXPECT_EQ(due({.polygons = Polygons::planar}, warped), Due::nothing);
  EXPECT_EQ(due({.polygons = Polygons::none}, warped), Due::nothing);
  EXPECT_EQ(due({.polygons = Polygons::any}, warped), Due::miss);
}

TEST(Due, FacingIsTheSideOfTheSource) {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};  // counterclockwise as seen from above
  const FormulaKernel<double> k;
  for (const double from : {1.0, 0.0}) {
    EXPECT_EQ(facing(Segment{{1, 1, from}, {1, 1, from - 1}}, t, k), Facing::front);
    EXPECT_EQ(facing(Segment{{1, 1, -from}, {1, 1, 1 - from}}, t, k), Facing::back);
    EXPECT_EQ(facing(Ray{{1, 1, from}, {{0, 0, -1}}}, t, k), Facing::front);
    EXPECT_EQ(facing(Ray{{1, 1, -from}, {{0, 0, 1}}}, t, k), Facing::back);
  }
}

TEST(Capabilities, AreWhatTheMethodHas) {
  Method m = published::rival_method<published::MoellerTrumbore<double>>();
  EXPECT_TRUE(has(m, Capability::order) && has(m, Capability::parameter) && has(m, Capability::weights));
  EXPECT_TRUE(has(m, Capability::bounds) && !has(m, Capability::side));
  for (const Capability c :
       {Capability::contact, Capability::class_id, Capability::batch, Capability::prepared_triangle,
        Capability::prepared_polygon, Capability::prepared_ray, Capability::tree_lanes, Capability::exact_twin}) {
    EXPECT_FALSE(has(m, c)) << name_of(c);
  }
  m.prepare_ray = [](const Ray&) -> PreparedRay { return {}; };
  m.prepare_triangle = [](const Triangle&) -> PreparedTriangle { return {}; };
  m.exact_twin = [](const Query&) { return miss(); };
  m.on_tree_lanes = m.tells_contact = m.tells_side = true;
  EXPECT_TRUE(has(m, Capability::side));
  for (const Capability c : {Capability::contact, Capability::prepared_triangle, Capability::prepared_ray,
                             Capability::tree_lanes, Capability::exact_twin}) {
    EXPECT_TRUE(has(m, c)) << name_of(c);
  }
}

TEST(Capabilities, MoellerTrumboreYieldsItsParameter) {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  EXPECT_EQ(published::rival_method<published::MoellerTrumbore<double>>().parameter(Ray{{1, 1, 3}, {{0, 0, -2}}}, t),
            1.5);
  EXPECT_EQ(published::rival_method<published::MoellerTrumbore<float>>().parameter(Ray{{9, 9, 3}, {{0, 0, -2}}}, t),
            std::nullopt);
}

}  // namespace
}  // namespace tribunal
