#include "tracer/leak/judge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/filtered/rounded_parameter.h"
#include "tracer/leak/normal.h"

namespace tribunal::leak {
namespace {

/// Places of which one report is enough: those of a passage, or of an exact test one place alone, since nothing excuses
/// it. `passage` is null then.
struct Wall {
  std::vector<std::size_t> places{};
  const Passage* passage = nullptr;
  bool due = false;     ///< a face must be reported
  bool passed = false;  ///< the ray passes through the surface at one of the places, if only by less than rounding
};

/// Judges what was reported of one ray. A reported face that the ray misses stands for one at a place where none is
/// reported, if it belongs to its passage, or shares a vertex with it and faces the same way; else it is a false or a
/// double hit.
class Trial {
 public:
  Trial(const Surface& surface, const Subject& subject, const AimedRay& aimed, const RayTruth& truth)
      : surface_(surface), subject_(subject), aimed_(aimed), truth_(truth) {
    if (is_exact()) {
      for (std::size_t i = 0; i < truth.places.size(); ++i) {
        const bool passed = is_passed(truth.places[i]);
        walls_.push_back({{i}, nullptr, passed, passed});
      }
      return;
    }
    for (const Passage& p : truth.passages) {
      const bool passed = std::ranges::any_of(p.places, [&](std::size_t i) { return is_passed(truth.places[i]); });
      walls_.push_back({p.places, &p, leak::is_passed(surface, truth, p, culling()), passed});
    }
  }

  Verdict of(const Testimony& said) {
    if (said.fault) {
      verdict_.add(Outcome::fault, truth_.crossed.empty() ? 0 : truth_.crossed.front().face);
      verdict_.fault = describe(said.fault);
      return verdict_;
    }
    if (said.hits) judge_hits(*said.hits);
    if (said.any) judge_any(*said.any);
    if (said.closest) judge_closest(said, *said.closest);
    if (said.inside) judge_inside(*said.inside);
    return verdict_;
  }

 private:
  bool is_exact() const { return subject_.contract.exact; }
  Culling culling() const { return subject_.contract.culling; }
  bool is_passed(const Place& p) const { return leak::is_passed(surface_, truth_, p, culling()); }
  const Wall& wall_of(std::size_t place) const { return walls_[is_exact() ? place : truth_.places[place].passage]; }

  /// Whether a rounded test may take the source to be on the other side of the surface.
  bool source_is_unsure() const { return truth_.starts_near && !is_exact(); }

  /// Whether some face must be reported: where the ray passes the surface, and always for a ray from inside a closed
  /// surface, unless the test culls.
  bool some_hit_is_due() const {
    const bool leaves = truth_.inside && culling() == Culling::none && !source_is_unsure();
    return leaves || std::ranges::any_of(walls_, &Wall::due);
  }

  bool is_at(const Place& p, std::uint32_t face) const {
    return std::ranges::find(truth_.at(p), face, &Crossed::face) != truth_.at(p).end();
  }

  /// Whether a reported face that the ray misses stands for one at the place.
  bool stands_for(const Place& p, std::uint32_t missed) const {
    if (!is_exact() && truth_.passages[p.passage].has(missed)) return true;
    const Facing facing = facing_of(surface_, aimed_.ray, missed);
    return std::ranges::any_of(truth_.at(p), [&](const Crossed& c) {
      return surface_.share_vertex(c.face, missed) && (facing == c.facing || facing == Facing::unsaid);
    });
  }

  bool stands_for(const Wall& w, std::uint32_t missed) const {
    return std::ranges::any_of(w.places, [&](std::size_t i) { return stands_for(truth_.places[i], missed); });
  }

  /// Whether a reported face that the ray meets belongs to the wall.
  bool is_in(const Wall& w, std::uint32_t face) const {
    return std::ranges::any_of(w.places, [&](std::size_t i) { return is_at(truth_.places[i], face); }) ||
           (w.passage != nullptr && w.passage->has(face) && truth_.meets(face));
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

  std::uint32_t a_face_of(const Wall& w) const {
    const auto passed = std::ranges::find_if(w.places, [&](std::size_t i) { return is_passed(truth_.places[i]); });
    return a_face_at(passed != w.places.end() ? *passed : w.places.front());
  }

  /// The first face that must be reported; if there is none, for a ray from inside, the first face that it meets.
  std::uint32_t a_face_due() const {
    const auto first = std::ranges::find(walls_, true, &Wall::due);
    if (first != walls_.end()) return a_face_of(*first);
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
    for (std::size_t i = 0; i < truth_.places.size(); ++i) judge_place(i, reported);
    for (const Wall& w : walls_) judge_wall(w, reported, missed);
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
    const auto repeated = std::unique(faces.begin(), faces.end());
    const bool any = repeated != faces.end();
    faces.erase(repeated, faces.end());
    return any;
  }

  void judge_place(std::size_t i, const std::vector<std::uint32_t>& faces) {
    const Place& p = truth_.places[i];
    const auto reported = std::ranges::count_if(faces, [&](std::uint32_t f) { return is_at(p, f); });
    if (reported > 1) judge_many(i, static_cast<std::size_t>(reported));
  }

  void judge_wall(const Wall& w, const std::vector<std::uint32_t>& faces, std::vector<std::uint32_t>& missed) {
    bool told = std::ranges::any_of(faces, [&](std::uint32_t f) { return is_in(w, f); });
    for (const std::size_t i : w.places) {
      const Place& p = truth_.places[i];
      const bool reported = std::ranges::any_of(faces, [&](std::uint32_t f) { return is_at(p, f); });
      if (reported || !(w.due || is_passed(p))) continue;
      const auto other = std::ranges::find_if(missed, [&](std::uint32_t f) { return stands_for(p, f); });
      if (other == missed.end()) continue;
      verdict_.add(Outcome::neighbour, a_face_at(i));
      missed.erase(other);
      told = true;
    }
    if (!told && (w.due || w.passed)) verdict_.add(w.due ? Outcome::leak : Outcome::outline, a_face_of(w));
  }

  /// A closed test rightly reports all faces that share an edge or a vertex. One that gives it to exactly one of them,
  /// or to none, reports an odd number where the ray passes, and an even one where it only touches.
  void judge_many(std::size_t i, std::size_t reported) {
    verdict_.add(Outcome::twice, a_face_at(i));
    const Boundary boundary = subject_.contract.boundary;
    const bool to_one = boundary == Boundary::half_open || boundary == Boundary::open;
    if (to_one && wall_of(i).due && is_passed(truth_.places[i]) && reported % 2 == 0)
      verdict_.add(Outcome::double_hit, a_face_at(i));
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
    if (any && truth_.touches_nothing()) verdict_.add(Outcome::false_hit, aimed_.aim == Aim::face ? aimed_.at : 0u);
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
      if (wall_of(i).due || reports(said, truth_, p) || (closest && is_at(p, closest->face))) return i;
    }
    return std::nullopt;
  }

  /// Whether the face is of the first place, or of another of its wall and the test reports none before that.
  bool is_first(const Testimony& said, std::size_t first, std::uint32_t face) const {
    for (const std::size_t i : wall_of(first).places) {
      if (is_at(truth_.places[i], face)) return true;
      if (reports(said, truth_, truth_.places[i])) return false;
    }
    return false;
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
    if (is_first(said, *first, closest->face)) return judge_t(*closest), judge_normal(*closest);
    if (!met && stands_for(wall_of(*first), closest->face) && !reports(said, truth_, p)) {
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

  void judge_normal(const Reported& closest) {
    const Facing facing = facing_of(surface_, aimed_.ray, closest.face);
    if (closest.side && *closest.side != facing) verdict_.add(Outcome::wrong_normal, closest.face);
    if (!closest.normal) return;
    const bool against = subject_.sense == NormalSense::towards_source && facing == Facing::back;
    const Point3 given = against ? -*closest.normal : *closest.normal;
    const std::optional<double> degrees = degrees_from_normal(surface_.triangle(closest.face), given);
    if (degrees) verdict_.degrees = *degrees;
    if (!degrees || (subject_.most_degrees > 0 && *degrees > subject_.most_degrees)) {
      verdict_.add(Outcome::wrong_normal, closest.face);
    }
  }

  /// Where the ray only touches, and where it passes by the outline within rounding, the different t of a test that
  /// reports both faces of an edge are one: such a test is judged where the ray passes the surface at each place that
  /// it meets.
  void judge_inside(bool inside) {
    if (!surface_.topology().closed() || culling() != Culling::none || source_is_unsure()) return;
    const bool all_passed = truth_.along.empty() && std::ranges::all_of(walls_, [&](const Wall& w) {
                              return w.due && w.places.size() == 1 && is_passed(truth_.places[w.places.front()]);
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
  std::vector<Wall> walls_{};
  Verdict verdict_{};
};

}  // namespace

Verdict judge(const Surface& surface, const Subject& subject, const AimedRay& aimed, const RayTruth& truth,
              const Testimony& said) {
  return Trial(surface, subject, aimed, truth).of(said);
}

}  // namespace tribunal::leak
