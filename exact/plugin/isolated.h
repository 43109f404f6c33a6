// A plugin in processes of its own: whatever it does there is a finding on a case and does not end the run.
#pragma once

#include <memory>

#include "core/method.h"
#include "exact/plugin/children.h"

namespace tribunal {

/// The method that the library describes, asked in child processes, one for each thread that asks at a time. A child
/// that dies, exits, throws, changes its floating-point environment or does not answer within the time limit is killed,
/// the next question goes to a new one, and the answer is a fault (core/answer.h). The queries of a batch that ended so
/// are asked again one by one, so that every case is judged by what it does alone.
///
/// A method whose answers depend on the query alone answers as it would in this process. `plugin` is the description
/// that the children sent.
Method isolated_method(const tribunal_plugin& plugin, const std::shared_ptr<const PluginChildren>& children);

}  // namespace tribunal
