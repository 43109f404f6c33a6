// Adjacent floats between which the answer flips.
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"
#include "exact/filtered/filtered.h"

namespace tribunal {
namespace {

constexpr int no_levels[] = {0};

std::span<const int> levels(Format) { return no_levels; }

/// By the certified test, some fifty times a case. It only finds the case: others judge what comes out.
bool meets(const Query& query) {
  return std::visit([&](const auto& probe) { return hits(probe, query.triangle()); }, query.probe);
}

Point3& start_of(Probe& probe) {
  if (auto* s = std::get_if<Segment>(&probe)) return s->p;
  return std::get<Ray>(probe).o;
}

/// Moves x from a hit toward a miss until they are adjacent, and leaves it on either side.
void bisect(const Query& query, double& x, double out, Format format, bool keep_hit) {
  double in = x;
  const auto hits_at = [&](double value) {
    x = value;
    return meets(query);
  };
  const bool flips = hits_at(in) && !hits_at(out);
  for (double middle = in_format(in + (out - in) / 2, format); flips && middle != in && middle != out;
       middle = in_format(in + (out - in) / 2, format)) {
    (hits_at(middle) ? in : out) = middle;
  }
  x = keep_hit || !flips ? in : out;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family flip"), seed, k);
  const bool is_ray = turn_of(k, 1).is_ray;
  const Triangle t = draw_triangle(draw, format);
  const Point3 n = draw_point(draw, format);
  const Segment centre = through(in_format((t.a + t.b + t.c) / 3.0, format), n, n);
  const Probe probe = draw_probe(is_ray, centre, format, draw);
  Trial trial = unclassified(format, 0, probe, t, draw);
  double& x = start_of(trial.query.probe)[static_cast<int>(draw.below(3))];
  const double far = draw.below(2) == 0 ? 8 : -8;
  const bool keep_hit = draw.below(2) == 0;
  bisect(trial.query, x, in_format(x + far, format), format, keep_hit);
  return trial;
}

}  // namespace

/// One of the last two neighbours before the answer flips: a coordinate of the probe's start bisected down to adjacent
/// floats.
Family flip_family() {
  return {.name = "flip",
          .stresses = "adjacent floats between which the exact answer flips",
          .population = "random triangles in [-1,1]^3, one coordinate of the probe's start bisected to a flip",
          .axis = "(none)",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
