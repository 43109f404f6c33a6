#include "exact/plugin/load.h"

#include <utility>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/sha256.h"
#include "exact/methods/methods.h"
#include "exact/plugin/description.h"
#include "exact/plugin/isolated.h"
#include "exact/plugin/library.h"

namespace tribunal {
namespace {

/// What was loaded, in order.
struct Loaded {
  std::vector<std::string> methods{};
  std::vector<MeshPlugin> meshes{};
};

Loaded& loaded() {
  static Loaded list;
  return list;
}

void add(Method method, const std::string& file) {
  if (find_method(method.name) != nullptr) {
    throw Failure(Exit::usage,
                  file + ": there is a method called " + method.name + " already, expected a name of its own");
  }
  method.card.reference += "; library sha256 " + sha256(read_file(file));
  loaded().methods.push_back(method.name);
  add_method(std::move(method));
}

std::string load_here(const std::string& file) {
  const Library library = open_library(file);
  const tribunal_plugin plugin = in_this_version(*library.plugin, file);
  if (library.meshes != nullptr) loaded().meshes.push_back(mesh_plugin(plugin, *library.meshes, file));
  const bool tree_alone = library.meshes != nullptr && library.polygons == nullptr && plugin.ask == nullptr;
  if (tree_alone) return loaded().meshes.back().name;
  Method method = plugin_method(plugin, file, library.polygons);
  const std::string name = method.name;
  add(std::move(method), file);
  return name;
}

}  // namespace

std::string load_plugin(const std::string& file, const Isolation& isolation) {
  if (!isolation) return load_here(file);
  Method method = isolated_method(file, *isolation);
  const std::string name = method.name;
  add(std::move(method), file);
  return name;
}

const std::vector<std::string>& loaded_methods() { return loaded().methods; }
const std::vector<MeshPlugin>& loaded_meshes() { return loaded().meshes; }

}  // namespace tribunal
