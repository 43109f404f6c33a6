// What two methods' pictures of one world differ in: every pixel with its reason, counts, and cases.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "exact/base/json_fwd.h"
#include "tracer/render/compare.h"

namespace tribunal {

/// Why two methods part on a pixel. `face`: their answers about one face differ. `order`: only which hit is first.
/// `start`: no answer differs, but the ray starts elsewhere. `unexamined`: there were enough cases before.
enum class Why : std::uint8_t { face, order, start, unexamined };

std::string_view name_of(Why why);

/// A differing pixel, with the kind of the first ray on which the methods part, and of a `face` its case.
struct ExaminedPixel {
  DifferingPixel pixel;
  Why why = Why::unexamined;
  RayKind kind = RayKind::primary;   ///< meaningless if unexamined
  std::string id{};                  ///< of the case
  std::vector<std::string> wrong{};  ///< which of the methods are wrong there, by their answer or their order of hits
};

struct Findings {
  std::vector<ExaminedPixel> pixels{};   ///< in row order
  std::size_t colours = 0;               ///< pixels of another colour
  std::array<std::size_t, 4> by_kind{};  ///< examined pixels by the kind of the first ray on which the methods differ
  std::vector<Case> cases{};

  std::size_t count(Why why) const;
  std::size_t examined() const { return pixels.size() - count(Why::unexamined); }
};

/// Traces each differing pixel again with both methods, until there are `max_cases` cases.
Findings examine(const World& world, const Method& a, const Method& b, const std::vector<DifferingPixel>& pixels,
                 int depth, std::size_t max_cases);

/// The counts, for `--stats`.
Json to_json(const Findings& f, const Method& a, const Method& b);

/// Every pixel, an object each.
Json pixels_json(const Findings& f);

}  // namespace tribunal
