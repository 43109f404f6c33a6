// Boxes that wait to be entered, without branches that depend on which these are. Included by files that are compiled
// for one instruction set each.
#pragma once

#include "tracer/accel/wide/traversal_lanes.h"

namespace tribunal::HWY_NAMESPACE {

using KeyTag = hn::RebindToUnsigned<BoxTag>;
using WaitingTag = hn::CappedTag<std::uint32_t, 16>;

inline constexpr KeyTag key_tag;
inline constexpr WaitingTag waiting_tag;

/// The bits of each entry as an integer, with the number of its lane in the last bits. Since no entry is negative,
/// the least key names the lane of the least entry and, without those last bits, is a lower bound of that entry.
template <class D>
HWY_INLINE hn::Vec<D> keys(D d, const float* entry, std::size_t first, std::uint32_t lane_bits) {
  const auto bits = hn::BitCast(d, hn::LoadU(hn::RebindToFloat<D>(), entry));
  return hn::Or(hn::AndNot(hn::Set(d, lane_bits), bits), hn::Iota(d, static_cast<std::uint32_t>(first)));
}

/// The child that is entered first among those met, up to the last bits of the entry; an arbitrary one if none is
/// met.
HWY_INLINE unsigned nearest_of(const float* entry, unsigned met) {
  const auto none = hn::Set(key_tag, ~0U);
  auto least = none;
  for (std::size_t k = 0; k < node_width; k += hn::Lanes(key_tag)) {
    const auto key = keys(key_tag, entry + k, k, node_width - 1);
    least = hn::Min(least, hn::IfThenElse(mask_of(key_tag, met >> k), key, none));
  }
  return hn::GetLane(hn::MinOfLanes(key_tag, least)) & (node_width - 1);
}

/// Boxes that wait to be entered, in no order.
class WaitingBoxes {
 public:
  void clear() { size_ = 0; }
  bool empty() const { return size_ == 0; }

  /// Whether there is room for all children of a node.
  bool has_room() const { return size_ + node_width <= capacity; }

  HWY_INLINE void push(const float* entry, const NodeRef* child, unsigned met) {
    static_assert(sizeof(NodeRef) == sizeof(std::uint32_t));
    std::size_t end = size_;
    for (std::size_t k = 0; k < node_width; k += hn::Lanes(key_tag)) {
      const auto lanes = mask_of(key_tag, met >> k);
      store(entry + k, lanes, entry_ + end);
      store(child + k, lanes, child_ + end);
      end += hn::CountTrue(key_tag, lanes);
    }
    size_ = end;
  }

  /// Removes the box that is entered first, up to the last bits of the entry. Returns a lower bound of all entries.
  /// Must not be empty.
  HWY_INLINE float pop(NodeRef& child) {
    constexpr std::uint32_t step = hn::MaxLanes(waiting_tag);
    std::uint32_t least = ~0U;
    std::size_t k = 0;
    for (std::size_t i = 0; i < size_; i += step) {
      const auto here = hn::IfThenElse(hn::FirstN(waiting_tag, size_ - i), keys(waiting_tag, entry_ + i, 0, step - 1),
                                       hn::Set(waiting_tag, ~0U));
      const std::uint32_t key = hn::GetLane(hn::MinOfLanes(waiting_tag, here));
      k = key < least ? i + key % step : k;
      least = std::min(least, key);
    }
    child = NodeRef(child_[k]);
    --size_;
    entry_[k] = entry_[size_];
    child_[k] = child_[size_];
    return std::bit_cast<float>(least / step * step);
  }

 private:
  static constexpr std::size_t capacity = 48;  ///< walks seldom need more than 16
  static constexpr std::size_t slack = 16;     ///< whole vectors are loaded and stored

  using Key = hn::Vec<KeyTag>;

  static HWY_INLINE Key load(const float* from) { return hn::BitCast(key_tag, hn::LoadU(box_tag, from)); }
  static HWY_INLINE Key load(const NodeRef* from) {
    return hn::LoadU(key_tag, reinterpret_cast<const std::uint32_t*>(from));  // all that a NodeRef has
  }
  static HWY_INLINE void put(Key keys, float* to) { hn::StoreU(hn::BitCast(box_tag, keys), box_tag, to); }
  static HWY_INLINE void put(Key keys, std::uint32_t* to) { hn::StoreU(keys, key_tag, to); }

  /// Stores the numbers of the selected lanes contiguously.
  template <class From, class To>
  static HWY_INLINE void store(const From* from, hn::Mask<KeyTag> lanes, To* to) {
    put(hn::Compress(load(from), lanes), to);
  }

  std::size_t size_;
  float entry_[capacity + slack];
  std::uint32_t child_[capacity + slack];
};

}  // namespace tribunal::HWY_NAMESPACE
