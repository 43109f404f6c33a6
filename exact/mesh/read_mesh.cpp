#include "exact/mesh/read_mesh.h"

#include <cctype>
#include <filesystem>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/mesh/readers.h"
#include "exact/mesh/triangulate.h"

namespace tribunal {
namespace {

using Reader = PolygonSoup (*)(const std::string& file, std::string_view bytes);

struct FormatRow {
  const char* extension;
  Reader read;
};

constexpr FormatRow formats[] = {{".off", read_off}, {".obj", read_obj}, {".ply", read_ply}, {".stl", read_stl}};

std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// nullptr for a name of another kind.
Reader reader_for(const std::string& extension) {
  for (const FormatRow& row : formats) {
    if (extension == row.extension) return row.read;
  }
  return nullptr;
}

Reader reader_of(const std::string& file) {
  const std::string extension = extension_of(file);
  if (const Reader reader = reader_for(extension)) return reader;
  throw bad_input(file, 0, "unknown mesh format \"" + extension + "\", expected .off, .obj, .ply or .stl");
}

}  // namespace

bool is_mesh_name(const std::string& file) { return reader_for(extension_of(file)) != nullptr; }

PolygonSoup read_soup(const std::string& file, std::string_view bytes) {
  const Reader read = reader_of(file);
  if (bytes.empty()) throw bad_input(file, 0, "is empty, expected a mesh");
  return read(file, bytes);
}

Mesh read_mesh(const std::string& path) {
  reader_of(path);
  return mesh_of(read_soup(path, read_file(path)));
}

}  // namespace tribunal
