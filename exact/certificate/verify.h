// Makes a certificate again from its log and compares it with the files beside the log.
#pragma once

#include <string>
#include <vector>

#include "exact/certificate/certificate.h"

namespace tribunal {

struct Verification {
  Certificate certificate;
  std::vector<std::string> faults{};  ///< one line each; none: verified
  std::size_t confirmed = 0;          ///< counterexamples whose exact answer and evidence were found again
  std::uint64_t asked_again = 0;      ///< cases of the smallest set, which the method was asked again
  std::string not_asked{};            ///< why the method was not asked again, if it was not
  std::uint64_t rerun = 0;            ///< cases that were run again
};

/// The chain of hashes is checked first (Exit::bad_input at the line that breaks it). Then certificate.json,
/// certificate.md and counterexamples.jsonl must be, byte for byte, what the log gives; each counterexample is judged
/// again by all oracles; and a method that this program has is run again on the smallest set: of triangles 93,888
/// cases, of polygons 217,140, and on each witness against a relation, which must follow from budget and seed. What
/// follows from budget and seed is made anew: the sets, streams, populations, calibration and numbers of cases that the
/// budget owes, and the first cases of each stream. `rerun`: the whole trial of a method that this program has is run
/// again, on so many threads, and must give the same counts; 0: not.
Verification verify(const std::string& directory, unsigned rerun = 0);

}  // namespace tribunal
