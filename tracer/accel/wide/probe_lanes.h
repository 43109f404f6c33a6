// Probes made ready for boxes, a probe a lane: probe.h on lanes. Included by files that are compiled for one
// instruction set each.
#pragma once

#include "exact/filtered/batch/lanes.h"
#include "tracer/accel/wide/probe.h"

namespace tribunal::HWY_NAMESPACE {

/// The constants of up to eight probes by columns. They are computed by the operations of probe.cpp in the same
/// order, so they are the same bit for bit, and the proof in probe.h holds for them. `held` has a bit for each probe
/// that is finite and within the frame's range; the constants of other probes mean nothing.
struct ProbeColumns {
  static constexpr std::size_t size = 8;

  struct Axis {
    alignas(64) float r[size], near_c[size], far_c[size];
    unsigned backward = 0;  ///< probes with a negative direction on this axis, a bit each
  };

  /// Sets the columns from probe k on, as many probes as a vector has lanes; `d` is a ray's direction or a segment's
  /// difference of ends.
  HWY_INLINE void set(std::size_t k, const Vector (&o)[3], const Vector (&d)[3], const Frame& frame) {
    const Vector length = largest(d), power = power_below(length), inverse = inverse_of(power);
    const Vector from[3] = {in_frame(o[0], frame.centre.x, frame.unit), in_frame(o[1], frame.centre.y, frame.unit),
                            in_frame(o[2], frame.centre.z, frame.unit)};
    const Vector start = largest(from), scales = hn::Mul(hn::Set(tag, frame.unit), power);
    held |= (within(length, 0x1p-900, 0x1p900) & within(start, 0, WideProbe::farthest_start) &
             within(scales, WideProbe::least_scale, 1 / WideProbe::least_scale) &
             within(hn::Add(sum(o), sum(d)), 0, std::numeric_limits<double>::max()))
                .bits()
            << k;
    hn::StoreU(scales, tag, scale + k);
    const Vector widening =
        hn::Add(hn::Mul(hn::Add(hn::Set(tag, frame.reach), start), hn::Set(tag, 0x1p-20)), hn::Set(tag, 0x1p-100));
    for (int i = 0; i < 3; ++i) set_axis(axes[i], k, from[i], hn::Mul(d[i], inverse), widening);
  }

  Axis axes[3];
  alignas(64) double scale[size];
  unsigned held = 0;

 private:
  using Floats = hn::Rebind<float, Tag>;
  using Bits = hn::RebindToUnsigned<Tag>;

  // A NaN may go unseen by `largest`, not by `sum`.
  static Vector largest(const Vector* v) { return hn::Max(hn::Max(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2])); }
  static Vector sum(const Vector* v) { return hn::Add(hn::Add(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2])); }
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

  static HWY_INLINE void set_axis(Axis& axis, std::size_t k, Vector from, Vector delta, Vector widening) {
    const Vector smallest = hn::Set(tag, WideProbe::smallest_component), magnitude = hn::Abs(delta);
    const Vector positive =
        hn::Div(hn::Set(tag, 1.0), hn::IfThenElse(hn::Lt(magnitude, smallest), smallest, magnitude));
    const auto r = hn::DemoteTo(Floats(), hn::CopySign(positive, delta));
    const Vector c = hn::Mul(from, hn::PromoteTo(tag, r)),
                 e = hn::Mul(widening, hn::Mul(positive, hn::Set(tag, 1 + 0x1p-23)));
    hn::StoreU(r, Floats(), axis.r + k);
    hn::StoreU(hn::DemoteTo(Floats(), hn::Add(c, e)), Floats(), axis.near_c + k);
    hn::StoreU(hn::DemoteTo(Floats(), hn::Sub(c, e)), Floats(), axis.far_c + k);
    const hn::RebindToSigned<Tag> bits;
    axis.backward |= LaneMask{hn::RebindMask(tag, hn::Lt(hn::BitCast(bits, delta), hn::Zero(bits)))}.bits() << k;
  }
};

/// Writes probe k to p, number by number: a wide copy would have to wait until the narrow stores just made are in the
/// cache.
HWY_INLINE void write(const ProbeColumns& columns, std::size_t k, WideProbe& p) {
  p.scale = columns.scale[k];
  for (std::uint32_t i = 0; i < 3; ++i) {
    const ProbeColumns::Axis& a = columns.axes[i];
    p.axes[i] = WideProbe::axis(i, a.r[k], a.near_c[k], a.far_c[k], (a.backward >> k & 1) != 0);
  }
}

/// Makes the probe of each ray; the scale is NaN where the ray is not finite.
[[gnu::flatten]] inline void make_probes(std::span<const Ray> rays, const Frame& frame, WideProbe* probes) {
  static_assert(sizeof(Ray) == 6 * sizeof(double));
  constexpr hn::RebindToSigned<Tag> indices;
  constexpr std::size_t step = HWY_LANES(double);
  for (std::size_t i = 0; i < rays.size(); i += step) {
    const std::size_t count = std::min(step, rays.size() - i);
    const auto lane = hn::Min(hn::Iota(indices, 0), hn::Set(indices, static_cast<std::int64_t>(count) - 1));
    const auto start_of_ray = hn::Add(hn::ShiftLeft<2>(lane), hn::ShiftLeft<1>(lane));
    const auto number = [&](std::size_t n) HWY_ATTR { return hn::GatherIndex(tag, &rays[i].o.x + n, start_of_ray); };
    const Vector o[3] = {number(0), number(1), number(2)}, d[3] = {number(3), number(4), number(5)};
    ProbeColumns columns;
    columns.set(0, o, d, frame);
    for (std::size_t k = 0; k < count; ++k) {
      if (HWY_LIKELY((columns.held >> k & 1) != 0)) {
        write(columns, k, probes[i + k]);
      } else {
        probes[i + k] = WideProbe(rays[i + k], frame);
        if (!is_finite(rays[i + k])) probes[i + k].scale = std::numeric_limits<double>::quiet_NaN();
      }
    }
  }
}

}  // namespace tribunal::HWY_NAMESPACE
