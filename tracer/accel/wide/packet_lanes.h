// The walk of a packet. Included by files that are compiled for one instruction set each.
#pragma once

#include "exact/filtered/batch/batch_lanes.h"
#include "exact/filtered/batch/polygon_lanes.h"
#include "exact/filtered/batch/term_lanes.h"
#include "tracer/accel/wide/packet_boxes.h"

namespace tribunal::HWY_NAMESPACE {

inline constexpr unsigned all_lanes = (1U << packet_size) - 1, chunk_lanes = (1U << double_lanes) - 1;

/// The state of a packet's walk: the lanes that still search, the limit on τ of each, and what they found.
struct PacketState {
  PacketState(const ProbePacket& p, const ProbeColumns& boxes, PacketAnswer& a)
      : packet(p), asking(p.lanes & boxes.held), answer(a) {}

  const ProbePacket& packet;
  alignas(64) float limit[packet_size] = {};
  unsigned asking, unsure = 0;
  PacketAnswer& answer;

  void drop(unsigned lanes) {
    unsure |= lanes;
    asking &= ~lanes;
  }
  void finish(unsigned held) { answer.known = packet.lanes & held & ~unsure; }
};

/// A node or leaf on the traversal stack; some lanes are to enter it, each at its `entry`.
struct WaitingNode {
  alignas(32) float entry[packet_size];
  std::uint32_t at;  ///< the bits of a NodeRef; an integer, so that an array of these needs no initialisation
  unsigned lanes;
};

/// The traversal stack of a packet; the node to visit next is on top.
class PacketStack {
 public:
  PacketStack() {}  // leaves the array uninitialised

  bool empty() const { return size_ == 0; }
  const WaitingNode& pop() { return nodes_[--size_]; }
  void push(const WaitingNode& n) { nodes_[size_++] = n; }

 private:
  std::size_t size_ = 0;
  WaitingNode nodes_[most_waiting];
};

/// Pushes the children that some searching lanes enter; if in_order, in the order in which the first of the lanes
/// enters them, the nearest on top. Whether a child is entered cannot be predicted, so there is no branch on it.
template <bool in_order>
HWY_INLINE void push_children(const WideNode& node, const PacketBoxes& boxes, unsigned lanes, PacketState& state,
                              PacketStack& stack) {
  WaitingNode children[node_width];
  std::uint64_t keys[node_width];
  std::size_t met = 0, k = 0;
  for (; k < node_width && !node.is_empty(k); ++k) {
    WaitingNode& child = children[met];
    child.at = node.child[k].bits();
    child.lanes = lanes & boxes.entered(node, k, state.limit, child.entry);
    const float at = child.entry[std::countr_zero(child.lanes | 1U << (packet_size - 1))];
    keys[met] = std::uint64_t{std::bit_cast<std::uint32_t>(at)} << 32 | met;
    met += child.lanes != 0;
  }
  state.answer.boxes_visited += k;
  state.answer.boxes += k * static_cast<std::uint64_t>(std::popcount(lanes));
  if (in_order) {
    for (std::size_t i = 1; i < met; ++i) {
      const std::uint64_t key = keys[i];
      std::size_t j = i;
      for (; j > 0 && keys[j - 1] < key; --j) keys[j] = keys[j - 1];
      keys[j] = key;
    }
  }
  for (std::size_t i = 0; i < met; ++i) stack.push(children[in_order ? keys[i] & 0xff : i]);
}

/// Calls leaf(ref, lanes) for each leaf that some searching lanes may meet at τ ≤ their limits; if in_order, nearer
/// ones first.
template <bool in_order, class Leaf>
HWY_INLINE void walk_together(const WideTree& tree, const ProbeColumns& probe, PacketState& state, const Leaf& leaf) {
  if (tree.empty()) return;
  const PacketBoxes boxes(probe);
  PacketStack stack;
  stack.push({{}, tree.root().bits(), state.asking});
  while (!stack.empty() && state.asking != 0) {
    const WaitingNode& next = stack.pop();
    const NodeRef at(next.at);
    const unsigned lanes = next.lanes & state.asking & PacketBoxes::within(next.entry, state.limit);
    if (lanes == 0) continue;
    if (at.is_leaf()) {
      leaf(at, lanes);
    } else {
      push_children<in_order>(tree.nodes()[at.index()], boxes, lanes, state, stack);
    }
  }
}

/// The probes of a packet against the faces of a leaf.
template <class P>
class PacketFilter {
 public:
  PacketFilter(const PacketFaces& faces, PacketState& state) : faces_(faces), state_(state) {}

  /// Calls hit(id, first lane, verdict) for certain hits, one chunk of lanes at a time; drops lanes for which the
  /// filter fails.
  template <class Hit>
  HWY_INLINE void filter(NodeRef leaf, unsigned lanes, const Hit& hit) {
    const double* const column = faces_.tree.columns(leaf);
    const std::size_t n = leaf.count();
    for (std::size_t k = 0; k < n; ++k) {
      const auto id = static_cast<std::uint32_t>(column[9 * n + k]);
      for (std::size_t c = 0; c < packet_size; c += double_lanes) {
        const unsigned asked = lanes & state_.asking & chunk_lanes << c;
        if (asked != 0) filter_face(leaf, column + k, n, id, c, asked >> c, hit);
      }
    }
  }

 private:
  static HWY_INLINE Vec3<Lanes> load(const double (&columns)[3][packet_size], std::size_t c) {
    return {Lanes::load(columns[0] + c), Lanes::load(columns[1] + c), Lanes::load(columns[2] + c)};
  }

  static HWY_INLINE Vec3<Lanes> vertex(const double* column, std::size_t n) {
    return {Lanes(column[0]), Lanes(column[n]), Lanes(column[2 * n])};
  }

  static HWY_INLINE unsigned equal(const double* ids, const Lanes& id) {
    const Lanes x = Lanes::load(ids);
    return ((x >= id) & (x <= id)).bits();
  }

  HWY_INLINE void count(unsigned decided, std::size_t c) {
    double* const tests = state_.answer.tests + c;
    hn::StoreU(hn::Add(hn::LoadU(tag, tests), hn::IfThenElseZero(mask_of(tag, decided), hn::Set(tag, 1.0))), tag,
               tests);
  }

  template <class Hit>
  HWY_INLINE void filter_face(NodeRef leaf, const double* column, std::size_t n, std::uint32_t id, std::size_t c,
                              unsigned asked, const Hit& hit) {
    const bool is_triangle = leaf.holds_triangles();
    LaneVerdict verdict = is_triangle ? of_triangle(column, n, c, asked) : of_polygon(id, c, asked);
    const Lanes this_id(static_cast<double>(id));
    const unsigned excluded =
        equal(state_.packet.excluded[0] + c, this_id) | equal(state_.packet.excluded[1] + c, this_id);
    verdict.missed |= excluded;
    verdict.hit &= asked & ~excluded;
    const unsigned decided = asked & (verdict.missed | verdict.hit);
    PacketAnswer& answer = state_.answer;
    (is_triangle ? answer.triangle_tests : answer.polygon_tests) += static_cast<unsigned>(std::popcount(decided));
    count(decided, c);
    if (decided != asked) state_.drop((asked & ~decided) << c);
    if (verdict.hit == 0) return;
    (is_triangle ? answer.triangle_hits : answer.polygon_hits) += static_cast<unsigned>(std::popcount(verdict.hit));
    hit(this_id, c, verdict);
  }

  HWY_INLINE LaneVerdict of_triangle(const double* column, std::size_t n, std::size_t c, unsigned asked) const {
    const LiftedTriangle<Lanes> t{vertex(column, n), vertex(column + 3 * n, n), vertex(column + 6 * n, n)};
    const Vec3<Lanes> source = load(state_.packet.source, c), target = load(state_.packet.target, c);
    const auto certain = conclude<P>(arms_of_lanes<P>(source, target, t), constants_);
    const Sides<Lanes>& sides = certain.volumes.sides;
    LaneVerdict verdict{certain.miss.bits(), certain.hit.bits(), sides.source,
                        -sides.toward,       certain.bound,      certain.bound};
    const unsigned unsure = asked & ~(verdict.missed | verdict.hit);
    if (HWY_UNLIKELY(unsure != 0)) {
      const auto [missed, hit] = missed_and_hit_by_terms<P>({source, target}, t);
      verdict.missed |= missed;
      verdict.hit |= hit;
    }
    if constexpr (std::is_same_v<P, Ray>) {
      const Lanes far = certain.bound * Lanes(0x1p24);
      const unsigned near = ((magnitude(verdict.num) < far) | (magnitude(verdict.den) < far)).bits();
      if (HWY_UNLIKELY((verdict.hit & asked & near) != 0)) tighten_bounds(t, source, target, verdict);
    }
    return verdict;
  }

  /// Replaces num, den and their bounds by those of the filter by terms, which stay close where the triangle is small
  /// and far away.
  HWY_INLINE void tighten_bounds(const LiftedTriangle<Lanes>& t, const Vec3<Lanes>& source,
                                 const Vec3<Lanes>& direction, LaneVerdict& verdict) const {
    const Vec3<Lanes> u = t.b - t.a, v = t.c - t.a;
    const Expansion<Lanes> height = expanded(u, v, source - t.a), gain = expanded(u, v, direction);
    const Lanes k(volume_terms_filter.k), tiny(volume_terms_filter.tiny);
    verdict.num = height.value;
    verdict.den = -gain.value;
    verdict.num_bound = k * height.terms + tiny;
    verdict.den_bound = k * gain.terms + tiny;
  }

  HWY_INLINE LaneVerdict of_polygon(std::uint32_t id, std::size_t c, unsigned asked) const {
    const PolygonFigures& figures = faces_.polygons[static_cast<std::size_t>(faces_.polygon_of[id])];
    return PolygonFilter<P>(load(state_.packet.source, c), load(state_.packet.target, c)).filter(figures, asked);
  }

  const PacketFaces& faces_;
  PacketState& state_;
  PairConstants<Lanes> constants_ = in_lanes(pair_filter<P>);
};

/// The closest hit of each lane so far: bounds of its parameter, and the face.
class ClosestLanes {
 public:
  ClosestLanes(const ProbeColumns& probe, PacketState& state) : probe_(probe), state_(state) {
    for (std::size_t k = 0; k < packet_size; ++k) {
      least_[k] = greatest_[k] = std::numeric_limits<double>::infinity();
      state.limit[k] = WideProbe::far_away;
    }
  }

  /// Takes certain hits of a face. A lane is dropped if the bounds of its new hit overlap those of its closest hit so
  /// far.
  HWY_INLINE void add(const Lanes& id, std::size_t c, const LaneVerdict& v) {
    const Lanes forward = unit_with_sign_of(v.den), n = v.num * forward, d = v.den * forward;
    const Lanes least = lowered(Lanes((n - v.num_bound) / (d + v.den_bound)));
    const Lanes greatest = raised(Lanes((n + v.num_bound) / (d - v.den_bound)));
    const LaneMask closer = greatest<Lanes::load(least_ + c), farther = least> Lanes::load(greatest_ + c);
    const unsigned bounded = (d > v.den_bound).bits();
    const unsigned ahead = v.hit & bounded & closer.bits(), apart = ahead | (bounded & farther.bits());
    if ((v.hit & ~apart) != 0) state_.drop((v.hit & ~apart) << c);
    if (ahead == 0) return;
    state_.answer.hit |= ahead << c;
    store(ahead, least, least_ + c);
    store(ahead, greatest, greatest_ + c);
    store(ahead, id, state_.answer.id + c);
    store(ahead, n / d, state_.answer.t + c);
    lower_limit(c);
  }

  /// Marks the lanes of which the bounds of t are as close as HitBounds::close_width; the computed t lies between its
  /// bounds.
  HWY_INLINE void finish() {
    for (std::size_t c = 0; c < packet_size; c += double_lanes) {
      const Lanes almost = Lanes::load(greatest_ + c) * Lanes(1 - 0x1p-21);
      state_.answer.close |= state_.answer.hit & (Lanes::load(least_ + c) > almost).bits() << c;
    }
  }

 private:
  using Halves = hn::Rebind<float, Tag>;

  /// A lower bound of an exact quotient, from its rounded value x. x is off by five roundings at most, and may have
  /// overflowed; no operand underflowed, since each is at least the bounds' `tiny`.
  static HWY_INLINE Lanes lowered(const Lanes& x) {
    return smaller(x, Lanes(std::numeric_limits<double>::max())) * Lanes(1 - 0x1p-48) + Lanes(-0x1p-1000);
  }
  static HWY_INLINE Lanes raised(const Lanes& x) { return x * Lanes(1 + 0x1p-48) + Lanes(0x1p-1000); }

  static HWY_INLINE void store(unsigned lanes, const Lanes& x, double* to) {
    hn::StoreU(hn::IfThenElse(mask_of(tag, lanes), x.v, hn::LoadU(tag, to)), tag, to);
  }

  /// Lowers the limits on τ to the greatest t that the closest hits may have, as WideProbe::limit_at does.
  HWY_INLINE void lower_limit(std::size_t c) {
    const Halves halves;
    const Lanes tau = Lanes::load(greatest_ + c) * Lanes::load(probe_.scale + c);
    const Lanes raised_tau = tau * Lanes(1 + 0x1p-20) + Lanes(0x1p-100);
    const Lanes in_range = smaller(raised_tau, Lanes(double{WideProbe::far_away}));
    hn::StoreU(hn::DemoteTo(halves, in_range.v), halves, state_.limit + c);
  }

  const ProbeColumns& probe_;
  PacketState& state_;
  alignas(64) double least_[packet_size], greatest_[packet_size];
};

[[gnu::flatten]] inline void first_hits(const PacketFaces& faces, const ProbePacket& packet, PacketAnswer& answer) {
  ProbeColumns probe;
  make_ready<Ray>(packet, faces.tree.frame(), probe);
  PacketState state(packet, probe, answer);
  ClosestLanes closest(probe, state);
  PacketFilter<Ray> filter(faces, state);
  walk_together<true>(faces.tree, probe, state, [&](NodeRef leaf, unsigned lanes) {
    filter.filter(leaf, lanes, [&](const Lanes& id, std::size_t c, const LaneVerdict& v) { closest.add(id, c, v); });
  });
  closest.finish();
  state.finish(probe.held);
}

[[gnu::flatten]] inline void any_hits(const PacketFaces& faces, const ProbePacket& packet, PacketAnswer& answer) {
  ProbeColumns probe;
  make_ready<Segment>(packet, faces.tree.frame(), probe);
  PacketState state(packet, probe, answer);
  for (std::size_t k = 0; k < packet_size; ++k) {  // WideProbe::limit_at(1)
    state.limit[k] = static_cast<float>(std::min(probe.scale[k] * (1 + 0x1p-20) + 0x1p-100, 0x1p100));
  }
  PacketFilter<Segment> filter(faces, state);
  walk_together<false>(faces.tree, probe, state, [&](NodeRef leaf, unsigned lanes) {
    filter.filter(leaf, lanes, [&](const Lanes&, std::size_t c, const LaneVerdict& v) {
      answer.hit |= v.hit << c;
      state.asking &= ~(v.hit << c);
    });
  });
  state.finish(probe.held);
}

inline constexpr PacketTarget packet_target_here() { return {first_hits, any_hits}; }

}  // namespace tribunal::HWY_NAMESPACE
