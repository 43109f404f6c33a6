// Points that are identified by their coordinates alone, numbered in the order in which they first appear.
#pragma once

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/query.h"

namespace tribunal {

/// Appends to `points` each point that it has not met. 0 and −0 are the same number, and so in the same point.
class MergedPoints {
 public:
  explicit MergedPoints(std::vector<Point3>& points) : points_(points) {}

  std::uint32_t index_of(const Point3& p) {
    const auto [found, added] = indices_.try_emplace(p, static_cast<std::uint32_t>(points_.size()));
    if (added) points_.push_back(p);
    return found->second;
  }

 private:
  struct Hash {
    std::size_t operator()(const Point3& p) const { return mixed(mixed(mixed(0, p.x), p.y), p.z); }

    /// Adding 0 makes 0 of −0. The constants are those of the finaliser of splitmix64.
    static std::uint64_t mixed(std::uint64_t h, double x) {
      h += 0x9e3779b97f4a7c15u + std::bit_cast<std::uint64_t>(x + 0.0);
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
      h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
      return h ^ (h >> 31);
    }
  };

  std::vector<Point3>& points_;
  std::unordered_map<Point3, std::uint32_t, Hash> indices_;
};

}  // namespace tribunal
