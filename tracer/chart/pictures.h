// How fast methods draw scenes, and how many pixels they get wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/chart/timing.h"
#include "tracer/scene/scene.h"

namespace tribunal {

struct PicturePlan {
  std::vector<Method> methods;  ///< those that take no rays of triangles are left out
  std::vector<Scene> scenes;    ///< drawn at their own size and depth, with all faces triangulated
  int repetitions = 6;          ///< of methods that are quick enough; slow ones draw each scene once
  unsigned threads = 1;         ///< for the pictures that are compared; time is taken on one thread
};

/// Why a pixel's decisions differ from those of the exact reference.
enum class PixelCause : std::uint8_t {
  wrong,     ///< at the first ray on which they part, which is the same ray of both, the method is wrong by its own
             ///< contract about a face, or in which hit comes first
  start,     ///< they agree on every face for the reference's ray: only where a secondary ray starts differs
  not_owed,  ///< they part about a face on which the method's contract leaves the answer open, or in which hit comes
             ///< first and the method says nothing of that
};

inline constexpr std::size_t pixel_cause_count = 3;

/// One method on the pictures of all scenes in one format.
struct PictureRow {
  std::size_t method = 0;
  Format format = Format::binary64;
  std::uint64_t pixels = 0, rays = 0;  ///< rays of all kinds in one drawing of all scenes
  std::array<std::uint64_t, pixel_cause_count> differing{};
  int repetitions = 0;
  Median rays_per_second{};  ///< over all scenes together, by repetition

  std::uint64_t wrong() const { return differing[static_cast<std::size_t>(PixelCause::wrong)]; }
};

/// In the order format, method. The decisions of each pixel are held against those of the reference method on the same
/// world. Counts do not depend on the number of threads. Fails with 128 + signal if interrupted.
std::vector<PictureRow> measure_pictures(const PicturePlan& plan);

/// {"scenes", "rows"}. Shares have no interval: the pixels of given scenes are all looked at, so that nothing is drawn
/// from a population, and neighbours are wrong together.
Json to_json(const PicturePlan& plan, const std::vector<PictureRow>& rows);
std::string to_table(const PicturePlan& plan, const std::vector<PictureRow>& rows);

}  // namespace tribunal
