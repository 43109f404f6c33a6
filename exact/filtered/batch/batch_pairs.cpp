// Answers pairs in any order: sorts them into columns by kind of probe, and asks block by block.
#include <array>
#include <stdexcept>
#include <variant>

#include "exact/filtered/batch.h"
#include "exact/filtered/batch/batch_target.h"
#include "exact/filtered/filtered.h"

namespace tribunal {
namespace {

constexpr std::size_t block = 256;

/// Up to a block of pairs of one kind, by columns, with the places where their answers go.
class Block {
 public:
  template <class P>
  void add(const P& probe, const Triangle& t, std::size_t place) {
    const Point3 vertices[5] = {source(probe), point_of(target(probe)), t.a, t.b, t.c};
    for (std::size_t v = 0; v < 5; ++v) {
      for (int axis = 0; axis < 3; ++axis) columns_[3 * v + static_cast<std::size_t>(axis)][size_] = vertices[v][axis];
    }
    places_[size_++] = static_cast<std::uint32_t>(place);
  }

  bool full() const { return size_ == block; }

  /// Answers the pairs of the block and empties it.
  void answer(FilterPairs filter, std::size_t lanes, std::span<const TrianglePair> pairs, std::span<Answer> answers) {
    std::array<const double*, 15> columns;
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c] = columns_[c].data();
    std::array<std::uint8_t, block> hit;
    std::array<std::uint32_t, block> undecided;
    const std::size_t whole = size_ - size_ % lanes;
    const std::size_t left = filter(columns.data(), whole, hit.data(), undecided.data());
    for (std::size_t i = 0; i < whole; ++i) answers[places_[i]] = certain(hit[i] != 0);
    const auto ask = [&](std::size_t i) { answers[places_[i]] = intersect(pairs[places_[i]]); };
    for (std::size_t k = 0; k < left; ++k) ask(undecided[k]);
    for (std::size_t i = whole; i < size_; ++i) ask(i);
    size_ = 0;
  }

 private:
  static const Point3& point_of(const Point3& p) { return p; }
  static const Point3& point_of(const Direction& d) { return d.v; }

  std::array<std::array<double, block>, 15> columns_;
  std::array<std::uint32_t, block> places_;
  std::size_t size_ = 0;
};

}  // namespace

void intersect(std::span<const TrianglePair> pairs, std::span<Answer> answers) {
  if (pairs.size() != answers.size()) throw std::invalid_argument("batch: not one answer for each pair");
  const BatchTarget& target = batch_target();
  Block segments, rays;
  const auto answer_segments = [&] { segments.answer(target.segments, target.lanes, pairs, answers); };
  const auto answer_rays = [&] { rays.answer(target.rays, target.lanes, pairs, answers); };
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const TrianglePair& q = pairs[i];
    if (const auto* s = std::get_if<Segment>(&q.probe)) {
      segments.add(*s, q.triangle, i);
      if (segments.full()) answer_segments();
    } else {
      rays.add(std::get<Ray>(q.probe), q.triangle, i);
      if (rays.full()) answer_rays();
    }
  }
  answer_segments();
  answer_rays();
}

}  // namespace tribunal
