#include "tracer/render.h"

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

void render_row(const World& world, const CameraRays& camera, int row, int depth, WhittedTracer& tracer,
                const RayTally& tally, Rendering& out) {
  const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(world.scene->camera.width);
  for (int column = 0; column < world.scene->camera.width; ++column) {
    const std::size_t i = first + static_cast<std::size_t>(column);
    const RayTally before = tally;
    out.image.pixels[i] = to_pixel(tracer.trace(camera.through(column, row), depth));
    out.decisions[i] = tracer.take_hash();
    out.costs[i] = cost_between(before, tally);
  }
}

}  // namespace

Rendering render(const World& world, const Method& method, const RenderOptions& options) {
  const Camera& camera = world.scene->camera;
  const CameraRays rays(camera);
  Rendering out{Image(camera.width, camera.height), {}, {}, {}, 0};
  out.costs.resize(out.image.pixels.size());
  out.decisions.resize(out.image.pixels.size());
  const std::size_t rows = static_cast<std::size_t>(camera.height);
  std::vector<RayTally> tallies(options.threads);
  std::deque<WhittedTracer> tracers;
  for (RayTally& tally : tallies) tracers.emplace_back(world, method, tally);

  Progress progress(method.name, "rows", rows);
  const auto work = [&](std::size_t row, unsigned worker) {
    render_row(world, rays, static_cast<int>(row), options.depth, tracers[worker], tallies[worker], out);
    progress.add(1);
  };
  const std::size_t done = run_blocks(rows, options.threads, work);
  if (done < rows || interrupted() != 0) {
    throw Failure(interrupted() == SIGTERM ? Exit::terminated : Exit::interrupted,
                  "render: interrupted, nothing written");
  }
  for (const RayTally& tally : tallies) out.tally += tally;
  out.seconds = progress.elapsed();
  return out;
}

}  // namespace tribunal
