// Numbers are read and written alike in every locale.
#pragma once

namespace tribunal {

/// Gives the calling thread the "C" locale, whatever the process's is or becomes: a library that calls setlocale
/// changes no thread that has called this. Some nanoseconds where the thread has it already.
void use_plain_locale();

}  // namespace tribunal
