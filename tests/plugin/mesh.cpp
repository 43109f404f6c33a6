// A mesh plugin that is right: every face asked in rational arithmetic. And, with a macro, one that is wrong as trees
// in the wild are:
//   LOSES_FLAT_SLABS   boxes tested by 1/d, so that 0·∞ in a face of a box loses its triangle
//   EXITS_EARLY        closest returns the first hit that it finds
//   LISTS_TWICE        all reports a face again for each box that it lies in
//   COUNTS_EDGES       inside counts every closed face, so that an edge counts twice
//   ROUNDS_T           t in binary32, against the promise
//   TURNS_NORMALS, BLUNTS_NORMALS, WRONG_SIDE   what it tells of the face that is hit
//   NO_SUCH_FACE, THROWS, NO_ANSWER   break the interface
//   FAULT=crash|loop|leave|die|round_up|throw_text   does so on about one ray in 300, in closest, any, all and inside
//   FAULTS_IN_PREPARE      the same while a mesh is prepared
//   VERSION_2              a library of before there were normals
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

#include "exact/plugin/tribunal_plugin.h"

namespace {

using Number = mpq_class;
using Vector = std::array<Number, 3>;
using Face = std::array<Vector, 3>;

struct Hit {
  std::size_t face;
  Number t;
};

struct Box {
  std::array<double, 3> lo, hi;
};

struct Mesh {
  std::vector<Face> faces;
  std::vector<Box> boxes;
};

struct Ray {
  std::array<double, 3> o_rounded, d_rounded;
  Vector o, d;

  explicit Ray(const double* x) : o_rounded{x[0], x[1], x[2]}, d_rounded{x[3], x[4], x[5]} {
    for (std::size_t i = 0; i < 3; ++i) o[i] = x[i], d[i] = x[i + 3];
  }
};

[[maybe_unused]] void crash() { std::raise(SIGSEGV); }
[[maybe_unused]] void die() { std::abort(); }
[[maybe_unused]] void leave() { std::exit(0); }
[[maybe_unused]] void round_up() { std::fesetround(FE_UPWARD); }
[[maybe_unused]] void throw_text() { throw std::runtime_error("out of boxes"); }
[[maybe_unused]] void loop() {
  for (volatile bool on = true; on;) {
  }
}

/// Fails if the ray is marked, by bits of its coordinates.
void may_fail([[maybe_unused]] const double* ray) {
#ifdef FAULT
  std::uint64_t mixed = 1;
  for (int i = 0; i < 6; ++i) {
    std::uint64_t bits;
    std::memcpy(&bits, ray + i, sizeof bits);
    mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 29;
  }
  if (mixed % 300 == 0) FAULT();
#endif
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Number det(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The slab test of the textbook, which has NaN where the source lies in a plane of the box and the ray runs along it.
bool may_meet(const Box& box, const Ray& r) {
#ifdef LOSES_FLAT_SLABS
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const double inverse = 1 / r.d_rounded[i];
    const double in = (box.lo[i] - r.o_rounded[i]) * inverse, out = (box.hi[i] - r.o_rounded[i]) * inverse;
    first = std::max(std::min(in, out), first);
    last = std::min(std::max(in, out), last);
    if (!(in <= out || out <= in)) return false;
  }
  return first <= last * (1 + 0x1p-50);
#else
  for (std::size_t i = 0; i < 3; ++i) {
    const bool off = r.o_rounded[i] < box.lo[i] || r.o_rounded[i] > box.hi[i];
    const bool leaves = r.o_rounded[i] < box.lo[i] ? r.d_rounded[i] <= 0 : r.d_rounded[i] >= 0;
    if (off && leaves) return false;
  }
  return true;
#endif
}

/// The closed face, unless the ray lies in its plane.
bool meets(const Face& f, const Ray& r, Number& t) {
  const Vector ab = minus(f[1], f[0]), ac = minus(f[2], f[0]), ao = minus(r.o, f[0]);
  const Number den = -det(ab, ac, r.d);
  if (den == 0) return false;
  t = det(ab, ac, ao) / den;
  const Number b = -det(ao, ac, r.d) / den, c = -det(ab, ao, r.d) / den;
  return t >= 0 && b >= 0 && c >= 0 && b + c <= 1;
}

std::vector<Hit> hits_of(const Mesh& mesh, const double* ray) {
  may_fail(ray);
  const Ray r(ray);
  std::vector<Hit> hits;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    Number t;
    if (may_meet(mesh.boxes[f], r) && meets(mesh.faces[f], r, t)) hits.push_back({f, t});
  }
  return hits;
}

/// The nearest double: mpq_class::get_d truncates.
double rounded(const Number& t) {
#ifdef ROUNDS_T
  return static_cast<float>(t.get_d());
#else
  const double below = t.get_d(), above = std::nextafter(below, std::numeric_limits<double>::infinity());
  return Number(above) - t < t - Number(below) ? above : below;
#endif
}

/// The side on which the ray, moved by next to nothing along x, then y, then z, passes the edge ab.
[[maybe_unused]] int passes(const Ray& r, const Vector& a, const Vector& b) {
  const Vector u = minus(a, r.o), v = minus(b, r.o);
  for (const Vector& d : {r.d, Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
    const int side = sgn(det(u, v, d));
    if (side != 0) return side;
  }
  return 0;
}

bool crosses(const Face& f, const Ray& r) {
#ifdef COUNTS_EDGES
  Number t;
  return meets(f, r, t);
#else
  const int cone = sgn(det(minus(f[0], r.o), minus(f[1], r.o), minus(f[2], r.o)));
  return cone != 0 && passes(r, f[0], f[1]) == cone && passes(r, f[1], f[2]) == cone && passes(r, f[2], f[0]) == cone;
#endif
}

void* prepare(std::size_t vertex_count, const double* vertices, std::size_t face_count, const std::size_t* corners) {
#ifdef FAULTS_IN_PREPARE
  FAULT();
#endif
  Mesh* mesh = new Mesh;
  for (std::size_t f = 0; f < face_count; ++f) {
    Face face;
    Box box;
    box.lo.fill(std::numeric_limits<double>::infinity());
    box.hi.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t v = corners[3 * f + i];
      if (v >= vertex_count) throw std::out_of_range("a corner is no vertex");
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = vertices[3 * v + axis];
        face[i][axis] = x;
        box.lo[axis] = std::min(box.lo[axis], x);
        box.hi[axis] = std::max(box.hi[axis], x);
      }
    }
    mesh->faces.push_back(face);
    mesh->boxes.push_back(box);
  }
  return mesh;
}

void closest(const void* mesh, std::size_t n, const double* rays, tribunal_mesh_hit* hits) {
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<Hit> all = hits_of(*static_cast<const Mesh*>(mesh), rays + 6 * i);
#ifndef EXITS_EARLY
    std::stable_sort(all.begin(), all.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
#endif
    hits[i] = all.empty() ? tribunal_mesh_hit{TRIBUNAL_NO_FACE, 0}
                          : tribunal_mesh_hit{all.front().face, rounded(all.front().t)};
#ifdef NO_SUCH_FACE
    hits[i].face = 1000000;
#endif
  }
}

/// Of the face, as its vertices turn, and the side that the source sees.
[[maybe_unused]] void closest_normal(const void* mesh, std::size_t n, const double* rays, tribunal_mesh_hit* hits,
                                     tribunal_mesh_normal* normals) {
  closest(mesh, n, rays, hits);
  for (std::size_t i = 0; i < n; ++i) {
    if (hits[i].face >= static_cast<const Mesh*>(mesh)->faces.size()) continue;
    const Face& f = static_cast<const Mesh*>(mesh)->faces[hits[i].face];
    const Vector ab = minus(f[1], f[0]), ac = minus(f[2], f[0]);
    const Vector across = {ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2], ab[0] * ac[1] - ab[1] * ac[0]};
    const Ray ray(rays + 6 * i);
    bool front = across[0] * ray.d[0] + across[1] * ray.d[1] + across[2] * ray.d[2] < 0;
    bool turned = !front;
#ifdef TURNS_NORMALS
    turned = false;
#endif
#ifdef WRONG_SIDE
    front = true;
#endif
    for (std::size_t k = 0; k < 3; ++k) normals[i].normal[k] = (turned ? -1 : 1) * across[k].get_d();
#ifdef BLUNTS_NORMALS
    for (double& x : normals[i].normal) x = std::round(x * 8) / 8 + 0x1p-9;
#endif
    normals[i].side = front ? TRIBUNAL_SIDE_FRONT : TRIBUNAL_SIDE_BACK;
  }
}

void any(const void* mesh, std::size_t n, const double* rays, int* answers) {
#ifdef THROWS
  throw std::runtime_error("out of boxes");
#endif
#ifndef NO_ANSWER
  for (std::size_t i = 0; i < n; ++i) {
    answers[i] = hits_of(*static_cast<const Mesh*>(mesh), rays + 6 * i).empty() ? 0 : 1;
  }
#endif
  (void)mesh, (void)n, (void)rays, (void)answers;
}

std::size_t all(const void* mesh, const double* ray, std::size_t capacity, tribunal_mesh_hit* hits) {
  std::vector<Hit> list = hits_of(*static_cast<const Mesh*>(mesh), ray);
  std::stable_sort(list.begin(), list.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
#ifdef LISTS_TWICE
  if (list.size() > 1) list.push_back(list.back());
#endif
  for (std::size_t i = 0; i < std::min(capacity, list.size()); ++i) hits[i] = {list[i].face, rounded(list[i].t)};
  return list.size();
}

void inside(const void* mesh, std::size_t n, const double* rays, int* answers) {
  for (std::size_t i = 0; i < n; ++i) {
    may_fail(rays + 6 * i);
    const Ray ray(rays + 6 * i);
    int count = 0;
    for (const Face& f : static_cast<const Mesh*>(mesh)->faces) count += crosses(f, ray);
    answers[i] = count % 2;
  }
}

void release(void* mesh) { delete static_cast<Mesh*>(mesh); }

tribunal_plugin description() {
  tribunal_plugin p{};
  p.abi = TRIBUNAL_PLUGIN_ABI;
  p.name = "tree";
  p.summary = "every face of a mesh, in rational arithmetic";
  p.format = TRIBUNAL_BINARY64;
  p.convention = TRIBUNAL_TRANSVERSAL;
  return p;
}

tribunal_mesh_plugin mesh_description() {
  tribunal_mesh_plugin p{};
  p.abi = TRIBUNAL_PLUGIN_ABI;
  p.tells_t = 1;
  p.sorted = 1;
  p.most_ulps = 1;
  p.prepare = prepare;
  p.closest = closest;
  p.any = any;
  p.all = all;
  p.inside = inside;
  p.release = release;
#ifdef VERSION_2
  p.abi = 2;
  std::memset(&p.closest_normal, 0xff, sizeof p - offsetof(tribunal_mesh_plugin, closest_normal));  // not ours to read
#else
  p.closest_normal = closest_normal;
  p.tells_normal = 1;
  p.tells_side = 1;
  p.normal_sense = TRIBUNAL_NORMAL_TOWARDS_SOURCE;
  p.most_degrees = 1e-10;
#endif
  return p;
}

}  // namespace

const tribunal_plugin* tribunal_plugin_describe(void) {
  static const tribunal_plugin plugin = description();
  return &plugin;
}

const tribunal_mesh_plugin* tribunal_plugin_describe_meshes(void) {
  static const tribunal_mesh_plugin plugin = mesh_description();
  return &plugin;
}
