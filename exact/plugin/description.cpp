#include "exact/plugin/description.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

#include "exact/base/failure.h"
#include "exact/base/json.h"
#include "exact/base/shown.h"

namespace tribunal {
namespace {

constexpr std::size_t longest_text = 100;

// --- the description, checked -----------------------------------------------------------------------------------

/// Whether s may stand in reports.
bool is_text(const std::string& s) { return !s.empty() && s.size() <= longest_text && shows_as_it_is(s); }

/// Reads at most one character beyond the longest text allowed, since the string may lack its end.
std::string string_from(const char* s, const char* what, const std::string& file) {
  if (s == nullptr) throw bad_input(file, 0, std::string(what) + " is NULL, expected a string");
  return std::string(s, strnlen(s, longest_text + 1));
}

std::string name_from(const char* s, const std::string& file) {
  const std::string name = string_from(s, "name", file);
  if (is_name(name)) return name;
  throw bad_input(file, 0, "name is \"" + name + "\", expected " + name_rule);
}

std::string text_from(const char* s, const char* what, const std::string& file) {
  const std::string text = string_from(s, what, file);
  if (is_text(text)) return text;
  throw bad_input(file, 0,
                  std::string(what) + ": expected one line of UTF-8, 1 to " + std::to_string(longest_text) + " bytes");
}

/// One of the values that the header lists for a field; `expected` names them.
template <class T, std::size_t n>
T value_from(int given, const char* field, const std::array<T, n>& values, const char* expected,
             const std::string& file) {
  if (given >= 0 && static_cast<std::size_t>(given) < n) return values[static_cast<std::size_t>(given)];
  throw bad_input(file, 0, std::string(field) + " is " + std::to_string(given) + ", expected " + expected);
}

Format format_from(int format, const std::string& file) {
  if (format == TRIBUNAL_BINARY32) return Format::binary32;
  if (format == TRIBUNAL_BINARY64) return Format::binary64;
  throw bad_input(file, 0, "format is " + std::to_string(format) + ", expected TRIBUNAL_BINARY32 or TRIBUNAL_BINARY64");
}

Convention convention_from(const tribunal_plugin& plugin, const std::string& file) {
  constexpr std::array version1 = {Convention::closed, Convention::transversal};
  constexpr std::array version2 = {Convention::closed, Convention::transversal, Convention::unspecified};
  if (plugin.abi == 1) {
    return value_from(plugin.convention, "convention", version1, "TRIBUNAL_CLOSED or TRIBUNAL_TRANSVERSAL", file);
  }
  return value_from(plugin.convention, "convention", version2,
                    "TRIBUNAL_CLOSED, TRIBUNAL_TRANSVERSAL or TRIBUNAL_COPLANAR_UNSPECIFIED", file);
}

/// Version 1 says in words which probes a test takes. Words that name none are taken to mean both.
Probes probes_in(const std::string& words) {
  const bool segments = words.find("segment") != std::string::npos, rays = words.find("ray") != std::string::npos;
  return segments || rays ? Probes{.segments = segments, .rays = rays} : Probes{};
}

void read_operands(Contract& c, const tribunal_plugin& plugin, const std::string& file) {
  constexpr int no_probe = TRIBUNAL_NO_SEGMENTS | TRIBUNAL_NO_RAYS;
  if ((plugin.operands & ~(no_probe | TRIBUNAL_NO_DEGENERATE)) != 0 || (plugin.operands & no_probe) == no_probe) {
    throw bad_input(
        file, 0,
        "operands is " + std::to_string(plugin.operands) +
            ", expected 0 or a sum of TRIBUNAL_NO_SEGMENTS or TRIBUNAL_NO_RAYS, and TRIBUNAL_NO_DEGENERATE");
  }
  c.probes = {.segments = (plugin.operands & TRIBUNAL_NO_SEGMENTS) == 0,
              .rays = (plugin.operands & TRIBUNAL_NO_RAYS) == 0};
  if (plugin.abi == 1) c.probes = probes_in(text_from(plugin.contract, "contract", file));
  c.probes.bounds = plugin.ask_within != nullptr;
  c.triangles = (plugin.operands & TRIBUNAL_NO_DEGENERATE) != 0 ? Triangles::proper : Triangles::any;
  if (plugin.ask == nullptr) c.triangles = Triangles::none;
}

void read_readings(Contract& c, const tribunal_plugin& plugin, const std::string& file) {
  constexpr std::array boundaries = {Boundary::closed, Boundary::open, Boundary::half_open, Boundary::unspecified};
  constexpr std::array ends = {Ends::closed, Ends::open, Ends::unspecified};
  constexpr std::array cullings = {Culling::none, Culling::back_faces};
  c.convention = convention_from(plugin, file);
  c.boundary = value_from(plugin.boundary, "boundary", boundaries, "one of TRIBUNAL_BOUNDARY_...", file);
  c.ends = value_from(plugin.ends, "ends", ends, "one of TRIBUNAL_ENDS_...", file);
  c.bounds = value_from(plugin.bounds, "bounds", ends, "one of TRIBUNAL_ENDS_...", file);
  c.culling = value_from(plugin.culling, "culling", cullings, "one of TRIBUNAL_CULLS_...", file);
}

void require_whole(const tribunal_plugin& plugin, const std::string& file) {
  if (plugin.tell == nullptr && (plugin.tells_contact != 0 || plugin.tells_t != 0 || plugin.tells_side != 0)) {
    throw bad_input(file, 0, "tell is NULL, expected a function that tells contact, side or t");
  }
  if (plugin.ask_within != nullptr && plugin.ask == nullptr) {
    throw bad_input(file, 0, "ask is NULL, expected a function beside ask_within");
  }
  if (plugin.prepare != nullptr && plugin.ask_prepared == nullptr) {
    throw bad_input(file, 0, "ask_prepared is NULL, expected a function beside prepare");
  }
}

}  // namespace

void require_version(int abi, const std::string& file) {
  if (abi >= 1 && abi <= TRIBUNAL_PLUGIN_ABI) return;
  throw bad_input(file, 0,
                  "is made for version " + std::to_string(abi) + " of tribunal_plugin.h, expected 1 to " +
                      std::to_string(TRIBUNAL_PLUGIN_ABI));
}

tribunal_plugin in_this_version(const tribunal_plugin& plugin, const std::string& file) {
  require_version(plugin.abi, file);
  if (plugin.abi > 2) return plugin;
  tribunal_plugin whole{};
  std::memcpy(&whole, &plugin,
              plugin.abi == 1 ? offsetof(tribunal_plugin, operands) : offsetof(tribunal_plugin, ask_within));
  return whole;
}

tribunal_mesh_plugin in_this_version(const tribunal_mesh_plugin& meshes, const std::string& file) {
  require_version(meshes.abi, file);
  if (meshes.abi > 2) return meshes;
  tribunal_mesh_plugin whole{};
  std::memcpy(&whole, &meshes, offsetof(tribunal_mesh_plugin, closest_normal));
  return whole;
}

Method described(const tribunal_plugin& plugin, const std::string& file) {
  const std::string name = name_from(plugin.name, file);
  Contract contract{.format = format_from(plugin.format, file)};
  read_operands(contract, plugin, file);
  read_readings(contract, plugin, file);
  require_whole(plugin, file);
  return {
      .name = name,
      .card = {.number = std::string(name_of(contract.format)),
               .summary = text_from(plugin.summary, "summary", file),
               .reference = plugin.reference != nullptr ? text_from(plugin.reference, "reference", file) : "plugin"},
      .contract = contract,
      .tells_contact = plugin.tells_contact != 0,
      .tells_side = plugin.tells_side != 0};
}

void read_restrictions(Contract& contract, const tribunal_polygon_plugin& polygons, const std::string& file) {
  constexpr int all = TRIBUNAL_PLANAR_ONLY | TRIBUNAL_NO_BOUNDARY;
  const int restrictions = polygons.restrictions;
  if ((restrictions & ~all) != 0) {
    throw bad_input(file, 0,
                    "restrictions is " + std::to_string(restrictions) +
                        ", expected 0 or a sum of TRIBUNAL_PLANAR_ONLY and TRIBUNAL_NO_BOUNDARY");
  }
  contract.polygons = (restrictions & TRIBUNAL_PLANAR_ONLY) != 0 ? Polygons::planar : Polygons::any;
  contract.polygon_boundary = (restrictions & TRIBUNAL_NO_BOUNDARY) != 0 ? Boundary::unspecified : Boundary::closed;
}

}  // namespace tribunal
