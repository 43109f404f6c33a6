// Prepared forms of a method, held against its plain one.
#pragma once

#include "core/method.h"

namespace tribunal {

/// Fails with Exit::disagreement and the query where a triangle or a ray that the method has prepared is answered
/// otherwise than the query itself. Says nothing of methods without prepared forms, of operands that are not
/// finite, and of polygons.
void require_same_when_prepared(const Method& method, const Query& query);

}  // namespace tribunal
