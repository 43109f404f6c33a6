#include "exact/cases/own/family.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>

#include "exact/base/sha256.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/own/aim.h"
#include "exact/cases/own/mutate.h"

namespace tribunal {
namespace {

constexpr int level_numbers[] = {0, 1, 2, 3, 4, 5};

std::span<const int> levels(Format) { return level_numbers; }

/// Below so many questions, one change, or two, give too few cases that differ: two or three are made then.
constexpr std::size_t few = 256, very_few = 8;

/// What cases of one format are made from: questions, and after them triangles, whose probes are still to be aimed.
struct Pool {
  std::vector<Query> items;
  std::size_t asked = 0;  ///< how many of them are questions
  double extent = 0;

  bool has_probe(std::size_t i) const { return i < asked; }
};

void add(Pool& pool, Query query, Format format) {
  query = rounded_to(std::move(query), format);
  if (!is_finite(query)) return;
  for (const Point3* v : Parts(query).points()) {
    pool.extent = std::max({pool.extent, std::fabs(v->x), std::fabs(v->y), std::fabs(v->z)});
  }
  pool.items.push_back(std::move(query));
}

Pool pool_of(const OwnData& data, Format format) {
  Pool pool;
  for (const OwnQuery& q : data.queries) {
    if (format == Format::binary32 || q.format == Format::binary64) add(pool, q.query, format);
  }
  pool.asked = pool.items.size();
  for (const Triangle& t : data.triangles) add(pool, {Segment{t.a, t.b}, t}, format);
  return pool;
}

struct Plan {
  std::uint32_t stream;
  std::array<Pool, 2> pools;  ///< by format

  const Pool& pool(Format format) const { return pools[static_cast<std::size_t>(format)]; }
};

/// A probe to begin with, of no meaning.
Probe any_probe(bool is_ray, const Triangle& t) { return is_ray ? Probe(Ray{t.a, {t.b}}) : Probe(Segment{t.a, t.b}); }

/// How many changes are made beside the one of the level.
std::uint64_t draw_more(const Pool& pool, Draw& draw) {
  std::uint64_t more = pool.items.size() < very_few ? 2 : pool.items.size() < few ? 1 : 0;
  while (more < 5 && draw.below(2) == 0) ++more;
  return more;
}

Trial make(const Plan& plan, Format format, std::uint64_t seed, std::uint64_t k) {
  const Pool& pool = plan.pool(format);
  if (k % 2 == 0 && k / 2 < pool.asked) return {.query = pool.items[k / 2], .format = format};
  Draw draw(plan.stream, seed, k);
  const Turn turn = turn_of(k, mutations().size());
  const std::size_t item = draw.below(pool.items.size());
  const std::size_t other = draw.below(pool.items.size());
  Trial trial{.query = pool.items[item], .format = format, .level = static_cast<std::uint16_t>(1 + turn.level)};
  const Surroundings around{pool.items[other], pool.extent, format};
  const auto change_by = [&](const Mutation& mutation) { mutate(trial.query, mutation, around, draw); };
  if (!pool.has_probe(item)) {
    trial.query.probe = any_probe(turn.is_ray, trial.query.triangle());
    change_by(aiming());
  }
  change_by(mutations()[turn.level]);
  for (std::uint64_t more = draw_more(pool, draw); more > 0; --more) {
    change_by(mutations()[draw.below(mutations().size())]);
  }
  return trial;
}

// --- what is said of the data ------------------------------------------------------------------------------------

struct KindRow {
  const char* name;
  std::uint32_t stream;
  const char *data, *stresses, *population;
};

constexpr KindRow kinds[] = {
    {"own-cases", stream_of("family own-cases"), "cases", "your own cases and their neighbours",
     "your cases as they are, and changed: by ulps, snapped, flipped, aimed at their targets"},
    {"own-mesh", stream_of("family own-mesh"), "mesh", "the triangles of your own mesh and their neighbours",
     "segments and rays aimed at the triangles of your mesh, probes and triangles changed by ulps, snapped, flipped: "
     "one "
     "triangle a case, so how often a single answer is wrong is no leak rate, which `tribunal leak` measures"},
    {"own-scene", stream_of("family own-scene"), "scene",
     "the rays and triangles of your own scene and their neighbours",
     "rays and shadow segments of your scene and triangles near them, as they are, and changed: by ulps, snapped, "
     "flipped, aimed at the triangles"},
};

std::string count_of(std::size_t n, const char* what) { return std::to_string(n) + " " + what; }

std::string left_out(const OwnData& data, const Plan& plan) {
  const std::size_t read = data.queries.size() + data.triangles.size(), fit = plan.pool(Format::binary32).items.size();
  const bool triangles = !data.triangles.empty() || data.queries.front().query.operands() == Operands::triangles;
  std::vector<std::string> parts;
  if (data.nonfinite > 0) parts.push_back(count_of(data.nonfinite, "with numbers that are not finite"));
  if (data.other_operands > 0) {
    parts.push_back(count_of(data.other_operands,
                             triangles ? "about polygons, which are asked with a polygon family" : "about triangles"));
  }
  if (fit < read) parts.push_back(count_of(read - fit, "in binary32, beyond its range"));
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

void append(std::string& bytes, double x) {
  const auto number = std::bit_cast<std::array<char, sizeof(double)>>(x);
  bytes.append(number.begin(), number.end());
}

void append(std::string& bytes, const Query& q) {
  Query query = q;
  for (const Point3* v : Parts(query).vectors()) {
    for (int axis = 0; axis < 3; ++axis) append(bytes, (*v)[axis]);
  }
  if (query.bounds) {
    append(bytes, query.bounds->tmin);
    append(bytes, query.bounds->tmax);
  }
  bytes += query.bounds ? 'b' : is_of_ray(query) ? 'r' : 's';
  if (query.operands() == Operands::polygons) {
    for (const std::size_t end : query.polygon().ends) bytes += std::to_string(end) + ",";
  }
}

std::string numbers_of(const OwnData& data) {
  std::string bytes;
  for (const OwnQuery& q : data.queries) {
    append(bytes, q.query);
    bytes += q.format == Format::binary32 ? 'f' : 'd';
  }
  for (const Triangle& t : data.triangles) append(bytes, {Segment{t.a, t.b}, t});
  return bytes;
}

std::vector<Format> formats_of(const Plan& plan) {
  std::vector<Format> formats;
  for (const Format format : {Format::binary64, Format::binary32}) {
    if (!plan.pool(format).items.empty()) formats.push_back(format);
  }
  return formats;
}

}  // namespace

OwnFamily family_of(const OwnData& data) {
  const KindRow& kind = kinds[static_cast<std::size_t>(data.kind)];
  const auto plan = std::make_shared<const Plan>(
      Plan{kind.stream, {pool_of(data, Format::binary32), pool_of(data, Format::binary64)}});
  const bool triangles = data.queries.empty() || data.queries.front().query.operands() == Operands::triangles;
  DataFile file{.kind = kind.data,
                .file = data.file,
                .sha256 = data.sha256,
                .numbers_sha256 = sha256(numbers_of(data)),
                .items = data.queries.size() + data.triangles.size(),
                .left_out = left_out(data, *plan)};
  return {
      .family = {.name = kind.name,
                 .stresses = kind.stresses,
                 .population = kind.population,
                 .axis = "(0 as it is, 1 moved by ulps, 2 snapped to a grid, 3 snapped to vertices, edges and planes, "
                         "4 flipped, 5 aimed)",
                 .constructs = false,
                 .levels = levels,
                 .make = [plan](Format format, std::uint64_t seed,
                                std::uint64_t k) { return make(*plan, format, seed, k); },
                 .operands = triangles ? Operands::triangles : Operands::polygons,
                 .data = std::move(file)},
      .formats = formats_of(*plan)};
}

}  // namespace tribunal
