#include "exact/plugin/load.h"

#include <utility>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/sha256.h"
#include "exact/methods/methods.h"
#include "exact/plugin/isolated.h"
#include "exact/plugin/library.h"

namespace tribunal {
namespace {

Method method_in(const std::string& file, const Isolation& isolation) {
  if (isolation) return isolated_method(file, *isolation);
  const Library library = open_library(file);
  return plugin_method(*library.plugin, file, library.polygons);
}

}  // namespace

std::string load_plugin(const std::string& file, const Isolation& isolation) {
  Method method = method_in(file, isolation);
  const std::string name = method.name;
  if (find_method(name) != nullptr) {
    throw Failure(Exit::usage, file + ": there is a method called " + name + " already, expected a name of its own");
  }
  method.card.reference += "; library sha256 " + sha256(read_file(file));
  add_method(std::move(method));
  return name;
}

}  // namespace tribunal
