// The probes of many rays, a ray a lane. Included by files that are compiled for one instruction set each.
#pragma once

#include "exact/filtered/batch/lanes.h"
#include "tracer/accel/wide/probe.h"

namespace tribunal::HWY_NAMESPACE {

/// As many rays as there are lanes, by the operations of probe.cpp in their order: so the constants are the same, bit
/// for bit. What is out of the ordinary is left to the constructor.
class ProbeLanes {
 public:
  ProbeLanes(const Ray* rays, hn::Vec<hn::RebindToSigned<Tag>> start_of_ray, const Frame& frame) {
    const double* const numbers = &rays->o.x;
    const auto number = [&](std::size_t k) HWY_ATTR { return hn::GatherIndex(tag, numbers + k, start_of_ray); };
    const Vector d[3] = {number(3), number(4), number(5)};
    const Vector size = largest(d), power = power_below(size);
    const Vector from[3] = {in_frame(number(0), frame.centre.x, frame.unit),
                            in_frame(number(1), frame.centre.y, frame.unit),
                            in_frame(number(2), frame.centre.z, frame.unit)};
    const Vector start = largest(from), scale = hn::Mul(hn::Set(tag, frame.unit), power);
    ordinary_ = (within(size, 0x1p-900, 0x1p900) & within(start, 0, WideProbe::farthest_start) &
                 within(scale, WideProbe::least_scale, 1 / WideProbe::least_scale))
                    .bits();
    hn::StoreU(scale, tag, scale_);
    const Vector widening =
        hn::Add(hn::Mul(hn::Add(hn::Set(tag, frame.reach), start), hn::Set(tag, 0x1p-20)), hn::Set(tag, 0x1p-100));
    const Vector inverse = inverse_of(power);
    for (int i = 0; i < 3; ++i) set_axis(i, from[i], hn::Mul(d[i], inverse), widening);
  }

  /// Whether the ray in lane k needs no special care.
  bool is_ordinary(std::size_t k) const { return (ordinary_ >> k & 1) != 0; }

  /// Of an ordinary one. Number by number where it belongs: a copy of what was just written would wait for it.
  HWY_INLINE void write(std::size_t k, WideProbe& p) const {
    p.scale = scale_[k];
    for (std::uint32_t i = 0; i < 3; ++i) {
      p.axes[i] = WideProbe::axis(i, r_[i][k], near_c_[i][k], far_c_[i][k], (backward_[i] >> k & 1) != 0);
    }
  }

 private:
  using Floats = hn::Rebind<float, Tag>;
  using Bits = hn::RebindToUnsigned<Tag>;

  static Vector largest(const Vector* v) { return hn::Max(hn::Max(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2])); }
  static Vector in_frame(Vector x, double centre, double unit) {
    return hn::Mul(hn::Set(tag, unit), hn::Sub(x, hn::Set(tag, centre)));
  }
  static LaneMask within(Vector x, double least, double most) {
    return {hn::And(hn::Ge(x, hn::Set(tag, least)), hn::Le(x, hn::Set(tag, most)))};
  }
  static Vector power_below(Vector x) { return hn::And(x, hn::BitCast(tag, hn::Set(Bits(), 0x7ff0000000000000))); }
  static Vector inverse_of(Vector power) {
    return hn::BitCast(tag, hn::Sub(hn::Set(Bits(), std::uint64_t{2046} << 52), hn::BitCast(Bits(), power)));
  }

  HWY_INLINE void set_axis(int i, Vector from, Vector delta, Vector widening) {
    const Vector smallest = hn::Set(tag, WideProbe::smallest_component), magnitude = hn::Abs(delta);
    const Vector positive =
        hn::Div(hn::Set(tag, 1.0), hn::IfThenElse(hn::Lt(magnitude, smallest), smallest, magnitude));
    const auto r = hn::DemoteTo(Floats(), hn::CopySign(positive, delta));
    const Vector c = hn::Mul(from, hn::PromoteTo(tag, r)),
                 e = hn::Mul(widening, hn::Mul(positive, hn::Set(tag, 1 + 0x1p-23)));
    hn::StoreU(r, Floats(), r_[i]);
    hn::StoreU(hn::DemoteTo(Floats(), hn::Add(c, e)), Floats(), near_c_[i]);
    hn::StoreU(hn::DemoteTo(Floats(), hn::Sub(c, e)), Floats(), far_c_[i]);
    const hn::RebindToSigned<Tag> bits;
    backward_[i] = LaneMask{hn::RebindMask(tag, hn::Lt(hn::BitCast(bits, delta), hn::Zero(bits)))}.bits();
  }

  unsigned ordinary_, backward_[3];
  double scale_[8];
  float r_[3][8], near_c_[3][8], far_c_[3][8];
};

/// The probe of each ray.
[[gnu::flatten]] inline void make_probes(std::span<const Ray> rays, const Frame& frame, WideProbe* probes) {
  static_assert(sizeof(Ray) == 6 * sizeof(double));
  constexpr hn::RebindToSigned<Tag> indices;
  constexpr std::size_t step = HWY_LANES(double);
  for (std::size_t i = 0; i < rays.size(); i += step) {
    const std::size_t count = std::min(step, rays.size() - i);
    const auto lane = hn::Min(hn::Iota(indices, 0), hn::Set(indices, static_cast<std::int64_t>(count) - 1));
    const ProbeLanes lanes(&rays[i], hn::Add(hn::ShiftLeft<2>(lane), hn::ShiftLeft<1>(lane)), frame);
    for (std::size_t k = 0; k < count; ++k) {
      if (HWY_LIKELY(lanes.is_ordinary(k))) {
        lanes.write(k, probes[i + k]);
      } else {
        probes[i + k] = WideProbe(rays[i + k], frame);
      }
    }
  }
}

}  // namespace tribunal::HWY_NAMESPACE
