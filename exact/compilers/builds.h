// The naive methods as other compilers and flags make them.
#pragma once

#include <string>
#include <vector>

#include "core/method.h"

namespace tribunal {

/// One build: who made it, how, and its methods, in the order of the program's table and with its names and contracts.
struct Build {
  std::string name;  ///< of the file: "g++-O0"
  std::string compiler, flags;
  std::vector<Method> methods;
};

/// The build in this library, which stays loaded. Fails with Exit::bad_input, naming the file, if it is none.
Build load_build(const std::string& file);

/// All builds in the folder compilers/ beside this program or above it, by name; none where there is no such folder.
std::vector<Build> all_builds();

}  // namespace tribunal
