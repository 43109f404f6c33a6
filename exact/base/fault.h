// What a method may do instead of answering.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/answer.h"
#include "exact/base/failure.h"

namespace tribunal {

/// The fault of a method on one query, if there was one.
struct Fault {
  Status kind = Status::ok;  ///< `ok`, or a fault
  std::string detail{};      ///< which exception, which signal, after how long; may be empty

  explicit operator bool() const { return is_fault(kind); }
};

/// "threw no memory", "crashed (SIGSEGV)", "timed out after 5 s", for people.
inline std::string describe(const Fault& fault) {
  const std::string name(fault_name(fault.kind));
  if (fault.detail.empty()) return name;
  const bool one_phrase = fault.kind == Status::threw || fault.kind == Status::timed_out;
  return name + (one_phrase ? " " + fault.detail : " (" + fault.detail + ")");
}

/// The fault of this name, or `ok`.
constexpr Status fault_named(std::string_view name) {
  for (Status s = Status::threw; s <= Status::differs_when_repeated; s = static_cast<Status>(static_cast<int>(s) + 1)) {
    if (fault_name(s) == name) return s;
  }
  return Status::ok;
}

/// Thrown by a method that could not answer. Where nothing catches it, it ends the command with one line that contains
/// the case.
class MethodFault : public Failure {
 public:
  MethodFault(Fault fault, const std::string& line) : Failure(Exit::disagreement, line), fault_(std::move(fault)) {}

  const Fault& fault() const { return fault_; }

 private:
  Fault fault_;
};

}  // namespace tribunal
