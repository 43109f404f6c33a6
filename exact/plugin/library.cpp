#include "exact/plugin/library.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/fp_environment.h"
#include "exact/base/plain_locale.h"

namespace tribunal {
namespace {

constexpr const char* entry_point = "tribunal_plugin_describe";
constexpr const char* polygon_entry_point = "tribunal_plugin_describe_polygons";
constexpr const char* mesh_entry_point = "tribunal_plugin_describe_meshes";

/// dlopen searches the system for a name without a slash; we mean the file.
std::string as_path(const std::string& file) { return file.find('/') == std::string::npos ? "./" + file : file; }

void require_file(const std::string& file) {
  if (is_directory(file)) throw bad_input(file, 0, "is a directory, expected a shared library");
  if (access(file.c_str(), R_OK) != 0) throw bad_input(file, 0, std::string("cannot read: ") + std::strerror(errno));
}

/// What dlerror says, without the path that it starts with.
std::string why_not_loaded(const std::string& path) {
  std::string why = dlerror();
  if (why.starts_with(path + ": ")) why.erase(0, path.size() + 2);
  return why;
}

/// Loads the library, which is never unloaded, since the method's functions are in it.
void* load_library(const std::string& file) {
  const std::string path = as_path(file);
  if (void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  throw bad_input(file, 0, "cannot be loaded as a shared library: " + why_not_loaded(path));
}

/// The description that the library exports under the name; nothing if it exports none.
template <class D>
std::optional<const D*> described_by(void* library, const char* name, const std::string& file) {
  const auto describe = reinterpret_cast<const D* (*)()>(dlsym(library, name));
  if (describe == nullptr) return std::nullopt;
  const D* const description = describe();
  use_plain_locale();
  require_exact_rounding();  // whatever the library did as it was loaded and asked
  if (description == nullptr) throw bad_input(file, 0, std::string(name) + " returned NULL");
  return description;
}

}  // namespace

Library open_library(const std::string& file) {
  require_file(file);
  void* const library = load_library(file);
  const auto plugin = described_by<tribunal_plugin>(library, entry_point, file);
  if (!plugin) {
    throw bad_input(file, 0, std::string("does not export ") + entry_point + ", expected a plugin (tribunal_plugin.h)");
  }
  const auto polygons = described_by<tribunal_polygon_plugin>(library, polygon_entry_point, file);
  const auto meshes = described_by<tribunal_mesh_plugin>(library, mesh_entry_point, file);
  return {*plugin, polygons.value_or(nullptr), meshes.value_or(nullptr)};
}

}  // namespace tribunal
