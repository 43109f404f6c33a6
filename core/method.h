// A method: one intersection test under trial, with what it promises.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/answer.h"
#include "core/format.h"
#include "core/polygon.h"
#include "core/query.h"
#include "core/sign.h"

namespace tribunal {

/// A method's answers about one polygon, which it may have prepared. Views the polygon, which must outlive it.
struct PreparedPolygon {
  std::function<Answer(const Segment&)> segment;
  std::function<Answer(const Ray&)> ray;
};

/// What a method promises of polygons, beside its convention.
struct PolygonPromise {
  bool boundary = true;  ///< false: it may answer either way where a probe meets a ring edge
  bool surface = true;   ///< false: it promises nothing of polygons that are not planar
};

/// Fuzz, certify, render and chart take methods by name and know nothing else about them.
struct Method {
  std::string name;             ///< e.g. "sf-double"
  std::string number;           ///< number type, e.g. "binary64", "GMP dyadic"
  std::string contract;         ///< which operands it takes
  std::string summary;          ///< one line for people
  std::string reference;        ///< where it was published
  Convention convention;        ///< what it promises of coplanar contacts
  Format format;                ///< coordinates beyond this format are rounded on entry
  bool exact = false;           ///< promises the right answer to every query in its contract
  std::vector<Stage> stages{};  ///< the stages that its answers can come from; empty if it has none

  std::function<Answer(const Segment&, const Triangle&)> segment;
  std::function<Answer(const Ray&, const Triangle&)> ray;
  /// `segment` or `ray` with the class added, for methods that work from signs; else empty.
  std::function<Answer(const Probe&, const Triangle&)> classify;
  /// Sign of t₁ − t₂ for two triangles that the ray crosses; empty if the method has no opinion.
  std::function<Sign(const Ray&, const Triangle&, const Triangle&)> compare_hits;

  /// Answers about many pairs at once, one each, as `ask` would give them; empty if the method has no batch form.
  /// The operands are finite.
  std::function<void(std::span<const TrianglePair>, std::span<Answer>)> batch{};

  /// Its test of polygons with at least one vertex and finite coordinates; empty if it takes none.
  std::function<PreparedPolygon(const Polygon&)> polygon{};
  PolygonPromise polygon_promise{};

  /// The answer to a query. A non-finite operand never reaches the test.
  Answer ask(const Query& query) const {
    if (!is_finite(query)) return refusal(Status::nonfinite);
    const auto about = [&](const auto& probe, const auto& target) { return ask(probe, target); };
    return std::visit(about, query.probe, query.target);
  }

 private:
  Answer ask(const Segment& s, const Triangle& t) const { return segment(s, t); }
  Answer ask(const Ray& r, const Triangle& t) const { return ray(r, t); }
  Answer ask(const Segment& s, const Polygon& p) const { return takes(p) ? polygon(p).segment(s) : unsupported(); }
  Answer ask(const Ray& r, const Polygon& p) const { return takes(p) ? polygon(p).ray(r) : unsupported(); }

  bool takes(const Polygon& p) const { return polygon && !p.vertices.empty(); }
  static Answer unsupported() { return refusal(Status::unsupported); }
};

}  // namespace tribunal
