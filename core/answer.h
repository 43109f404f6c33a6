// The vocabulary of answers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

namespace tribunal {

/// Where the probe meets the triangle. `coplanar`: they lie in one plane and meet there. A degenerate
/// triangle that is met, and a point that lies in the triangle's plane, are always coplanar contacts; of a polygon,
/// those of a planar one with a probe in its plane. `unsaid`: a hit by a method that does not say where.
enum class Contact : std::uint8_t { none, interior, edge, vertex, coplanar, unsaid };

/// Which part of the probe is in contact, where exactly one point is. `unsaid` otherwise.
enum class At : std::uint8_t { unsaid, source, target, between };

/// From which side a probe crosses a triangle. `front`: the vertices run counterclockwise as seen from the source.
/// `unsaid` where it does not cross: there is no contact, it is coplanar, or the target is a polygon; and where a
/// method does not say.
enum class Facing : std::uint8_t { unsaid, front, back };

/// `nonfinite`: an operand has a NaN or an infinity. `unsupported`: outside the method's contract. All after these
/// are faults: the method did something else than answer, or its answers to one query differ.
enum class Status : std::uint8_t {
  ok,
  nonfinite,
  unsupported,
  threw,
  crashed,
  exited,
  timed_out,
  changed_environment,
  gave_no_answer,
  differs_in_batch,
  differs_when_repeated,
};

constexpr bool is_fault(Status s) { return s >= Status::threw; }

/// Which stage of a staged kernel decided: a filter, integers of a fixed width, or exact numbers of any width. `none`
/// for kernels without stages.
enum class Stage : std::uint8_t { none, filter, integers, exact };

/// The stages that decide, each asked where the one before is not certain.
inline constexpr Stage deciding_stages[] = {Stage::filter, Stage::integers, Stage::exact};
inline constexpr std::size_t stage_count = 1 + std::size(deciding_stages);

/// One of the 163 classes of a segment and a triangle, 1..163, or of the 165 of a ray and a triangle, from 164 on;
/// 0 where none was computed.
using ClassId = std::uint16_t;

struct Answer {
  bool hit = false;
  Contact contact = Contact::none;
  At at = At::unsaid;
  Status status = Status::ok;
  Stage stage = Stage::none;
  bool planar = true;  ///< the polygon's vertices lie in one plane; true of every triangle
  Facing facing = Facing::unsaid;
  ClassId class_id = 0;

  friend bool operator==(const Answer&, const Answer&) = default;
};

constexpr Answer miss() { return {}; }

constexpr Answer hit_at(Contact contact, At at = At::unsaid) { return {.hit = true, .contact = contact, .at = at}; }

constexpr Answer refusal(Status why) { return {.status = why}; }

/// What a method promises about coplanar contacts. `closed`: hit iff the point sets meet. `transversal`: a probe
/// in the triangle's plane is a miss, as in the paper's figure 1. `unspecified`: it promises nothing.
enum class Convention : std::uint8_t { closed, transversal, unspecified };

constexpr std::string_view name_of(Contact c) {
  constexpr std::string_view names[] = {"none", "interior", "edge", "vertex", "coplanar", ""};
  return names[static_cast<int>(c)];
}

constexpr std::string_view name_of(At a) {
  constexpr std::string_view names[] = {"", "source", "target", "between"};
  return names[static_cast<int>(a)];
}

constexpr std::string_view name_of(Facing f) {
  constexpr std::string_view names[] = {"", "front", "back"};
  return names[static_cast<int>(f)];
}

/// The word for a status in files; every fault is "failed".
constexpr std::string_view name_of(Status s) {
  constexpr std::string_view names[] = {"ok", "nonfinite", "unsupported", "failed"};
  return names[is_fault(s) ? 3 : static_cast<int>(s)];
}

/// What a method did, where the status is a fault; else empty.
constexpr std::string_view fault_name(Status s) {
  constexpr std::string_view names[] = {"threw",
                                        "crashed",
                                        "exited",
                                        "timed out",
                                        "changed the floating-point environment",
                                        "gave no answer",
                                        "answers otherwise in a batch than alone",
                                        "answers differently when asked twice"};
  return is_fault(s) ? names[static_cast<int>(s) - static_cast<int>(Status::threw)] : std::string_view();
}

constexpr std::string_view name_of(Stage s) {
  constexpr std::string_view names[stage_count] = {"", "filter", "integers", "exact"};
  return names[static_cast<int>(s)];
}

/// The stage of this name; `expansion` is what older files call `integers`.
constexpr std::optional<Stage> stage_named(std::string_view name) {
  if (name == "expansion") return Stage::integers;
  for (const Stage s : deciding_stages) {
    if (name == name_of(s)) return s;
  }
  return std::nullopt;
}

constexpr std::string_view name_of(Convention c) {
  constexpr std::string_view names[] = {"closed", "transversal", "unspecified"};
  return names[static_cast<int>(c)];
}

}  // namespace tribunal
