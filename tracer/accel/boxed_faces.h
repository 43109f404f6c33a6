// Which faces a probe may meet: all of them, those of the solids whose box it meets, or those of a tree of boxes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "tracer/accel/statistics.h"
#include "tracer/accel/wide/box.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal {

/// `none`: every face is tested; `boxes`: one box a solid, as in the paper; `bvh`: a tree of boxes, eight a node.
enum class Accel : std::uint8_t { none, boxes, bvh };

constexpr std::string_view name_of(Accel a) {
  constexpr std::string_view names[] = {"none", "boxes", "bvh"};
  return names[static_cast<int>(a)];
}

/// The faces of a scene by id; the faces of one solid follow each other. A face is a triangle or a polygon.
struct FaceList {
  std::span<const Triangle> triangles;  ///< of face i: the face itself, or a triangle that spans the polygon's plane
  std::span<const std::uint32_t> solid_of;
  std::span<const std::int32_t> polygon_of;  ///< of face i: an index into polygons, −1 for triangles
  std::span<const Box> polygon_boxes;

  Box box(std::size_t id) const {
    return polygon_of[id] < 0 ? box_of(triangles[id]) : polygon_boxes[static_cast<std::size_t>(polygon_of[id])];
  }
};

/// The triangles of all faces, each kept once (in a list, or in the leaves of the tree), and the boxes over them.
class BoxedFaces {
 public:
  BoxedFaces() = default;
  BoxedFaces(Accel mode, const FaceList& faces);

  std::size_t size() const { return tree_.empty() ? list_.size() : places_.size(); }
  Triangle operator[](std::uint32_t id) const;

  /// The tree of boxes in mode `bvh`, else null.
  const WideTree* tree() const { return tree_.empty() ? nullptr : &tree_; }

  /// The boxes that a walk still has to enter, and their solids: memory that each thread keeps for its walks.
  using Waiting = std::vector<std::pair<double, std::uint32_t>>;

  /// In modes `none` and `boxes`: calls visit(id) for the faces of all solids that the probe may meet, nearer boxes
  /// first, until `visit` returns true. Boxes that the probe enters at t > limit are skipped; `visit` may lower
  /// `limit`. Law: every face that the probe exactly meets at t ≤ limit is visited.
  template <class Visit>
  void visit(const BoxProbe& probe, const double& limit, Waiting& waiting, RayTally& tally, const Visit& visit) const {
    if (!boxed_) {
      for (std::uint32_t id = 0; id < list_.size(); ++id) {
        if (visit(id)) return;
      }
      return;
    }
    enter(probe, waiting, tally);
    for (const auto& [entry, solid] : waiting) {
      if (entry > limit) return;
      for (std::uint32_t id = solids_[solid].first; id < solids_[solid].end; ++id) {
        if (visit(id)) return;
      }
    }
  }

  std::size_t bytes() const;

 private:
  struct Solid {
    Box box;
    std::uint32_t first, end;  ///< its faces are those with first ≤ id < end
  };

  /// The lane of a Place that refers to the list instead of to a leaf of the tree.
  static constexpr std::uint32_t in_list = 0xffffffff;

  void box_solids(const FaceList& faces);
  void plant_tree(const FaceList& faces);
  void enter(const BoxProbe& probe, Waiting& waiting, RayTally& tally) const;

  std::vector<Triangle> list_;  ///< all triangles; in mode `bvh` only those that span the planes of polygons
  bool boxed_ = false;
  std::vector<Solid> solids_;
  WideTree tree_;
  std::vector<Place> places_;  ///< of face i; if its lane is in_list, the leaf's bits are an index into list_
};

}  // namespace tribunal
