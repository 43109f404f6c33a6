// A world and a method to a picture.
#pragma once

#include "tracer/image/image.h"
#include "tracer/shading/whitted.h"

namespace tribunal {

struct RenderOptions {
  int depth = 4;  ///< generations of rays, ≥ 1
  unsigned threads = 1;
};

struct Rendering {
  Image image;
  std::vector<Cost> costs;               ///< in row order
  std::vector<std::uint64_t> decisions;  ///< a hash of each pixel's decisions, in row order
  RayTally tally;
  double seconds = 0;
};

/// One ray a pixel. The same bytes and counts for any number of threads. Fails with Exit::interrupted (130) or
/// Exit::terminated on a signal.
Rendering render(const World& world, const Method& method, const RenderOptions& options);

}  // namespace tribunal
