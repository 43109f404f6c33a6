#include "exact/cases/polygon_families/aim.h"

#include <numeric>
#include <utility>

namespace tribunal {
namespace {

/// The number of pairs of a shape and a place.
constexpr std::uint64_t round_size = shape_count * place_count;

/// The number of pairs of an approach and a kind of probe.
constexpr std::uint64_t ways = 2 * approach_count;

PolygonPlace place_of_turn(std::size_t shape, std::uint64_t turn) {
  const Places& places = places_of(all_shapes()[shape]);
  std::size_t place = turn % place_count;
  while (places[place].empty()) place = (place + 1) % place_count;
  return static_cast<PolygonPlace>(place);
}

}  // namespace

/// Each round moves every pair of a shape and a place on to its next way. After lcm(levels, ways) rounds a level would
/// come back to a way that it has had; there the round moves on by two.
PolygonTurn polygon_turn_of(std::uint64_t k, std::size_t levels) {
  const std::uint64_t pair = k % round_size, round = k / round_size;
  const std::uint64_t way = (pair + round + round / std::lcm(levels, ways)) % ways;
  const std::size_t shape = pair % shape_count;
  const Construction known{shape, place_of_turn(shape, pair / shape_count),
                           static_cast<Approach>(way % approach_count)};
  return {known, way % 2 == 1, round % levels};
}

ProbeEnds draw_piercing(Draw& draw, const PlanePoint& x, Approach approach) {
  const std::int64_t du = draw.between(-2, 2);
  const std::int64_t dv = draw.between(-2, 2);
  const std::int64_t up = draw.between(1, 3);
  const std::int64_t down = draw.between(1, 3);
  Lattice3 near_end{x.u + du * up, x.v + dv * up, up}, far_end{x.u - du * down, x.v - dv * down, -down};
  if (draw.below(2) == 0) std::swap(near_end, far_end);
  if (approach == Approach::through) return {near_end, far_end};
  return approach == Approach::from ? ProbeEnds{in_plane(x), far_end} : ProbeEnds{near_end, in_plane(x)};
}

Aim draw_aim(std::uint64_t k, std::size_t levels, Draw& draw) {
  const PolygonTurn turn = polygon_turn_of(k, levels);
  const Places& places = places_of(all_shapes()[turn.construction.shape]);
  const std::vector<PlanePoint>& candidates = places[static_cast<std::size_t>(turn.construction.place)];
  const PlanePoint at = candidates[draw.below(candidates.size())];
  return {turn, at, draw_piercing(draw, at, turn.construction.approach)};
}

Trial image_of(const Aim& aim, const AffineMap& map, Format format, Draw& draw, std::optional<int> direction_scale) {
  const Probe probe = image(aim.turn.is_ray, map, aim.ends, format, draw, direction_scale);
  return {.query = {probe, image(map, aim.rings())},
          .format = format,
          .level = static_cast<std::uint16_t>(aim.turn.level),
          .construction = aim.turn.construction};
}

}  // namespace tribunal
