// A method: one intersection test under trial, with what it promises.
#pragma once

#include <concepts>
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
  std::function<PolygonAnswer(const Segment&)> segment;
  std::function<PolygonAnswer(const Ray&)> ray;
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

  /// Answers to many queries at once, one each, as `ask` would give them; empty if the method has no batch form.
  /// The operands are finite.
  std::function<void(std::span<const Query>, std::span<Answer>)> batch{};
  /// `ask`, of one query after the other, where a call has a price of its own; empty if nothing is gained.
  std::function<void(std::span<const Query>, std::span<Answer>)> ask_each{};

  /// More about the fault in the last answer that the calling thread was given, e.g. "SIGSEGV"; empty if the method
  /// has no faults, or ends the command at the first.
  std::function<std::string()> last_fault{};

  /// Its test of polygons with at least one vertex and finite coordinates; empty if it takes none.
  std::function<PreparedPolygon(const Polygon&)> polygon{};
  PolygonPromise polygon_promise{};

  /// The answer to a query. A non-finite operand never reaches the test.
  Answer ask(const Query& query) const {
    if (!is_finite(query.triangle)) return refusal(Status::nonfinite);
    return std::visit([&](const auto& probe) { return ask(probe, query.triangle); }, query.probe);
  }

  /// The same about a polygon. A template only so that `ask({probe, triangle})` stays unambiguous.
  template <std::same_as<PolygonQuery> Q>
  PolygonAnswer ask(const Q& query) const {
    const bool finite = std::visit([](const auto& probe) { return is_finite(probe); }, query.probe);
    if (!finite || !is_finite(query.polygon)) return {.answer = refusal(Status::nonfinite)};
    if (!polygon || query.polygon.vertices.empty()) return {.answer = refusal(Status::unsupported)};
    const PreparedPolygon prepared = polygon(query.polygon);
    if (const auto* s = std::get_if<Segment>(&query.probe)) return prepared.segment(*s);
    return prepared.ray(std::get<Ray>(query.probe));
  }

 private:
  Answer ask(const Segment& s, const Triangle& t) const {
    return is_finite(s) ? segment(s, t) : refusal(Status::nonfinite);
  }
  Answer ask(const Ray& r, const Triangle& t) const { return is_finite(r) ? ray(r, t) : refusal(Status::nonfinite); }
};

}  // namespace tribunal
