#include "core/contract.h"

namespace tribunal {
namespace {

/// a and b, with the separator between them unless one is empty.
std::string joined(std::string a, std::string_view separator, const std::string& b) {
  if (!a.empty() && !b.empty()) a += separator;
  return a + b;
}

std::string probes_of(const Contract& c) {
  const std::string rays = joined(c.probes.rays ? "ray" : "", ", ", c.probes.bounds ? "bounded ray" : "");
  return joined(c.probes.segments ? "segment" : "", ", ", rays);
}

std::string targets_of(const Contract& c) {
  if (c.triangles == Triangles::any && c.polygons == Polygons::any) return "any triangle or polygon";
  const char* const triangles[] = {"", "any triangle", "triangle"};
  const char* const polygons[] = {"", "any polygon", "planar polygon"};
  return joined(triangles[static_cast<int>(c.triangles)], ", ", polygons[static_cast<int>(c.polygons)]);
}

/// `kind` is the kind of target that b is about; empty if the method takes one kind only, or b holds for both.
std::string boundary_in_words(Boundary b, const std::string& kind) {
  const std::string of = kind.empty() ? " " : " " + kind + " ";
  switch (b) {
    case Boundary::closed:
      return "";
    case Boundary::open:
      return "open" + of + "boundary";
    case Boundary::half_open:
      return "half-open" + of + "edges";
    case Boundary::unspecified:
      return "no" + of + "boundary";
  }
  return "";
}

std::string boundaries_of(const Contract& c) {
  if (c.polygons == Polygons::none) return boundary_in_words(c.boundary, "");
  if (c.triangles == Triangles::none || c.boundary == c.polygon_boundary) {
    return boundary_in_words(c.polygon_boundary, "");
  }
  return joined(boundary_in_words(c.boundary, "triangle"), ", ", boundary_in_words(c.polygon_boundary, "polygon"));
}

std::string restrictions_of(const Contract& c) {
  const char* const ends[] = {"", "open ends", "no ends"};
  const char* const bounds[] = {"", "open bounds", "bounds unspecified"};
  std::string words = c.triangles == Triangles::proper ? "no degenerate operand" : "";
  words = joined(words, ", ", boundaries_of(c));
  words = joined(words, ", ", ends[static_cast<int>(c.ends)]);
  words = joined(words, ", ", bounds[static_cast<int>(c.bounds)]);
  return joined(words, ", ", c.culling == Culling::back_faces ? "back faces culled" : "");
}

}  // namespace

std::string in_words(const Contract& c) {
  return joined(joined(probes_of(c), "; ", targets_of(c)), ", ", restrictions_of(c));
}

}  // namespace tribunal
