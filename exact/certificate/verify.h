// Makes a certificate again from its log and holds it against what stands beside it.
#pragma once

#include <string>
#include <vector>

#include "exact/certificate/certificate.h"

namespace tribunal {

struct Verification {
  Certificate certificate;
  std::vector<std::string> faults{};  ///< one line each; none: verified
  std::size_t confirmed = 0;          ///< counterexamples whose exact answer and evidence were found again
  bool asked_again = false;           ///< the method is known here, and gave the same answers on the smallest set
};

/// The chain of hashes is checked first (Exit::bad_input at the line that breaks it). Then certificate.json,
/// certificate.md and counterexamples.jsonl must be, byte for byte, what the log gives; each counterexample is judged
/// again by all oracles; and a method that this program has is run again on the set of 93,888 cases.
Verification verify(const std::string& directory);

}  // namespace tribunal
