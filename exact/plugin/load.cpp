#include "exact/plugin/load.h"

#include <utility>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/sha256.h"
#include "exact/methods/methods.h"
#include "exact/plugin/description.h"
#include "exact/plugin/isolated.h"
#include "exact/plugin/isolated_mesh.h"
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
  if (library.meshes != nullptr) {
    const tribunal_mesh_plugin meshes = in_this_version(*library.meshes, file);
    loaded().meshes.push_back(mesh_plugin(plugin, meshes, file, [meshes](auto vertices, auto corners) {
      return mesh_calls_here(meshes, vertices, corners);
    }));
  }
  const bool tree_alone = library.meshes != nullptr && library.polygons == nullptr && plugin.ask == nullptr;
  if (tree_alone) return loaded().meshes.back().name;
  Method method = plugin_method(plugin, file, library.polygons);
  const std::string name = method.name;
  add(std::move(method), file);
  return name;
}

const char* text(const std::optional<std::string>& s) { return s ? s->c_str() : nullptr; }

/// The plugin's description with the strings that the child sent. The functions are the child's and are never called.
tribunal_plugin description_in(const Introduction& received) {
  tribunal_plugin plugin = received.plugin;
  plugin.name = text(received.name);
  plugin.contract = text(received.contract);
  plugin.summary = text(received.summary);
  plugin.reference = text(received.reference);
  return plugin;
}

std::string load_isolated(const std::string& file, double time_limit) {
  const auto children = std::make_shared<const PluginChildren>(file, time_limit);
  const Introduction& received = children->introduction();
  const tribunal_plugin plugin = description_in(received);
  if (received.has_tree) {
    loaded().meshes.push_back(mesh_plugin(plugin, received.meshes, file, [children](auto vertices, auto corners) {
      return isolated_mesh_calls(children, vertices, corners);
    }));
  }
  const bool tree_alone = received.has_tree && !received.takes_polygons && plugin.ask == nullptr;
  if (tree_alone) return loaded().meshes.back().name;
  Method method = isolated_method(plugin, children);
  const std::string name = method.name;
  add(std::move(method), file);
  return name;
}

}  // namespace

std::string load_plugin(const std::string& file, const Isolation& isolation) {
  return isolation ? load_isolated(file, *isolation) : load_here(file);
}

const std::vector<std::string>& loaded_methods() { return loaded().methods; }
const std::vector<MeshPlugin>& loaded_meshes() { return loaded().meshes; }

}  // namespace tribunal
