// Kills mutants of the predicate headers: returns 0 iff signs, decisions and classes are right on small integers, where
// int64 is exact. Only headers are included, so that a mutated copy of one is all that differs. What is right comes
// from the class tables of segments and rays (arguments 1 and 2), from Carathéodory's theorem, and from a few values
// worked out by hand.
#include "tests/mutation/kill.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/kernel.h"
#include "core/segura_feito.h"
#include "exact/classes/chirotope.h"
#include "exact/oracles/caratheodory.h"

using namespace tribunal;
using killing::require;

namespace {

using Integers = FormulaKernel<std::int64_t>;
const Integers k;

/// A segment or a ray by its two columns: p and q, or o and d.
Segment probe_of(const Segment*, const Point3& p, const Point3& q) { return {p, q}; }
Ray probe_of(const Ray*, const Point3& o, const Point3& d) { return {o, {d}}; }

struct Class {
  int id, rank;
  bool hit;
  char touched;              ///< the triangle's part: F, E or V, or the end of what the table says instead
  unsigned long long count;  ///< unordered tuples of {0,1,2}³; of rays, with directions of {-1,0,1}³
  Point3 v[5];
};

/// The classes of segments, or of rays.
template <class P>
struct Table {
  static constexpr int size = std::is_same_v<P, Segment> ? 163 : 165;
  inline static Class classes[size];
  inline static int class_of_code[5][59049];  ///< the class of a chirotope, by rank and code; 0: none entered yet
};

Class class_in(const char* line) {
  Class c{};
  char intersection[20], touches[40];
  int x[15], n = 0;
  const int read = std::sscanf(line, "%*c%d %d %*s %*s %19s %39[^\t] %llu %*s%n", &c.id, &c.rank, intersection, touches,
                               &c.count, &n);
  if (read != 5) std::exit(2);
  c.hit = std::strcmp(intersection, "empty") != 0;
  c.touched = touches[std::strlen(touches) - 1];
  const char* rest = line + n;
  for (int i = 0; i < 15; ++i, rest += n) {
    if (std::sscanf(rest, " %d%n", &x[i], &n) != 1) std::exit(2);
    n += rest[n] == ',';
  }
  for (int i = 0; i < 5; ++i) c.v[i] = Point3(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
  return c;
}

template <class P>
void read_classes(const char* path) {
  std::FILE* const file = std::fopen(path, "r");
  char line[256];
  int rows = -1;  // the heading
  while (file != nullptr && std::fgets(line, sizeof line, file) != nullptr) {
    if (rows >= Table<P>::size) std::exit(2);
    if (rows >= 0) Table<P>::classes[rows] = class_in(line);
    ++rows;
  }
  if (rows != Table<P>::size) std::exit(2);
}

Contact contact_of(const Class& c) {
  if (!c.hit) return Contact::none;
  if (c.rank < 4) return Contact::coplanar;
  return c.touched == 'F' ? Contact::interior : c.touched == 'E' ? Contact::edge : Contact::vertex;
}

constexpr int vertex_orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

Point3 axis_image(const Point3& p, int order, int negatives) {
  Point3 r;
  for (int i = 0; i < 3; ++i)
    r[i] = (negatives >> i & 1) != 0 ? -p[vertex_orders[order][i]] : p[vertex_orders[order][i]];
  return r;
}

/// Signs worked out by hand: of a unit frame, of its mirror images, and with directions.
void signs_by_hand() {
  const Point3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  require(k.orient3d(o, x, y, z) == Sign::positive, "orient3d of the frame");
  require(k.orient3d(o, y, x, z) == Sign::negative, "orient3d of the mirrored frame");
  require(k.orient3d(x, y, z, Direction{x}) == Sign::positive, "orient3d towards infinity");
  require(k.orient3d(x, x + y, x + z, x) == Sign::zero, "orient3d of four points in a plane");
  require(k.orient2d(Axis::z, o, x, y) == Sign::positive, "orient2d without z");
  require(k.orient2d(Axis::x, o, y, z) == Sign::positive, "orient2d without x");
  require(k.orient2d(Axis::y, o, z, x) == Sign::positive, "orient2d without y");
  require(k.orient2d(Axis::z, x, x + x, Direction{y}) == Sign::positive, "orient2d towards infinity");
  const Point3 p(1, 2, 3);
  for (const Axis axis : all_axes) {
    require(k.compare(axis, p, p) == Sign::zero, "compare with itself");
    for (const Axis along : all_axes) {
      Point3 q = p;
      q[static_cast<int>(along)] += 2;
      require(k.compare(axis, p, q) == (axis == along ? Sign::positive : Sign::zero), "compare");
      require(k.compare(axis, q, p) == (axis == along ? Sign::negative : Sign::zero), "compare backwards");
    }
  }
  require(value(-Sign::positive) == -1 && value(Sign::negative * Sign::negative) == 1, "arithmetic of signs");
  require(lift<std::int64_t>(p).y == 2 && value(detail::lexicographic(o, p, k)) == 1, "lift");
}

/// One chirotope of each rank, worked out by hand.
void chirotopes_by_hand() {
  require(!(Chirotope{4, 201} == Chirotope{3, 201}) && !(Chirotope{4, 201} == Chirotope{4, 202}), "not the same");
  const Point3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  require(chirotope(Segment{z, o}, Triangle{o, x, y}, k) == Chirotope{4, 201}, "rank 4: + 0 0 0 -");
  require(chirotope(Segment{o, o}, Triangle{o, x, y}, k) == Chirotope{3, 49243}, "rank 3: + 0 0 0 0 0 + + 0 0");
  require(chirotope(Segment{x * 3.0, x * 4.0}, Triangle{o, x, x + x}, k) == Chirotope{2, 59048}, "rank 2: all +");
  require(chirotope(Segment{x, x}, Triangle{x, x, x}, k) == Chirotope{1, 0}, "rank 1: nothing");
}

/// The ray (1,1,1)·(1 + t) reaches the plane x + y + z = h at t = h/3 − 1, from 0 on.
void hit_order() {
  const auto plane = [](double h) { return Triangle{{h, 0, 0}, {0, h, 0}, {0, 0, h}}; };
  const auto turned = [](const Triangle& t) { return Triangle{t.b, t.a, t.c}; };
  for (const double direction : {1.0, -1.0}) {
    const Ray r{Point3(direction), {Point3(direction)}};
    for (int i = 3; i <= 6; ++i) {
      for (int j = 3; j <= 6; ++j) {
        const Sign order = sign_of(i - j);
        const Triangle s = plane(i * direction), t = plane(j * direction);
        require(k.compare_hits(r, s, t) == order && k.compare_hits(r, turned(s), t) == order &&
                    k.compare_hits(r, s, turned(t)) == order && k.compare_hits(r, turned(s), turned(t)) == order,
                "order of hits");
      }
    }
    const auto at = hit_parameter<std::int64_t>(r, plane(5 * direction));
    require(3 * at.num == 2 * at.den && at.den != 0, "hit parameter");
  }
  const Ray off{{1, 0, 0}, {{1, 2, 3}}};
  const auto at = hit_parameter<std::int64_t>(off, plane(4));
  require(at.num * 2 == at.den && at.den != 0, "hit parameter off the origin");
}

template <class P>
int& entry(const Chirotope& c) {
  require(c.rank >= 1 && c.rank <= 4 && c.code < 59049, "chirotope out of range");
  return Table<P>::class_of_code[c.rank][c.code];
}

/// A chirotope belongs to one class; each class brings its labelled orders and their mirror images.
template <class P>
void enter(const Chirotope& c, int id) {
  require(entry<P>(c) == 0 || entry<P>(c) == id, "one chirotope in two classes");
  entry<P>(c) = id;
}

template <class P>
void expect_decision(const Class& c, const P& probe, const Triangle& t) {
  const Answer answer = segura_feito(probe, t, k);
  require(answer.hit == c.hit && answer.contact == contact_of(c), "decision against the class table");
  require(meets_by_caratheodory<std::int64_t>(probe, t) == c.hit, "Caratheodory against the class table");
}

template <class P>
void enter_class(const Class& c, const P& probe, const Triangle& t) {
  expect_decision(c, probe, t);
  const Chirotope chi = chirotope(probe, t, k);
  require(chi.rank == c.rank, "rank against the class table");
  enter<P>(chi, c.id);
}

/// All classes × the labelled orders (12 of a segment, 6 of a ray) × 48 signed axis permutations.
template <class P>
void pocket_run() {
  constexpr P* which = nullptr;
  for (const Class& c : Table<P>::classes) {
    for (int image = 0; image < 48; ++image) {
      Point3 v[5];
      for (int i = 0; i < 5; ++i) v[i] = axis_image(c.v[i], image / 8, image % 8);
      for (const auto& order : vertex_orders) {
        const Triangle t{v[order[0]], v[order[1]], v[order[2]]};
        enter_class(c, probe_of(which, v[3], v[4]), t);
        if constexpr (std::is_same_v<P, Segment>) enter_class(c, Segment{v[4], v[3]}, t);
      }
    }
  }
}

Answer crossing(Contact contact, At at, bool from_front) {
  Answer answer = hit_at(contact, at);
  answer.facing = from_front ? Facing::front : Facing::back;
  return answer;
}

/// Where the triangle's corner, edge or inside is touched by an end, the answer says which end, and from which side.
void ends() {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Point3 on[] = {{1, 1, 0}, {2, 0, 0}, {4, 0, 0}};
  const Contact contacts[] = {Contact::interior, Contact::edge, Contact::vertex};
  for (int i = 0; i < 3; ++i) {
    for (const double z : {1.0, -1.0}) {
      const Point3 up = on[i] + Point3(0, 0, z), down = on[i] - Point3(0, 0, z);
      require(segura_feito(Segment{on[i], up}, t, k) == crossing(contacts[i], At::source, z < 0), "at the source");
      require(segura_feito(Segment{up, on[i]}, t, k) == crossing(contacts[i], At::target, z > 0), "at the target");
      require(segura_feito(Segment{up, down}, t, k) == crossing(contacts[i], At::between, z > 0), "between");
      require(segura_feito(Ray{up, {down - up}}, t, k) == crossing(contacts[i], At::between, z > 0),
              "between, on a ray");
      require(segura_feito(Ray{on[i], {up}}, t, k) == crossing(contacts[i], At::source, z < 0), "at a ray's origin");
    }
  }
}

/// Parts of a ray: one that is a point at the plane crosses it all the same.
void bounds() {
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Ray down{{1, 1, 2}, {{0, 0, -1}}}, beside{{5, 5, 2}, {{0, 0, -1}}}, within{{1, 1, 0}, {{1, 0, 0}}};
  const auto at = [&](double tmin, double tmax) { return segura_feito(down, Bounds{tmin, tmax}, t, k); };
  require(at(2, 2) == crossing(Contact::interior, At::source, true), "both bounds at the plane");
  require(at(2, 3) == crossing(Contact::interior, At::source, true), "tmin at the plane");
  require(at(0, 2) == crossing(Contact::interior, At::target, true), "tmax at the plane");
  require(at(1, 3) == crossing(Contact::interior, At::between, true), "between the bounds");
  require(!at(0, 1).hit && !at(3, 4).hit, "outside the bounds");
  require(!segura_feito(beside, Bounds{2, 2}, t, k).hit, "beside, both bounds at the plane");
  require(segura_feito(within, Bounds{1, 1}, t, k).contact == Contact::coplanar, "in the plane");
}

Point3 lattice_point(int i) { return Point3(i / 9, i / 3 % 3, i % 3); }

/// All unordered tuples of {0,1,2}³, rays with directions of {-1,0,1}³: as many in each class as the table says, and
/// both decisions agree with it.
template <class P>
void small_lattice() {
  constexpr P* which = nullptr;
  constexpr bool segments = std::is_same_v<P, Segment>;
  const Point3 origin(segments ? 0.0 : 1.0);
  Point3 v[27];
  for (int i = 0; i < 27; ++i) v[i] = lattice_point(i);
  unsigned long long counts[Table<P>::size + 1] = {};
  for (int a = 0; a < 27; ++a)
    for (int b = a; b < 27; ++b)
      for (int c = b; c < 27; ++c)
        for (int p = 0; p < 27; ++p)
          for (int q = segments ? p : 0; q < 27; ++q) {
            const P probe = probe_of(which, v[p], v[q] - origin);
            const Triangle t{v[a], v[b], v[c]};
            const int id = entry<P>(chirotope(probe, t, k));
            require(id != 0, "chirotope of the lattice in no class");
            ++counts[id];
            if ((a + b + c + p + q) % 8 == 0) expect_decision(Table<P>::classes[id - 1], probe, t);
          }
  for (const Class& c : Table<P>::classes) require(counts[c.id] == c.count, "tuples in a class");
}

int lesser(int x, int y) { return x < y ? x : y; }

/// Five points on one line: decided by intervals.
void five_point_line() {
  for (int code = 0; code < 3125; ++code) {
    const int x[5] = {code % 5, code / 5 % 5, code / 25 % 5, code / 125 % 5, code / 625};
    const int lo = lesser(x[0], lesser(x[1], x[2])), hi = -lesser(-x[0], lesser(-x[1], -x[2]));
    for (const Point3& along : {Point3(1, 0, 0), Point3(0, -1, 0), Point3(0, 0, 1), Point3(1, -1, 2)}) {
      const auto at = [&](int i) { return along * static_cast<double>(x[i]); };
      const bool meets = -lesser(-x[3], -x[4]) >= lo && lesser(x[3], x[4]) <= hi;
      const Triangle t{at(0), at(1), at(2)};
      require(segura_feito(Segment{at(3), at(4)}, t, k).hit == meets, "segment on the line of a flat triangle");
      require(meets_by_caratheodory<std::int64_t>(Segment{at(3), at(4)}, t) == meets, "Caratheodory on a line");
      const int d = x[4] - 2;
      const bool reached = (x[3] >= lo && x[3] <= hi) || (d > 0 && x[3] <= hi) || (d < 0 && x[3] >= lo);
      const Ray r{at(3), {along * static_cast<double>(d)}};
      require(segura_feito(r, t, k).hit == reached, "ray on the line of a flat triangle");
      require(meets_by_caratheodory<std::int64_t>(r, t) == reached, "Caratheodory on a ray on a line");
    }
  }
}

/// Parts of rays against the segments that they are: with integer bounds these have integer ends.
void parts() {
  const Triangle triangles[] = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                                {{1, 0, 2}, {0, 3, 1}, {2, 2, 2}},
                                {{0, 0, 0}, {2, 2, 2}, {4, 4, 4}},
                                {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
  for (const Triangle& t : triangles) {
    for (int n = 0; n < 729; ++n) {
      const Ray r{2.0 * (lattice_point(n / 27) - Point3(0.0)), {lattice_point(n % 27) - Point3(1.0)}};
      for (int tmin = 0; tmin < 4; ++tmin) {
        const Point3 from = r.o + static_cast<double>(tmin) * r.d.v;
        for (int tmax = tmin; tmax < 4; ++tmax) {
          const Segment s{from, r.o + static_cast<double>(tmax) * r.d.v};
          const Bounds bounds{static_cast<double>(tmin), static_cast<double>(tmax)};
          const Answer part = segura_feito(r, bounds, t, k), whole = segura_feito(s, t, k);
          require(part.hit == whole.hit, "a part of a ray against its segment");
          require(tmin == tmax || part == whole, "contact of a part of a ray");
        }
        const Answer tail = segura_feito(r, Bounds{static_cast<double>(tmin)}, t, k);
        require(tail == segura_feito(Ray{from, r.d}, t, k), "a part of a ray without an end");
      }
    }
  }
}

void finiteness() {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Point3 o(0, 0, 0);
  require(is_finite(Triangle{o, o, o}) && is_finite(Segment{o, o}) && is_finite(Ray{o, {o}}), "finite operands");
  for (const double bad : {inf, -inf, nan}) {
    for (int axis = 0; axis < 3; ++axis) {
      Point3 p = o;
      p[axis] = bad;
      require(!is_finite(p) && !is_finite(Triangle{p, o, o}) && !is_finite(Triangle{o, p, o}), "a bad vertex");
      require(!is_finite(Triangle{o, o, p}) && !is_finite(Segment{p, o}) && !is_finite(Segment{o, p}), "a bad end");
      require(!is_finite(Ray{p, {o}}) && !is_finite(Ray{o, {p}}), "a bad ray");
    }
    require(!is_finite(Bounds{bad, 1}), "a bad lower bound");
  }
  require(is_finite(Bounds{}) && is_finite(Bounds{0, inf}) && !is_finite(Bounds{0, nan}), "upper bounds");
  require(Bounds{}.tmin == 0 && Bounds{}.tmax == inf, "no bounds");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  read_classes<Segment>(argv[1]);
  read_classes<Ray>(argv[2]);
  finiteness();
  signs_by_hand();
  chirotopes_by_hand();
  hit_order();
  ends();
  bounds();
  parts();
  five_point_line();
  pocket_run<Segment>();
  pocket_run<Ray>();
  small_lattice<Segment>();
  small_lattice<Ray>();
  std::puts("survived");
}
