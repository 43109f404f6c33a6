// What can go wrong, or only differ, when a test is asked about a ray and a mesh; and how often it did.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tracer/leak/aim.h"

namespace tribunal::leak {

/// The outcome of a subject on a ray. docs/leak.md has the definitions for people; judge.cpp has them as code.
enum class Outcome : std::uint8_t {
  leak,        ///< it passes through the surface, and no face is reported there
  lost,        ///< a leak, and no face is reported at all
  false_hit,   ///< a face is reported that it misses, as it misses all faces around it
  double_hit,  ///< beside a face that it meets, one that it misses; or an even number of faces where just one is due
  parity,      ///< the number of reported faces puts its source on the wrong side
  closest,     ///< the face that is reported as the closest is not, and stands for none that is
  order,    ///< the same, although a closest face is reported, and for one that it meets later; or a list that should
            ///< be sorted is not
  wrong_t,  ///< t of the closest hit is further off than promised
  wrong_normal,  ///< the normal of the closest hit points to the wrong side or is further off than promised, or its
                 ///< side is the other one
  fault,         ///< it did something else than answer
  neighbour,     ///< in place of a face that it meets, a face beside it is reported, with the same facing
  twice,         ///< more than one face is reported where it passes an edge or a vertex, each of which it meets
  outline        ///< it passes, by no more than rounding, what it sees as outline, and is not reported there
};

inline constexpr std::size_t outcome_count = 13;

/// The key in JSON and in case files.
constexpr std::string_view name_of(Outcome o) {
  constexpr std::string_view names[outcome_count] = {"leak",      "lost",           "false hit", "double hit", "parity",
                                                     "closest",   "order",          "t",         "normal",     "fault",
                                                     "neighbour", "reported twice", "outline"};
  return names[static_cast<int>(o)];
}

/// Whether an outcome is an error; the others are reported beside the errors.
constexpr bool is_error(Outcome o) { return o < Outcome::neighbour; }

constexpr std::array<Outcome, outcome_count> all_outcomes = {
    Outcome::leak,      Outcome::lost,  Outcome::false_hit, Outcome::double_hit,   Outcome::parity,
    Outcome::closest,   Outcome::order, Outcome::wrong_t,   Outcome::wrong_normal, Outcome::fault,
    Outcome::neighbour, Outcome::twice, Outcome::outline};

/// A set of outcomes.
class Outcomes {
 public:
  void add(Outcome o) { bits_ |= 1u << static_cast<int>(o); }
  bool has(Outcome o) const { return (bits_ >> static_cast<int>(o) & 1u) != 0; }
  bool any_error() const { return (bits_ & ((1u << static_cast<int>(Outcome::neighbour)) - 1)) != 0; }

 private:
  std::uint32_t bits_ = 0;
};

/// Counts of rays with one aim: how many there were, and how many had each outcome.
struct AimTally {
  std::uint64_t rays = 0, parity_judged = 0;
  std::array<std::uint64_t, outcome_count> with{};

  std::uint64_t operator[](Outcome o) const { return with[static_cast<std::size_t>(o)]; }
  AimTally& operator+=(const AimTally& other) {
    rays += other.rays;
    parity_judged += other.parity_judged;
    for (std::size_t i = 0; i < outcome_count; ++i) with[i] += other.with[i];
    return *this;
  }
};

/// The counts of all rays, by aim.
struct LeakTally {
  std::array<AimTally, 1 + aim_count> by_aim{};

  AimTally& operator[](Aim a) { return by_aim[static_cast<std::size_t>(a)]; }
  const AimTally& operator[](Aim a) const { return by_aim[static_cast<std::size_t>(a)]; }
  AimTally all() const {
    AimTally sum;
    for (const AimTally& t : by_aim) sum += t;
    return sum;
  }
  LeakTally& operator+=(const LeakTally& other) {
    for (std::size_t i = 0; i < by_aim.size(); ++i) by_aim[i] += other.by_aim[i];
    return *this;
  }
};

}  // namespace tribunal::leak
