// The lanes on which boxes are tested. Included by files that are compiled for one instruction set each.
#pragma once

#include "exact/filtered/batch/lanes.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal::HWY_NAMESPACE {

/// A vector of as many binary32 numbers as a node has boxes, or fewer where the instruction set has fewer lanes.
using BoxTag = hn::CappedTag<float, node_width>;
using BoxVector = hn::Vec<BoxTag>;

inline constexpr BoxTag box_tag;

}  // namespace tribunal::HWY_NAMESPACE
