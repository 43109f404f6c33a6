// Prepared forms of a method, compared with its plain one.
#pragma once

#include "core/method.h"

namespace tribunal {

/// Fails with Exit::disagreement and the query where the answer for a triangle or a ray that the method has prepared
/// differs from that of the plain test. Does nothing for methods without prepared forms, of operands that are not
/// finite, and of polygons.
void require_same_when_prepared(const Method& method, const Query& query);

}  // namespace tribunal
