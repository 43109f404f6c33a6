// Kills mutants of the predicate headers: returns 0 iff signs, decisions and classes are right on small integers, where
// int64 is exact. Only headers are included, so that a mutated copy of one is all that differs. What is right comes
// from the class table (argument 1), from Carathéodory's theorem, and from a few values worked out by hand.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/kernel.h"
#include "core/segura_feito.h"
#include "exact/classes/chirotope.h"
#include "exact/oracles/caratheodory.h"

using namespace tribunal;

namespace {

using Integers = FormulaKernel<std::int64_t>;
const Integers k;

void require(bool holds, const char* what) {
  if (holds) return;
  std::printf("killed: %s\n", what);
  std::exit(1);
}

struct Class {
  int id, rank;
  bool hit;
  char touched;              ///< the triangle's part: F, E or V, or the end of what the table says instead
  unsigned long long count;  ///< unordered tuples of {0,1,2}³
  Point3 v[5];
};

constexpr int class_count = 163;
Class classes[class_count];

Class class_in(const char* line) {
  Class c{};
  char intersection[20], touches[40];
  int x[15], n = 0;
  const int read =
      std::sscanf(line, "C%d %d %*s %*s %19s %39[^\t] %llu %*s%n", &c.id, &c.rank, intersection, touches, &c.count, &n);
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

void read_classes(const char* path) {
  std::FILE* const file = std::fopen(path, "r");
  char line[256];
  int rows = -1;  // the heading
  while (file != nullptr && std::fgets(line, sizeof line, file) != nullptr) {
    if (rows >= class_count) std::exit(2);
    if (rows >= 0) classes[rows] = class_in(line);
    ++rows;
  }
  if (rows != class_count) std::exit(2);
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

/// The class of a chirotope, by rank and code; 0 where none has been entered.
int class_of_code[5][59049];

int& entry(const Chirotope& c) {
  require(c.rank >= 1 && c.rank <= 4 && c.code < 59049, "chirotope out of range");
  return class_of_code[c.rank][c.code];
}

/// A chirotope belongs to one class; each class brings its labelled orders and their mirror images.
void enter(const Chirotope& c, int id) {
  require(entry(c) == 0 || entry(c) == id, "one chirotope in two classes");
  entry(c) = id;
}

void expect_decision(const Class& c, const Segment& s, const Triangle& t) {
  const Answer answer = segura_feito(s, t, k);
  require(answer.hit == c.hit && answer.contact == contact_of(c), "decision against the class table");
  require(meets_by_caratheodory<std::int64_t>(s, t) == c.hit, "Caratheodory against the class table");
}

/// 163 classes × 12 labelled orders × 48 signed axis permutations.
void pocket_run() {
  for (const Class& c : classes) {
    for (int image = 0; image < 48; ++image) {
      Point3 v[5];
      for (int i = 0; i < 5; ++i) v[i] = axis_image(c.v[i], image / 8, image % 8);
      for (const auto& order : vertex_orders) {
        const Triangle t{v[order[0]], v[order[1]], v[order[2]]};
        for (const Segment& s : {Segment{v[3], v[4]}, Segment{v[4], v[3]}}) {
          expect_decision(c, s, t);
          const Chirotope chi = chirotope(s, t, k);
          require(chi.rank == c.rank, "rank against the class table");
          enter(chi, c.id);
        }
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

/// All unordered tuples of {0,1,2}³: as many in each class as the table says, and both decisions agree with it.
void small_lattice() {
  Point3 v[27];
  for (int i = 0; i < 27; ++i) v[i] = lattice_point(i);
  unsigned long long counts[class_count + 1] = {};
  for (int a = 0; a < 27; ++a)
    for (int b = a; b < 27; ++b)
      for (int c = b; c < 27; ++c)
        for (int p = 0; p < 27; ++p)
          for (int q = p; q < 27; ++q) {
            const Segment s{v[p], v[q]};
            const Triangle t{v[a], v[b], v[c]};
            const int id = entry(chirotope(s, t, k));
            require(id != 0, "chirotope of the lattice in no class");
            ++counts[id];
            if ((a + b + c + p + q) % 8 == 0) expect_decision(classes[id - 1], s, t);
          }
  for (const Class& c : classes) require(counts[c.id] == c.count, "tuples in a class");
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

/// Answers to rays by two formulations, which must agree.
void rays() {
  for (int i = 0; i < 19683; ++i) {
    const Triangle t{lattice_point(i / 729), lattice_point(i / 27 % 27), lattice_point(i % 27)};
    for (int n = i % 7; n < 729; n += 7) {
      const Ray r{lattice_point(n / 27), {lattice_point(n % 27) - Point3(1.0)}};
      require(segura_feito(r, t, k).hit == meets_by_caratheodory<std::int64_t>(r, t), "ray by two formulations");
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  read_classes(argv[1]);
  signs_by_hand();
  chirotopes_by_hand();
  hit_order();
  ends();
  bounds();
  five_point_line();
  pocket_run();
  small_lattice();
  rays();
  std::puts("survived");
}
