#include "exact/record/environment.h"

#include <gmp.h>

#include <boost/version.hpp>
#include <sstream>
#include <string>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/json.h"

namespace tribunal {
namespace {

std::string read_if_readable(const std::string& file) {
  try {
    return read_file(file);
  } catch (const Failure& f) {
    if (f.exit() != Exit::bad_input) throw;
    return "";
  }
}

std::string read_processor() {
  std::istringstream info(read_if_readable("/proc/cpuinfo"));
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

const std::string& processor() {
  static const std::string name = read_processor();
  return name;
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __VERSION__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

Json environment() {
  Json e;
  e["program"] = std::string("tribunal ") + TRIBUNAL_VERSION;
  e["revision"] = TRIBUNAL_REVISION;
  e["compiler"] = compiler();
  e["flags"] = TRIBUNAL_FLAGS;
  e["processor"] = processor();
  e["gmp"] = gmp_version;
  e["boost"] = BOOST_LIB_VERSION;
  e["cgal"] = TRIBUNAL_CGAL_VERSION;
  return e;
}

}  // namespace tribunal
