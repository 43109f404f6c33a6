#include "exact/cli/polygon_streams.h"

#include <algorithm>

#include "exact/cli/command.h"
#include "exact/io/failure.h"
#include "exact/io/suggestion.h"

namespace tribunal {
namespace {

constexpr std::string_view prefix = "polygon-";

const PolygonFamily& family_named(const std::string& name) {
  if (const PolygonFamily* family = find_polygon_family(name)) return *family;
  if (!name.starts_with(prefix)) throw Failure(Exit::usage, "\"" + name + "\" is no polygon family: ask for it apart");
  std::vector<std::string> known;
  for (const PolygonFamily& f : all_polygon_families()) known.emplace_back(f.name);
  throw Failure(Exit::usage,
                "unknown family \"" + name + "\"" + suggestion(name, known, "one that `tribunal fuzz --help` lists"));
}

}  // namespace

std::vector<PolygonStream> polygon_streams_named(const std::string& comma_separated) {
  const std::vector<std::string> names = split(comma_separated);
  const bool any = std::any_of(names.begin(), names.end(), [](const auto& name) { return name.starts_with(prefix); });
  std::vector<PolygonStream> streams;
  if (!any) return streams;
  for (const std::string& name : names) {
    const PolygonFamily& family = family_named(name);
    if (std::any_of(streams.begin(), streams.end(), [&](const auto& s) { return s.family == &family; })) {
      throw Failure(Exit::usage, "family " + name + " is named twice");
    }
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

std::string polygon_family_help() {
  std::string text = "; or polygon families, by themselves:";
  for (const PolygonFamily& f : all_polygon_families()) {
    text += " " + std::string(f.name) + " (" + std::string(f.stresses) + ")";
  }
  return text;
}

void require_polygons(const Method& method) {
  if (!method.polygon) throw Failure(Exit::usage, method.name + " takes no polygons");
}

}  // namespace tribunal
