// What the writers of a certificate share.
#pragma once

#include <map>
#include <string>

#include "exact/certificate/certificate.h"

namespace tribunal {

inline constexpr Format both_formats[] = {Format::binary64, Format::binary32};

inline const char* probes_word(bool of_rays) { return of_rays ? "ray" : "segment"; }

/// The number of counterexamples with each fault.
std::map<std::string, std::size_t> faults_in(const Certificate& c);

/// What it was made with.
Json environment_json(const Certificate& c);

}  // namespace tribunal
