// A plugin in processes of its own: whatever it does there is a finding on a case and does not end the run.
#pragma once

#include <string>

#include "core/method.h"

namespace tribunal {

/// The method that the library describes, asked in child processes, one for each thread that asks at a time. The
/// library is never loaded here. A child that dies, exits, throws, changes its floating-point environment or does not
/// answer within the time limit is killed, the next question goes to a new one, and the answer is a fault
/// (core/answer.h). The queries of a batch that ended so are asked again one by one, so that
/// every case is judged by what it does alone.
///
/// A method whose answers depend on the query alone answers as it would in this process.
///
/// Must be called before any thread starts. Fails like load_plugin.
Method isolated_method(const std::string& file, double time_limit);

}  // namespace tribunal
