// The family of cases made from the user's own data.
#pragma once

#include <vector>

#include "exact/cases/families/family.h"
#include "exact/cases/own/own_data.h"

namespace tribunal {

/// A family, and the formats that its data can be asked in.
struct OwnFamily {
  Family family;
  std::vector<Format> formats;
};

/// Even cases are the questions as they stand (level 0), in the file's order, until all were asked. All others, by
/// level, are one of them changed: by units in the last place, snapped to a grid or onto each other's points, flipped,
/// or aimed at its target; often by more than one of these. A triangle without a probe gets one by aiming first.
///
/// Numbers are exact in the format: questions of binary64 are asked in both formats, rounded to binary32, where those
/// that overflow are left out; questions of binary32 in binary32 alone. Probes stay what they are, segments or rays; at
/// a mesh both are aimed.
OwnFamily family_of(const OwnData& data);

}  // namespace tribunal
