#include "tracer/leak/judge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/filtered/rounded_parameter.h"

namespace tribunal::leak {
namespace {

/// Judges what was reported of one ray. A reported face that the ray misses stands for a face at a place where none
/// is reported, if the two share a vertex and face the same way; else it is a false or a double hit.
class Trial {
 public:
  Trial(const Surface& surface, const Subject& subject, const AimedRay& aimed, const RayTruth& truth)
      : surface_(surface), subject_(subject), aimed_(aimed), truth_(truth) {
    for (const Place& p : truth.places) due_.push_back(is_due(p));
  }

  Verdict of(const Testimony& said) {
    if (said.hits) judge_hits(*said.hits);
    if (said.any) judge_any(*said.any);
    if (said.closest) judge_closest(said, *said.closest);
    if (said.inside) judge_inside(*said.inside);
    return verdict_;
  }

 private:
  bool is_passed(const Place& p) const { return leak::is_passed(surface_, truth_, p, subject_.contract.culling); }

  /// Whether the ray may, within rounding, be taken to pass beside what it meets here: the outline that it was aimed
  /// at.
  bool is_on_outline(const Place& p) const {
    return truth_.at_outline && std::ranges::all_of(truth_.at(p), [&](const Crossed& c) { return has_mark(c.face); });
  }

  bool is_edge_on_at(const Place& p) const {
    return std::ranges::all_of(truth_.at(p),
                               [&](const Crossed& c) { return is_edge_on(surface_, aimed_.ray, c.face); });
  }

  bool has_mark(std::uint32_t face) const {
    if (aimed_.aim == Aim::vertex) return surface_.has_vertex(face, aimed_.at);
    return std::ranges::all_of(surface_.edges()[aimed_.at],
                               [&](std::uint32_t v) { return surface_.has_vertex(face, v); });
  }

  bool is_due(const Place& p) const { return is_passed(p) && !is_on_outline(p); }

  /// Whether some face must be reported: where the ray passes the surface, and always for a ray from inside a closed
  /// surface, unless the test culls.
  bool some_hit_is_due() const {
    const bool leaves = truth_.inside && subject_.contract.culling == Culling::none;
    return leaves || std::ranges::find(due_, true) != due_.end();
  }

  bool is_at(const Place& p, std::uint32_t face) const {
    return std::ranges::find(truth_.at(p), face, &Crossed::face) != truth_.at(p).end();
  }

  /// Whether a reported face that the ray misses stands for one at the place: it shares a vertex with it and faces
  /// the same way.
  bool stands_for(const Place& p, std::uint32_t missed) const {
    const Facing facing = facing_of(surface_, aimed_.ray, missed);
    return std::ranges::any_of(truth_.at(p), [&](const Crossed& c) {
      return surface_.share_vertex(c.face, missed) && (facing == c.facing || facing == Facing::unsaid);
    });
  }

  bool is_beside_a_met_face(std::uint32_t face) const {
    const auto touches = [&](std::uint32_t f) { return surface_.share_vertex(f, face); };
    return std::ranges::any_of(truth_.crossed, [&](const Crossed& c) { return touches(c.face); }) ||
           std::ranges::any_of(truth_.along, touches) || std::ranges::any_of(truth_.flat, touches);
  }

  std::uint32_t a_face_at(std::size_t place) const {
    const auto crossed = truth_.at(truth_.places[place]);
    const auto inner = std::ranges::find(crossed, Contact::interior, &Crossed::contact);
    return inner != crossed.end() ? inner->face : crossed.front().face;
  }

  /// The first face that must be reported; if there is none, for a ray from inside, the first face that it meets.
  std::uint32_t a_face_due() const {
    const auto first = std::ranges::find(due_, true);
    if (first != due_.end()) return a_face_at(static_cast<std::size_t>(first - due_.begin()));
    return truth_.places.empty() ? truth_.along.front() : a_face_at(0);
  }

  void lose() {
    verdict_.add(Outcome::leak, a_face_due());
    verdict_.add(Outcome::lost, a_face_due());
  }

  // --- every hit ---------------------------------------------------------------------------------------------------

  void judge_hits(const std::vector<Reported>& hits) {
    std::vector<std::uint32_t> reported = faces_of(hits);
    if (subject_.sorted) judge_order(hits);
    if (names_a_face_twice(reported)) verdict_.add(Outcome::double_hit, reported.front());
    std::vector<std::uint32_t> missed;
    for (const std::uint32_t f : reported) {
      if (!truth_.meets(f)) missed.push_back(f);
    }
    for (std::size_t i = 0; i < truth_.places.size(); ++i) judge_place(i, reported, missed);
    for (const std::uint32_t f : missed) {
      verdict_.add(is_beside_a_met_face(f) ? Outcome::double_hit : Outcome::false_hit, f);
    }
    if (hits.empty() && some_hit_is_due()) lose();
  }

  static std::vector<std::uint32_t> faces_of(const std::vector<Reported>& hits) {
    std::vector<std::uint32_t> faces;
    for (const Reported& hit : hits) faces.push_back(hit.face);
    return faces;
  }

  /// Whether a face is named twice; removes the repetitions.
  static bool names_a_face_twice(std::vector<std::uint32_t>& faces) {
    std::ranges::sort(faces);
    const auto repeated = std::ranges::unique(faces);
    const bool any = !repeated.empty();
    faces.erase(repeated.begin(), repeated.end());
    return any;
  }

  void judge_place(std::size_t i, const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& missed) {
    const Place& p = truth_.places[i];
    const auto reported = std::ranges::count_if(faces, [&](std::uint32_t f) { return is_at(p, f); });
    if (reported > 1) judge_many(i, static_cast<std::size_t>(reported));
    if (reported > 0 || !is_passed(p)) return;
    const auto other = std::ranges::find_if(missed, [&](std::uint32_t f) { return stands_for(p, f); });
    if (other != missed.end()) {
      verdict_.add(Outcome::neighbour, a_face_at(i));
      missed.erase(other);
    } else if (due_[i] && !is_edge_on_at(p)) {
      verdict_.add(Outcome::leak, a_face_at(i));
    } else {
      verdict_.add(Outcome::outline, a_face_at(i));
    }
  }

  /// A closed test rightly reports all faces that share an edge or a vertex. One that gives it to exactly one of them,
  /// or to none, reports an odd number where the ray passes, and an even one where it only touches.
  void judge_many(std::size_t i, std::size_t reported) {
    verdict_.add(Outcome::twice, a_face_at(i));
    const Boundary boundary = subject_.contract.boundary;
    const bool to_one = boundary == Boundary::half_open || boundary == Boundary::open;
    if (to_one && due_[i] && reported % 2 == 0) verdict_.add(Outcome::double_hit, a_face_at(i));
  }

  /// Of the hits at places, none comes after one of a later place.
  void judge_order(const std::vector<Reported>& hits) {
    std::size_t latest = 0;
    for (const Reported& hit : hits) {
      const std::size_t place = place_of(hit.face);
      if (place == truth_.places.size()) continue;
      if (place < latest) verdict_.add(Outcome::order, hit.face);
      latest = std::max(latest, place);
    }
  }

  std::size_t place_of(std::uint32_t face) const {
    const auto found = std::ranges::find_if(truth_.places, [&](const Place& p) { return is_at(p, face); });
    return static_cast<std::size_t>(found - truth_.places.begin());
  }

  // --- any, closest, inside ----------------------------------------------------------------------------------------

  void judge_any(bool any) {
    if (!any && some_hit_is_due()) lose();
    if (any && truth_.touches_nothing()) verdict_.add(Outcome::false_hit, aimed_.aim == Aim::face ? aimed_.at : 0);
  }

  static bool reports(const Testimony& said, const RayTruth& truth, const Place& p) {
    return said.hits && std::ranges::any_of(*said.hits, [&](const Reported& hit) {
             return std::ranges::find(truth.at(p), hit.face, &Crossed::face) != truth.at(p).end();
           });
  }

  /// The first place of which the test must, or does, report a face.
  std::optional<std::size_t> first_place(const Testimony& said, const std::optional<Reported>& closest) const {
    for (std::size_t i = 0; i < truth_.places.size(); ++i) {
      const Place& p = truth_.places[i];
      if (due_[i] || reports(said, truth_, p) || (closest && is_at(p, closest->face))) return i;
    }
    return std::nullopt;
  }

  void judge_closest(const Testimony& said, const std::optional<Reported>& closest) {
    const bool alone = !said.hits;  // else leaks and false hits were counted above
    if (!closest) {
      if (alone && some_hit_is_due()) lose();
      return;
    }
    const bool met = truth_.meets(closest->face);
    if (met && !truth_.crosses(closest->face)) return;  // it holds the ray in its plane: there is no one t
    if (alone && !met && !is_beside_a_met_face(closest->face)) verdict_.add(Outcome::false_hit, closest->face);
    const auto first = first_place(said, closest);
    if (!first) return;
    const Place& p = truth_.places[*first];
    if (is_at(p, closest->face)) return judge_t(*closest);
    if (!met && stands_for(p, closest->face) && !reports(said, truth_, p)) {
      if (alone) verdict_.add(Outcome::neighbour, a_face_at(*first));
      return;
    }
    verdict_.add(Outcome::closest, a_face_at(*first));
    if (met && reports(said, truth_, p)) verdict_.add(Outcome::order, a_face_at(*first));
  }

  void judge_t(const Reported& closest) {
    if (!closest.t) return;
    const double exact = rounded_parameter(aimed_.ray, surface_.triangle(closest.face));
    const double gap = std::nextafter(std::abs(exact), INFINITY) - std::abs(exact);
    verdict_.ulps = std::abs(*closest.t - exact) / gap;
    if (std::isnan(verdict_.ulps)) verdict_.ulps = INFINITY;
    if (subject_.most_ulps > 0 && verdict_.ulps > subject_.most_ulps) verdict_.add(Outcome::wrong_t, closest.face);
  }

  /// Where the ray only touches, the different t of a test that reports both faces of an edge are one: such a test is
  /// judged where the ray passes the surface at each place that it meets.
  void judge_inside(bool inside) {
    if (!surface_.topology().closed() || subject_.contract.culling != Culling::none) return;
    const bool all_passed = truth_.along.empty() && std::ranges::all_of(truth_.places, [&](const Place& p) {
                              return is_passed(p) && !is_on_outline(p);
                            });
    if (!subject_.parity_where_touching && !all_passed) return;
    verdict_.parity_judged = true;
    if (inside == truth_.inside) return;
    verdict_.add(Outcome::parity, truth_.crossed.empty() ? 0 : truth_.crossed.front().face);
  }

  const Surface& surface_;
  const Subject& subject_;
  const AimedRay& aimed_;
  const RayTruth& truth_;
  std::vector<bool> due_{};
  Verdict verdict_{};
};

}  // namespace

Verdict judge(const Surface& surface, const Subject& subject, const AimedRay& aimed, const RayTruth& truth,
              const Testimony& said) {
  return Trial(surface, subject, aimed, truth).of(said);
}

}  // namespace tribunal::leak
