// The probes of a packet made ready for boxes: probe.h on lanes. Included by files that are compiled for one
// instruction set each.
#pragma once

#include "exact/filtered/batch/lanes.h"
#include "tracer/accel/wide/packet.h"
#include "tracer/accel/wide/probe.h"

namespace tribunal::HWY_NAMESPACE {

using BoxTag = hn::CappedTag<float, node_width>;
using BoxVector = hn::Vec<BoxTag>;

inline constexpr BoxTag box_tag;
inline constexpr std::size_t double_lanes = HWY_LANES(double), double_chunks = packet_size / double_lanes;

/// The constants of WideProbe, a probe a lane, computed by the same operations, so that its proof holds for them. A
/// lane whose probe is not finite, or its start or scale out of range, is not `held`.
struct PacketProbe {
  struct Axis {
    alignas(64) float r[packet_size], near_c[packet_size], far_c[packet_size];
    unsigned backward;  ///< lanes whose probe runs from hi to lo
  };

  template <class P>
  static HWY_INLINE PacketProbe of(const ProbePacket& p, const Frame& frame) {
    PacketProbe probe;
    for (Axis& a : probe.axes) a.backward = 0;
    for (std::size_t k = 0; k < packet_size; k += double_lanes) probe.template set<P>(p, frame, k);
    return probe;
  }

  Axis axes[3];
  alignas(64) double scale[packet_size];
  unsigned held = 0;

 private:
  using Bits = hn::RebindToUnsigned<Tag>;
  using Halves = hn::Rebind<float, Tag>;

  static constexpr double smallest_component = 0x1p-60, farthest_start = 0x1p30;
  static constexpr std::uint64_t exponent_bits = 0x7ff0000000000000;

  static HWY_INLINE Vector largest(const Vector* v) {
    return hn::Max(hn::Max(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2]));
  }

  template <class P>
  HWY_INLINE void set(const ProbePacket& p, const Frame& frame, std::size_t k) {
    const Bits bits;
    const Halves halves;
    Vector d[3], s[3], sum = hn::Zero(tag);
    for (int i = 0; i < 3; ++i) {
      const Vector o = hn::Load(tag, p.source[i] + k), to = hn::Load(tag, p.target[i] + k);
      sum = hn::Add(sum, hn::Add(hn::Abs(o), hn::Abs(to)));
      d[i] = std::is_same_v<P, Segment> ? hn::Sub(to, o) : to;
      s[i] = hn::Mul(hn::Set(tag, frame.unit), hn::Sub(o, hn::Set(tag, frame.centre[i])));
    }
    const Vector size = largest(d), start = largest(s);
    const auto exponent = hn::And(hn::BitCast(bits, size), hn::Set(bits, exponent_bits));
    const Vector power = hn::BitCast(tag, exponent);
    const Vector inverse = hn::BitCast(tag, hn::Sub(hn::Set(bits, std::uint64_t{2046} << 52), exponent));
    const Vector scales = hn::Mul(hn::Set(tag, frame.unit), power);
    const LaneMask held_here = (Lanes(power) >= Lanes(0x1p-900)) & (Lanes(power) <= Lanes(0x1p900)) &
                               (Lanes(scales) >= Lanes(0x1p-1000)) & (Lanes(scales) <= Lanes(0x1p1000)) &
                               (Lanes(start) <= Lanes(farthest_start)) &
                               (Lanes(sum) <= Lanes(std::numeric_limits<double>::max()));
    held |= held_here.bits() << k;
    hn::Store(scales, tag, scale + k);
    const Vector widening =
        hn::Add(hn::Mul(hn::Add(hn::Set(tag, frame.reach), start), hn::Set(tag, 0x1p-20)), hn::Set(tag, 0x1p-100));
    for (int i = 0; i < 3; ++i) {
      const Vector delta = hn::Mul(d[i], inverse);
      const Vector positive = hn::Div(hn::Set(tag, 1.0), hn::Max(hn::Abs(delta), hn::Set(tag, smallest_component)));
      const auto r = hn::DemoteTo(halves, hn::CopySign(positive, delta));
      const Vector c = hn::Mul(s[i], hn::PromoteTo(tag, r));
      const Vector e = hn::Mul(widening, hn::Mul(positive, hn::Set(tag, 1 + 0x1p-23)));
      hn::StoreU(r, halves, axes[i].r + k);
      hn::StoreU(hn::DemoteTo(halves, hn::Add(c, e)), halves, axes[i].near_c + k);
      hn::StoreU(hn::DemoteTo(halves, hn::Sub(c, e)), halves, axes[i].far_c + k);
      axes[i].backward |= (Lanes(hn::CopySign(hn::Set(tag, 1.0), delta)) < Lanes(0.0)).bits() << k;
    }
  }
};

/// The boxes of a node's children against all probes, one child at a time.
class PacketBoxes {
 public:
  HWY_INLINE explicit PacketBoxes(const PacketProbe& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t c = 0; c < chunks; ++c) {
        const std::size_t k = c * width;
        const std::uint8_t backward = static_cast<std::uint8_t>(p.axes[i].backward >> k);
        r_[i][c] = hn::LoadU(box_tag, p.axes[i].r + k);
        near_c_[i][c] = hn::LoadU(box_tag, p.axes[i].near_c + k);
        far_c_[i][c] = hn::LoadU(box_tag, p.axes[i].far_c + k);
        backward_[i][c] = hn::LoadMaskBits(box_tag, &backward);
      }
    }
  }

  /// The lanes that may meet a child at τ ≤ their limit; entry[lane] is where.
  HWY_INLINE unsigned entered(const WideNode& node, std::size_t child, const float* limit, float* entry) const {
    unsigned met = 0;
    for (std::size_t c = 0; c < chunks; ++c) {
      BoxVector first = hn::Zero(box_tag), last = hn::LoadU(box_tag, limit + c * width);
      for (std::size_t i = 0; i < 3; ++i) {
        const BoxVector lo = hn::Set(box_tag, node.plane[i][child]), hi = hn::Set(box_tag, node.plane[i + 3][child]);
        const BoxVector in = hn::IfThenElse(backward_[i][c], hi, lo), out = hn::IfThenElse(backward_[i][c], lo, hi);
        first = hn::Max(first, hn::MulSub(in, r_[i][c], near_c_[i][c]));
        last = hn::Min(last, hn::MulSub(out, r_[i][c], far_c_[i][c]));
      }
      hn::StoreU(first, box_tag, entry + c * width);
      met |= bits_of(hn::Le(first, last)) << (c * width);
    }
    return met;
  }

  /// The lanes whose entry is not beyond their limit.
  static HWY_INLINE unsigned within(const float* entry, const float* limit) {
    unsigned in = 0;
    for (std::size_t k = 0; k < packet_size; k += width)
      in |= bits_of(hn::Le(hn::LoadU(box_tag, entry + k), hn::LoadU(box_tag, limit + k))) << k;
    return in;
  }

 private:
  static constexpr std::size_t width = HWY_LANES(float) < node_width ? HWY_LANES(float) : node_width,
                               chunks = packet_size / width;

  static HWY_INLINE unsigned bits_of(hn::Mask<BoxTag> mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(box_tag, mask, bits);
    return bits[0];
  }

  BoxVector r_[3][chunks], near_c_[3][chunks], far_c_[3][chunks];
  hn::Mask<BoxTag> backward_[3][chunks];
};

}  // namespace tribunal::HWY_NAMESPACE
