#include "tracer/render.h"

#include <algorithm>
#include <csignal>
#include <deque>

#include "exact/harness/interrupt.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"
#include "exact/io/failure.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

Stage deepest_between(const RayTally& before, const RayTally& after) {
  for (const Stage s : {Stage::exact, Stage::expansion, Stage::filter}) {
    if (after.by_stage[static_cast<std::size_t>(s)] > before.by_stage[static_cast<std::size_t>(s)]) return s;
  }
  return Stage::none;
}

PixelCost cost_between(const RayTally& before, const RayTally& after) {
  return {after.tests() + after.start_tests - before.tests() - before.start_tests, deepest_between(before, after)};
}

constexpr int tile_side = 16;  ///< pixels; neighbours visit the same boxes

/// The picture in squares, row by row of them.
struct Tiles {
  int width, height;

  int columns() const { return (width + tile_side - 1) / tile_side; }
  std::size_t count() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>((height + tile_side - 1) / tile_side);
  }

  /// Calls visit(column, row) for each pixel of a tile.
  template <class Visit>
  void visit(std::size_t tile, const Visit& visit_pixel) const {
    const int left = static_cast<int>(tile) % columns() * tile_side,
              top = static_cast<int>(tile) / columns() * tile_side;
    for (int row = top; row < std::min(top + tile_side, height); ++row) {
      for (int column = left; column < std::min(left + tile_side, width); ++column) visit_pixel(column, row);
    }
  }
};

}  // namespace

Rendering render(const World& world, const Method& method, const RenderOptions& options) {
  const Camera& camera = world.scene->camera;
  const CameraRays rays(camera);
  Rendering out{Image(camera.width, camera.height), {}, {}, {}, 0};
  out.costs.resize(out.image.pixels.size());
  out.decisions.resize(out.image.pixels.size());
  const Tiles tiles{camera.width, camera.height};
  std::vector<RayTally> tallies(options.threads);
  std::deque<WhittedTracer> tracers;
  for (RayTally& tally : tallies) tracers.emplace_back(world, method, tally);

  Progress progress(method.name, "tiles", tiles.count());
  const auto work = [&](std::size_t tile, unsigned worker) {
    tiles.visit(tile, [&](int column, int row) {
      const std::size_t i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(column);
      const RayTally before = tallies[worker];
      out.image.pixels[i] = to_pixel(tracers[worker].trace(rays.through(column, row), options.depth));
      out.decisions[i] = tracers[worker].take_hash();
      out.costs[i] = cost_between(before, tallies[worker]);
    });
    progress.add(1);
  };
  const std::size_t done = run_blocks(tiles.count(), options.threads, work);
  if (done < tiles.count() || interrupted() != 0) {
    throw Failure(interrupted() == SIGTERM ? Exit::terminated : Exit::interrupted,
                  "render: interrupted, nothing written");
  }
  for (const RayTally& tally : tallies) out.tally += tally;
  out.seconds = progress.elapsed();
  return out;
}

}  // namespace tribunal
