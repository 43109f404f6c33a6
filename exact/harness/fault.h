// What a method may do that is no answer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "exact/io/failure.h"

namespace tribunal {

enum class FaultKind : std::uint8_t { none, answers_differ, threw };

constexpr std::string_view name_of(FaultKind kind) {
  constexpr std::string_view names[] = {"", "answers differently when asked twice", "threw"};
  return names[static_cast<int>(kind)];
}

/// What a method did on a query in place of being a function of it, if anything.
struct Fault {
  FaultKind kind = FaultKind::none;
  std::string detail{};  ///< which exception; may be empty

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
  MethodFault(Fault fault, const std::string& line) : Failure(Exit::disagreement, line), fault_(std::move(fault)) {}

  const Fault& fault() const { return fault_; }

 private:
  Fault fault_;
};

}  // namespace tribunal
