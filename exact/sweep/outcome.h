// What a sweep counts failures of.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "exact/trial/outcome.h"

namespace tribunal {

/// The outcomes of an answer to one case that are no right answers; and of a ray at a closed mesh: `leak`, where it
/// passes through the surface and no face is reported; `double_hit`, where one is reported beside the one that it
/// meets; `parity`, where the number of reported faces puts the source on the wrong side. docs/leak.md has the
/// definitions.
enum class SweptOutcome : std::uint8_t {
  false_hit,
  false_miss,
  wrong_contact,
  fault,
  refused,
  leak,
  double_hit,
  parity
};

inline constexpr std::array swept_outcomes = {
    SweptOutcome::false_hit, SweptOutcome::false_miss, SweptOutcome::wrong_contact, SweptOutcome::fault,
    SweptOutcome::refused,   SweptOutcome::leak,       SweptOutcome::double_hit,    SweptOutcome::parity};

/// Those of rays at a mesh. Of these, false hits and faults can be of one case too.
inline constexpr std::array mesh_outcomes = {SweptOutcome::false_hit, SweptOutcome::fault, SweptOutcome::leak,
                                             SweptOutcome::double_hit, SweptOutcome::parity};

constexpr std::string_view name_of(SweptOutcome o) {
  constexpr std::string_view names[] = {"false hit", "false miss", "wrong contact", "fault",
                                        "refused",   "leak",       "double hit",    "parity"};
  return names[static_cast<int>(o)];
}

/// Of a wrong answer or a refusal to one case.
constexpr SweptOutcome swept(Outcome o) {
  if (o == Outcome::refused) return SweptOutcome::refused;
  return static_cast<SweptOutcome>(static_cast<int>(o) - static_cast<int>(Outcome::false_hit));
}

}  // namespace tribunal
