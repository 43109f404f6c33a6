// What a method may do that is no answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "exact/io/failure.h"

namespace tribunal {

enum class FaultKind : std::uint8_t { none, answers_differ, threw, crashed, timed_out };

inline constexpr FaultKind fault_kinds[] = {FaultKind::none, FaultKind::answers_differ, FaultKind::threw,
                                            FaultKind::crashed, FaultKind::timed_out};

constexpr std::string_view name_of(FaultKind kind) {
  constexpr std::string_view names[] = {"", "answers differently when asked twice", "threw", "crashed", "timed out"};
  return names[static_cast<int>(kind)];
}

/// What a method did on a query in place of being a function of it, if anything.
struct Fault {
  FaultKind kind = FaultKind::none;
  std::string detail{};  ///< which exception, signal or limit; may be empty

  explicit operator bool() const { return kind != FaultKind::none; }
};

/// "threw std::runtime_error: no memory", for people.
inline std::string describe(const Fault& fault) {
  return std::string(name_of(fault.kind)) + (fault.detail.empty() ? "" : " (" + fault.detail + ")");
}

/// Thrown by a method that could not answer. Where nothing catches it, it ends the command with one line that has the
/// case.
class MethodFault : public Failure {
 public:
  /// `at`: of a batch, the first query without an answer, which is the one that did it; those before it are answered.
  MethodFault(Fault fault, const std::string& line, std::optional<std::size_t> at = std::nullopt)
      : Failure(Exit::disagreement, line), fault_(std::move(fault)), at_(at) {}

  const Fault& fault() const { return fault_; }
  std::optional<std::size_t> at() const { return at_; }

 private:
  Fault fault_;
  std::optional<std::size_t> at_;
};

}  // namespace tribunal
