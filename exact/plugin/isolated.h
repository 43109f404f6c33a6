// A plugin in processes of its own: whatever it does there is a finding about a case, and not the end of the run.
#pragma once

#include <string>

#include "core/method.h"

namespace tribunal {

/// The method that the library describes, asked in child processes, one for each thread that asks at a time. The
/// library is never loaded here. A child that dies, exits, throws, changes its floating-point environment or does not
/// answer within the time limit is killed, the next question goes to a new one, and the answer is a fault
/// (core/answer.h). A batch of which that becomes true is asked again one by one, so every case is held against what it
/// does alone.
///
/// A method whose answers depend on the query alone answers as it would in this process.
///
/// Before any thread starts. Fails like load_plugin.
Method isolated_method(const std::string& file, double time_limit);

}  // namespace tribunal
