// Tests of the tests: known bugs, planted in an exact method so that nothing else can be blamed, must be found by fuzz.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <map>

#include "core/segura_feito.h"
#include "exact/harness/fuzz.h"
#include "exact/kernels/cgal_kernels.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

const EpickKernel exact;

using Decision = Answer (*)(const Segment&, const Triangle&);

Answer right(const Segment& s, const Triangle& t) { return segura_feito(s, t, exact); }

/// The published loop over the five signs, with one line changed by `spoil`.
struct FiveSigns {
  int source, target, edge[3];
};

FiveSigns signs_of(const Segment& s, const Triangle& t) {
  return {value(exact.orient3d(t.a, t.b, t.c, s.p)),
          value(exact.orient3d(t.a, t.b, t.c, s.q)),
          {value(exact.orient3d(s.p, t.a, t.b, s.q)), value(exact.orient3d(s.p, t.b, t.c, s.q)),
           value(exact.orient3d(s.p, t.c, t.a, s.q))}};
}

/// Right for operands in general position if nothing is spoilt.
bool crosses(const FiveSigns& v) {
  const int side = v.source != 0 ? v.source : -v.target;
  for (const int e : v.edge) {
    if (side * e > 0) return false;
  }
  return v.source * v.target <= 0;
}

bool is_flat(const FiveSigns& v) { return v.source == 0 && v.target == 0; }

template <class Spoil>
Answer spoilt(const Segment& s, const Triangle& t, const Spoil& spoil) {
  FiveSigns v = signs_of(s, t);
  if (is_flat(v)) return right(s, t);
  spoil(v);
  return crosses(v) ? hit_at(Contact::unsaid) : miss();
}

Answer without(Contact contact, const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.contact == contact ? miss() : answer;
}

Answer jimenez_ported(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.at == At::source ? miss() : answer;
}

Answer target_excluded(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  return answer.at == At::target ? miss() : answer;
}

Answer edge_sign_flipped(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) { v.edge[1] = -v.edge[1]; });
}

Answer third_edge_in_wrong_order(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) { v.edge[2] = -v.edge[2]; });
}

Answer zero_disables_the_reject(const Segment& s, const Triangle& t) {
  return spoilt(s, t, [](FiveSigns& v) {
    if (v.edge[0] == 0 || v.edge[1] == 0 || v.edge[2] == 0) v.edge[0] = v.edge[1] = v.edge[2] = 0;
  });
}

Answer edge_excluded(const Segment& s, const Triangle& t) { return without(Contact::edge, s, t); }
Answer vertex_excluded(const Segment& s, const Triangle& t) { return without(Contact::vertex, s, t); }
Answer coplanar_always_false(const Segment& s, const Triangle& t) { return without(Contact::coplanar, s, t); }

Answer coplanar_by_ends_only(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  if (answer.contact != Contact::coplanar) return answer;
  return right({s.p, s.p}, t).hit || right({s.q, s.q}, t).hit ? answer : miss();
}

/// A segment strictly inside, in the plane, meets no edge.
Answer coplanar_by_edges_only(const Segment& s, const Triangle& t) {
  const Answer answer = right(s, t);
  if (answer.contact != Contact::coplanar) return answer;
  const Triangle edges[] = {{t.a, t.b, t.b}, {t.b, t.c, t.c}, {t.c, t.a, t.a}};
  for (const Triangle& e : edges) {
    if (right(s, e).hit) return answer;
  }
  return miss();
}

Answer segment_as_ray(const Segment& s, const Triangle& t) { return segura_feito(Ray{s.p, {s.q - s.p}}, t, exact); }

Answer segment_as_line(const Segment& s, const Triangle& t) {
  const Point3 d = s.q * 0.5 - s.p * 0.5;  // halves, so that no difference overflows
  const Answer ahead = segura_feito(Ray{s.p, {d}}, t, exact);
  return ahead.hit ? ahead : segura_feito(Ray{s.p, {-d}}, t, exact);
}

struct ProjectsToXy : EpickKernel {
  template <class X>
  Sign orient2d(Axis, const Point3& a, const Point3& b, const X& x) const {
    return EpickKernel::orient2d(Axis::z, a, b, x);
  }
};

Answer always_projects_to_xy(const Segment& s, const Triangle& t) { return segura_feito(s, t, ProjectsToXy{}); }

struct MinusZeroIsLess : EpickKernel {
  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    const Sign plain = EpickKernel::compare(axis, a, x);
    if constexpr (std::is_same_v<X, Point3>) {
      const auto i = static_cast<int>(axis);
      if (plain == Sign::zero && std::signbit(a[i]) != std::signbit(x[i])) {
        return std::signbit(a[i]) ? Sign::positive : Sign::negative;
      }
    }
    return plain;
  }
};

Answer minus_zero_is_less(const Segment& s, const Triangle& t) { return segura_feito(s, t, MinusZeroIsLess{}); }

Point3 flushed(Point3 p) {
  for (int i = 0; i < 3; ++i) p[i] = std::fabs(p[i]) < 0x1p-1022 ? 0 : p[i];
  return p;
}

Answer subnormals_are_zero(const Segment& s, const Triangle& t) {
  return right({flushed(s.p), flushed(s.q)}, {flushed(t.a), flushed(t.b), flushed(t.c)});
}

Answer coordinates_through_binary32(const Segment& s, const Triangle& t) {
  const auto f = [](const Point3& p) {
    const Point3 rounded = in_format(p, Format::binary32);
    return is_finite(rounded) ? rounded : p;
  };
  return right({f(s.p), f(s.q)}, {f(t.a), f(t.b), f(t.c)});
}

/// Not a law of the plane: the first two vertices decide alone whether a triangle has area.
Answer area_seen_from_two_vertices(const Segment& s, const Triangle& t) { return t.a == t.b ? miss() : right(s, t); }

struct Bug {
  const char* name;
  Decision decide;
};

constexpr Bug bugs[] = {
    {"Jimenez's branch w = 0 as ported", jimenez_ported},
    {"< for <= at the target", target_excluded},
    {"< for <= at an edge", edge_excluded},
    {"< for <= at a vertex", vertex_excluded},
    {"one edge sign flipped", edge_sign_flipped},
    {"third edge in the wrong order", third_edge_in_wrong_order},
    {"one zero sign disables the reject", zero_disables_the_reject},
    {"coplanar is always false", coplanar_always_false},
    {"coplanar by ends only", coplanar_by_ends_only},
    {"coplanar by edges only", coplanar_by_edges_only},
    {"always projects to xy", always_projects_to_xy},
    {"segment treated as ray", segment_as_ray},
    {"segment treated as line", segment_as_line},
    {"-0 is less than 0", minus_zero_is_less},
    {"subnormals are zero", subnormals_are_zero},
    {"coordinates through binary32", coordinates_through_binary32},
    {"two equal vertices are a miss", area_seen_from_two_vertices},
};

std::vector<Method> planted() {
  std::vector<Method> methods;
  for (const Bug& bug : bugs) {
    Method m = *find_method("sf-epick");
    m.name = bug.name;
    m.segment = bug.decide;
    methods.push_back(m);
  }
  methods.push_back(*find_method("sf-epick"));
  return methods;
}

TEST(PlantedBugs, AreEachFoundAndNobodyElseIsBlamed) {
  FuzzPlan plan;
  plan.methods = planted();
  plan.streams = all_streams();
  plan.seed = 20240229;
  plan.cases = 26 * 1000;
  plan.threads = 2;
  const FuzzReport report = fuzz(plan);
  std::map<std::size_t, std::uint64_t> first;
  for (const Finding& f : report.findings) {
    const std::uint64_t g = f.k * plan.streams.size() + f.stream;
    const auto [entry, fresh] = first.try_emplace(f.method, g);
    entry->second = std::min(entry->second, g);
  }
  for (std::size_t m = 0; m < std::size(bugs); ++m) {
    ASSERT_TRUE(first.contains(m)) << bugs[m].name << " was not found in " << plan.cases << " cases";
    std::printf("  %-36s found after %6llu cases\n", bugs[m].name, static_cast<unsigned long long>(first[m] + 1));
  }
  EXPECT_FALSE(first.contains(std::size(bugs))) << "the method without a bug is blamed";
}

}  // namespace
}  // namespace tribunal
