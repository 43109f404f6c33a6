// A method: one intersection test under trial, with what it promises.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/answer.h"
#include "core/contract.h"
#include "core/native.h"
#include "core/polygon.h"
#include "core/query.h"
#include "core/sign.h"

namespace tribunal {

/// A method's answers about one polygon, which it may have prepared. Views the polygon, which must outlive it.
struct PreparedPolygon {
  std::function<Answer(const Segment&)> segment;
  std::function<Answer(const Ray&)> ray;
};

/// A method's answers about one triangle, which it has prepared.
struct PreparedTriangle {
  std::function<Answer(const Segment&)> segment{};
  std::function<Answer(const Ray&)> ray{};
};

/// A method's answers about one ray, which it has prepared.
using PreparedRay = std::function<Answer(const Triangle&)>;

/// The weights of the vertices b and c in a point of a triangle a b c; the weight of a is 1 − b − c.
struct BarycentricWeights {
  double b = 0, c = 0;
};

/// Where a ray o + t·d hits a triangle, as a method computes it; without weights if it computes none.
struct HitAt {
  double t = 0;
  std::optional<BarycentricWeights> weights{};
};

/// What people want to know of a method. Code reads the contract.
struct Card {
  std::string number{};     ///< number type, e.g. "binary64", "GMP dyadic"
  std::string summary{};    ///< one line
  std::string reference{};  ///< where it was published
};

/// An intersection test on trial. The commands know of a method what stands here and nothing else. What it can do
/// besides answering is said by which of the functions below it has (core/capability.h).
struct Method {
  std::string name{};  ///< e.g. "sf-double"
  Card card{};
  Contract contract{};
  std::vector<Stage> stages{};  ///< the stages that can decide its answers; empty if it has none
  bool tells_contact = false;   ///< its answers say which part of the target is met
  bool tells_side = false;      ///< its answers say from which side a triangle is crossed
  bool on_tree_lanes =
      false;  ///< its filter is the one that the tree's vector lanes compute; goes with `segment`, `ray`

  std::function<Answer(const Segment&, const Triangle&)> segment{};
  std::function<Answer(const Ray&, const Triangle&)> ray{};
  /// Whether the part of the ray within the bounds meets the triangle; empty if the method takes no bounds. The contact
  /// is that of the ray where it crosses the triangle's plane, also where the part is a point.
  std::function<Answer(const Ray&, const Bounds&, const Triangle&)> within{};
  /// The answer of `segment` or `ray` with the class added, for methods that work from signs; else empty.
  std::function<Answer(const Probe&, const Triangle&)> classify{};
  /// Sign of t₁ − t₂ for two triangles that the ray crosses; empty if the method does not order hits.
  std::function<Sign(const Ray&, const Triangle&, const Triangle&)> compare_hits{};
  /// The parameter t of the point o + t·d where the ray hits the triangle, as the method computes it: nothing where it
  /// reports no hit, or a hit of many points. Empty if the method yields none.
  std::function<std::optional<double>(const Ray&, const Triangle&)> parameter{};
  /// The parameter t with the weights of the vertices; nothing where the method reports no hit. These numbers need not
  /// be finite. Empty if the method yields none.
  std::function<std::optional<HitAt>(const Ray&, const Triangle&)> hit{};
  /// The same test on exact numbers: what it answers to a query if no operation rounds. A wrong answer that the twin
  /// gives too is a fault of logic; one that it does not give is rounding. Empty if the method is exact, or has none.
  std::function<Answer(const Query&)> exact_twin{};

  /// Answers about many pairs at once, one each, as `ask` would give them; empty if the method has no batch form.
  /// The operands are finite.
  std::function<void(std::span<const TrianglePair>, std::span<Answer>)> batch{};
  /// Answers each pair as `ask` would, one after the other, all in one call: for methods of which a call itself is
  /// costly. Empty for all others.
  std::function<void(std::span<const TrianglePair>, std::span<Answer>)> ask_each{};

  /// More about the fault in the last answer that the calling thread was given, e.g. "SIGSEGV"; empty if the method
  /// has no faults, or ends the command at the first.
  std::function<std::string()> last_fault{};

  /// Its test of polygons with at least one vertex and finite coordinates; empty if it takes none.
  std::function<PreparedPolygon(const Polygon&)> polygon{};
  /// Prepares a triangle, or a ray, for many queries, which are then answered as `segment` and `ray` would; empty if
  /// the method prepares none. The operands are finite.
  std::function<PreparedTriangle(const Triangle&)> prepare_triangle{};
  std::function<PreparedRay(const Ray&)> prepare_ray{};

  /// Its tests of segments and triangles for a clock; without them it is timed through `segment`.
  NativeLoops native{};

  /// The answer to a query. A non-finite operand never reaches the test.
  Answer ask(const Query& query) const {
    if (!is_finite(query)) return refusal(Status::nonfinite);
    if (query.bounds) return ask_within(query);
    const auto about = [&](const auto& probe, const auto& target) { return ask(probe, target); };
    return std::visit(about, query.probe, query.target);
  }

 private:
  Answer ask_within(const Query& query) const {
    const Ray* r = std::get_if<Ray>(&query.probe);
    const Triangle* t = std::get_if<Triangle>(&query.target);
    return within && r != nullptr && t != nullptr ? within(*r, *query.bounds, *t) : unsupported();
  }

  Answer ask(const Segment& s, const Triangle& t) const { return segment(s, t); }
  Answer ask(const Ray& r, const Triangle& t) const { return ray(r, t); }
  Answer ask(const Segment& s, const Polygon& p) const { return takes(p) ? polygon(p).segment(s) : unsupported(); }
  Answer ask(const Ray& r, const Polygon& p) const { return takes(p) ? polygon(p).ray(r) : unsupported(); }

  bool takes(const Polygon& p) const { return polygon && !p.vertices.empty(); }
  static Answer unsupported() { return refusal(Status::unsupported); }
};

}  // namespace tribunal
