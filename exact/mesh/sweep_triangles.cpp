#include "exact/mesh/sweep_triangles.h"

#include <algorithm>
#include <deque>
#include <set>

#include "exact/kernels/product_sum.h"

// A vertical line moves over the face from left to right and stops at every place. It crosses the edges in an order
// from below to above that changes at places only, unless two edges cross: then two neighbours do, at the first
// crossing, and they are tried when they become neighbours. Source: Shamos & Hoey, "Geometric intersection problems",
// FOCS 1976.
//
// Between two neighbouring edges lies a region to the left of the line. What has not been tiled of it lies between
// its two edges and a chain of places that runs from the left end of the lower edge to that of the upper one. The
// last place met is the rightmost of the chain; from there both arms of it run to the left, and no corner on them is
// less than 180° on the side of the line. So from the right end v of the lower edge all of the lower arm is seen,
// strictly, since no place but its end lies on the edge; and a first part of the upper arm. Triangles to what is seen
// leave a chain of the same kind, of which v is the last place. Source: Hertel & Mehlhorn, "Fast triangulation of
// simple polygons", FCT 1983.
namespace tribunal {
namespace {

using Place = std::uint32_t;
using Arm = std::vector<Place>;

/// What bounds, to the left, the part of a region that has not been tiled. The arms end with the last place met.
struct Chain {
  Arm lower, upper;
};

/// The right end of an edge, and which way it runs: 1 to the right, −1 to the left.
struct End {
  Place place;
  int weight;
};

/// What lies between two neighbouring bundles.
struct Region {
  int winding = 0;  ///< how often the rings wind around it: once, or not at all
  Chain chain{};    ///< if they do
};

/// Edges that lie on one line and that the sweep line crosses at one point.
struct Bundle {
  Place left = 0, right = 0;  ///< two places on the line: the last one met, and the farthest end
  int weight = 0;             ///< how many run to the right, less how many run to the left
  std::vector<End> ends{};    ///< a heap, the nearest first
  Region above{};
};

bool is_farther(const End& a, const End& b) { return a.place > b.place; }

class Sweep {
 public:
  explicit Sweep(const FlatFace& face) : places_(face.places), starts_(face.places.size() + 1), status_(Below{this}) {
    for (const auto& [from, to] : face.edges) ++starts_[std::min(from, to) + 1];
    for (std::size_t p = 1; p < starts_.size(); ++p) starts_[p] += starts_[p - 1];
    edges_.resize(face.edges.size());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const auto& [from, to] : face.edges) {
      edges_[next[std::min(from, to)]++] = from < to ? End{to, 1} : End{from, -1};
    }
  }

  std::optional<std::vector<std::array<Place, 3>>> triangles() {
    for (Place v = 0; v < places_.size(); ++v) {
      if (!stop_at(v)) return std::nullopt;
    }
    return std::move(triangles_);
  }

 private:
  /// The order in which the sweep line crosses bundles, and where a place is among them.
  struct Below {
    const Sweep* sweep;
    using is_transparent = void;

    bool operator()(const Bundle* a, const Bundle* b) const { return sweep->is_below(*a, *b); }
    bool operator()(const Bundle* a, Place v) const { return sweep->side(*a, v) == Sign::positive; }
    bool operator()(Place v, const Bundle* b) const { return sweep->side(*b, v) == Sign::negative; }
  };
  using Status = std::set<Bundle*, Below>;

  Sign turn(Place a, Place b, Place c) const {
    return ProductSumKernel().orient2d(Axis::z, places_[a], places_[b], places_[c]);
  }

  /// Positive if the place is above the line of the bundle, of whose ends it is between, as the sweep line meets them.
  Sign side(const Bundle& b, Place v) const {
    const auto [low, high] = std::minmax(places_[b.left].y, places_[b.right].y);
    if (places_[v].y > high) return Sign::positive;
    if (places_[v].y < low) return Sign::negative;
    return turn(b.left, b.right, v);
  }

  bool is_below(const Bundle& a, const Bundle& b) const {
    if (a.left == b.left) return turn(a.left, a.right, b.right) == Sign::positive;
    return a.left < b.left ? side(a, b.left) == Sign::positive : side(b, a.left) == Sign::negative;
  }

  /// Whether a bundle and the next one above it cross, to the right of the sweep line.
  bool crosses(const Bundle& low, const Bundle& high) const {
    return low.right < high.right ? side(high, low.right) == Sign::positive : side(low, high.right) == Sign::negative;
  }

  /// Takes what ends or starts at the place. False if the face must be refused.
  bool stop_at(Place v) {
    const auto [first, last] = status_.equal_range(v);
    Bundle* const under = first == status_.begin() ? nullptr : *std::prev(first);
    met_.assign(first, last);
    const auto over = status_.erase(first, last);
    starting_.clear();
    if (!end_or_pass(v)) return false;
    start(v);
    sort_starting(v);
    if (!wind(under)) return false;
    tile(v, under);
    for (Bundle* const b : starting_) status_.insert(over, b);
    return keeps_order(under, over == status_.end() ? nullptr : *over);
  }

  /// Takes the regions and the ends of the bundles that meet the place. False if two go on: they cross.
  bool end_or_pass(Place v) {
    left_.clear();
    for (Bundle* const b : met_) {
      left_.push_back(std::move(b->above));
      for (; !b->ends.empty() && b->ends.front().place == v; b->ends.pop_back()) {
        b->weight -= b->ends.front().weight;
        std::ranges::pop_heap(b->ends, is_farther);
      }
      b->left = v;
      (b->ends.empty() ? unused_ : starting_).push_back(b);
    }
    return starting_.size() < 2;
  }

  /// Makes a bundle of each edge that starts at the place.
  void start(Place v) {
    for (std::uint32_t e = starts_[v]; e < starts_[v + 1]; ++e) {
      if (unused_.empty()) unused_.push_back(&bundles_.emplace_back());
      Bundle* const b = unused_.back();
      unused_.pop_back();
      b->left = v;
      b->right = edges_[e].place;
      b->weight = edges_[e].weight;
      b->ends.assign(1, edges_[e]);
      starting_.push_back(b);
    }
  }

  /// From below to above; those on one line become one.
  void sort_starting(Place v) {
    std::ranges::sort(starting_, Below{this});
    std::size_t kept = 0;
    for (std::size_t i = 1; i < starting_.size(); ++i) {
      if (turn(v, starting_[kept]->right, starting_[i]->right) == Sign::zero) {
        unite(starting_[kept], starting_[i]);
      } else {
        starting_[++kept] = starting_[i];
      }
    }
    if (!starting_.empty()) starting_.resize(kept + 1);
  }

  /// The smaller heap goes into the greater one, so an end moves at most log n times.
  void unite(Bundle* into, Bundle* from) {
    if (into->ends.size() < from->ends.size()) into->ends.swap(from->ends);
    for (const End& e : from->ends) {
      into->ends.push_back(e);
      std::ranges::push_heap(into->ends, is_farther);
    }
    into->weight += from->weight;
    into->right = std::max(into->right, from->right);
    unused_.push_back(from);
  }

  /// Counts the windings around the regions that start. False if there are others than 0 and 1.
  bool wind(const Bundle* under) {
    int winding = under == nullptr ? 0 : under->above.winding;
    for (Bundle* const b : starting_) {
      winding += b->weight;
      if (winding != 0 && winding != 1) return false;
      b->above.winding = winding;
    }
    return true;
  }

  /// Ends regions, starts others, and tells those under and over the place of it. These two are one before, if nothing
  /// has met the place, and after, if nothing starts there.
  void tile(Place v, Bundle* under) {
    if (left_.empty() && starting_.empty()) return;
    for (std::size_t i = 0; i + 1 < left_.size(); ++i) {
      if (left_[i].winding == 1) see_from_below(v, left_[i].chain);
    }
    for (Bundle* const b : starting_) b->above.chain = {{v}, {v}};
    if (left_.empty()) left_.push_back(divide(under));
    if (under != nullptr && under->above.winding == 1) see_from_above(v, under->above.chain);
    if (left_.back().winding == 1) see_from_below(v, left_.back().chain);
    if (!starting_.empty()) {
      starting_.back()->above.chain = std::move(left_.back().chain);
    } else if (under != nullptr) {
      under->above.chain.upper = std::move(left_.back().chain.upper);
    }
  }

  /// Divides the region above a bundle at the last place met, and returns the upper part.
  static Region divide(Bundle* under) {
    if (under == nullptr || under->above.winding == 0) return {};
    Chain& chain = under->above.chain;
    const Place last = chain.upper.back();
    Region upper{1, {{last}, std::move(chain.upper)}};
    chain.upper = {last};
    return upper;
  }

  void see_from_below(Place v, Chain& chain) { see(v, chain.lower, chain.upper, true); }
  void see_from_above(Place v, Chain& chain) { see(v, chain.upper, chain.lower, false); }

  /// Tiles what is seen of a chain from the right end v of an edge; `near` is the arm beside that edge.
  void see(Place v, Arm& near, Arm& far, bool from_below) {
    const auto triangle = [&](Place a, Place b) { return from_below ? std::array{a, v, b} : std::array{b, v, a}; };
    for (std::size_t i = 0; i + 1 < near.size(); ++i) triangles_.push_back(triangle(near[i], near[i + 1]));
    near.assign(1, v);
    for (; far.size() > 1; far.pop_back()) {
      const auto t = triangle(far.back(), far[far.size() - 2]);
      if (turn(t[0], t[1], t[2]) != Sign::positive) break;
      triangles_.push_back(t);
    }
    far.push_back(v);
  }

  /// Whether bundles that have become neighbours do not cross.
  bool keeps_order(const Bundle* under, const Bundle* over) const {
    const Bundle* const first = starting_.empty() ? over : starting_.front();
    const Bundle* const last = starting_.empty() ? nullptr : starting_.back();
    return (under == nullptr || first == nullptr || !crosses(*under, *first)) &&
           (last == nullptr || over == nullptr || !crosses(*last, *over));
  }

  const std::vector<Point3>& places_;
  std::vector<std::uint32_t> starts_;  ///< by place, the first edge of which it is the left end
  std::vector<End> edges_{};
  std::deque<Bundle> bundles_{};
  std::vector<Bundle*> unused_{};
  Status status_;

  // Of the place where the line is: the bundles that have met it and the regions above each, and the bundles that
  // start or go on there.
  std::vector<Bundle*> met_{};
  std::vector<Region> left_{};
  std::vector<Bundle*> starting_{};

  std::vector<std::array<Place, 3>> triangles_{};
};

}  // namespace

std::optional<std::vector<std::array<std::uint32_t, 3>>> sweep_triangles(const FlatFace& face) {
  return Sweep(face).triangles();
}

}  // namespace tribunal
