#include "tracer/render/render.h"

#include <algorithm>
#include <csignal>
#include <deque>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

constexpr int tile_side = 16;  ///< pixels on a side of a tile, of which the rays visit much the same boxes

/// The picture cut into square tiles, in row order.
struct Tiles {
  int width, height;

  int columns() const { return (width + tile_side - 1) / tile_side; }
  std::size_t count() const {
    return static_cast<std::size_t>(columns()) * static_cast<std::size_t>((height + tile_side - 1) / tile_side);
  }

  /// Calls visit(column, row) for each pixel of a tile, 4 × 2 at a time: neighbours share a packet.
  template <class Visit>
  void visit(std::size_t tile, const Visit& visit_pixel) const {
    const int left = static_cast<int>(tile) % columns() * tile_side,
              top = static_cast<int>(tile) / columns() * tile_side;
    const int right = std::min(left + tile_side, width), bottom = std::min(top + tile_side, height);
    for (int y = top; y < bottom; y += 2) {
      for (int x = left; x < right; x += 4) {
        for (int row = y; row < std::min(y + 2, bottom); ++row) {
          for (int column = x; column < std::min(x + 4, right); ++column) visit_pixel(column, row);
        }
      }
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
    std::vector<Ray> primaries;
    std::vector<std::size_t> places;
    tiles.visit(tile, [&](int column, int row) {
      primaries.push_back(rays.through(column, row));
      places.push_back(static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) +
                       static_cast<std::size_t>(column));
    });
    std::vector<TracedPixel> traced(primaries.size());
    tracers[worker].trace(primaries, options.depth, traced);
    for (std::size_t k = 0; k < traced.size(); ++k) {
      out.image.pixels[places[k]] = to_pixel(traced[k].colour);
      out.decisions[places[k]] = traced[k].decisions;
      out.costs[places[k]] = traced[k].cost;
    }
    progress.add(1);
  };
  const std::size_t done = run_blocks(tiles.count(), options.threads, work);
  if (done < tiles.count() || interrupted() != 0) {
    throw Failure(interrupted() == SIGTERM ? Exit::terminated : Exit::interrupted,
                  "render: interrupted, no picture written");
  }
  for (const RayTally& tally : tallies) out.tally += tally;
  out.seconds = progress.elapsed();
  return out;
}

}  // namespace tribunal
