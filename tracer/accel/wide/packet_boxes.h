// A packet's probes against boxes. Included by files that are compiled for one instruction set each.
#pragma once

#include "tracer/accel/wide/box_lanes.h"
#include "tracer/accel/wide/packet.h"
#include "tracer/accel/wide/probe_lanes.h"

namespace tribunal::HWY_NAMESPACE {

inline constexpr std::size_t double_lanes = HWY_LANES(double);
static_assert(packet_size == ProbeColumns::size && packet_size % double_lanes == 0);

/// The constants for box tests of a packet's probes.
template <class P>
HWY_INLINE void make_ready(const ProbePacket& p, const Frame& frame, ProbeColumns& columns) {
  for (std::size_t k = 0; k < packet_size; k += double_lanes) {
    Vector o[3], d[3];
    for (int i = 0; i < 3; ++i) {
      o[i] = hn::Load(tag, p.source[i] + k);
      d[i] = hn::Load(tag, p.target[i] + k);
      if (std::is_same_v<P, Segment>) d[i] = hn::Sub(d[i], o[i]);
    }
    columns.set(k, o, d, frame);
  }
}

/// The boxes of a node's children against all probes, one child at a time.
class PacketBoxes {
 public:
  HWY_INLINE explicit PacketBoxes(const ProbeColumns& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t c = 0; c < chunks; ++c) {
        const std::size_t k = c * width;
        r_[i][c] = hn::LoadU(box_tag, p.axes[i].r + k);
        near_c_[i][c] = hn::LoadU(box_tag, p.axes[i].near_c + k);
        far_c_[i][c] = hn::LoadU(box_tag, p.axes[i].far_c + k);
        backward_[i][c] = mask_of(box_tag, p.axes[i].backward >> k);
      }
    }
  }

  /// The lanes whose probes may meet the child at τ ≤ their limit; entry[lane] is a lower bound of the τ at which.
  HWY_INLINE unsigned entered(const WideNode& node, std::size_t child, const float* limit, float* entry) const {
    unsigned met = 0;
    for (std::size_t c = 0; c < chunks; ++c) {
      BoxVector first = hn::Zero(box_tag), last = hn::LoadU(box_tag, limit + c * width);
      for (std::size_t i = 0; i < 3; ++i) {
        const BoxVector lo = hn::Set(box_tag, node.plane[i][child]), hi = hn::Set(box_tag, node.plane[i + 3][child]);
        const BoxVector in = hn::IfThenElse(backward_[i][c], hi, lo), out = hn::IfThenElse(backward_[i][c], lo, hi);
        first = hn::Max(hn::MulSub(in, r_[i][c], near_c_[i][c]), first);
        last = hn::Min(last, hn::MulSub(out, r_[i][c], far_c_[i][c]));
      }
      hn::StoreU(first, box_tag, entry + c * width);
      met |= bits_of(box_tag, hn::Le(first, last)) << (c * width);
    }
    return met;
  }

  /// The lanes with entry ≤ limit.
  static HWY_INLINE unsigned within(const float* entry, const float* limit) {
    unsigned in = 0;
    for (std::size_t k = 0; k < packet_size; k += width)
      in |= bits_of(box_tag, hn::Le(hn::LoadU(box_tag, entry + k), hn::LoadU(box_tag, limit + k))) << k;
    return in;
  }

 private:
  static constexpr std::size_t width = HWY_LANES(float) < node_width ? HWY_LANES(float) : node_width,
                               chunks = packet_size / width;

  BoxVector r_[3][chunks], near_c_[3][chunks], far_c_[3][chunks];
  hn::Mask<BoxTag> backward_[3][chunks];
};

}  // namespace tribunal::HWY_NAMESPACE
