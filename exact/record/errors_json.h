// Errors of numbers as JSON: what logs, checkpoints, summaries and charts hold.
#pragma once

#include <string>

#include "exact/base/record.h"
#include "exact/trial/ulps.h"

namespace tribunal {

/// {"equal":n,"up_to":[…],"most":x,"most_at":k,"zeros":n,"zeros_missed":n,"not_finite":n,"beyond":n}: `up_to` counts
/// the errors up to ½, 1, 2, 4 … ulps without trailing zeros; what is 0 is left out, and `most_at` where nothing is
/// measured.
Json from_ulps(const Ulps& ulps);
Ulps to_ulps(const Record& object);

/// {"hits":n,"withheld":n,"t":{…},"weights":{…}}, without members that count nothing.
Json from_errors(const HitErrors& errors);
HitErrors to_errors(const Record& object);

/// The record "errors" of a method in a family and format.
Json errors_record(const std::string& method, const std::string& family, Format format, const HitErrors& errors);

}  // namespace tribunal
