// The subject of a mesh trial: a method that is asked face by face, or a function of a mesh plugin.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/due.h"
#include "core/method.h"
#include "exact/base/fault.h"
#include "tracer/leak/surface.h"

namespace tribunal::leak {

/// A face that is reported as hit, with its t if one is given. `in_plane`: it is reported as holding the ray in its
/// plane.
struct Reported {
  std::uint32_t face;
  std::optional<double> t{};
  bool in_plane = false;
  std::optional<Point3> normal{};
  std::optional<Facing> side{};  ///< front or back, if it is said
};

/// What a subject reported of one ray; empty where it reports nothing of that kind.
struct Testimony {
  std::optional<std::vector<Reported>> hits{};       ///< every face hit
  std::optional<bool> any{};                         ///< whether a face is hit
  std::optional<std::optional<Reported>> closest{};  ///< the closest hit, if there is one
  std::optional<bool> inside{};                      ///< whether the source is inside
  Fault fault{};                                     ///< what it did instead; then all the rest is empty
};

/// Ray k of the trial, and the faces whose boxes it meets.
struct AskedRay {
  std::uint64_t k;
  Ray ray;
  std::vector<std::uint32_t> candidates{};
};

/// Where a normal points: as the right hand has it, (b − a) × (c − a); or to the side from which the ray comes.
enum class NormalSense : std::uint8_t { by_vertices, towards_source };

/// Whether a method can be asked face by face: about a ray and a triangle.
inline bool takes_rays(const Method& m) {
  return m.ray && m.contract.probes.rays && m.contract.triangles != Triangles::none;
}

struct Subject {
  std::string name;
  Contract contract{};
  std::string told{};  ///< one line: what is asked, and how parity and the closest hit are made of it
  bool tells_hits = true, tells_parity = false, tells_closest = false;
  bool sorted = false;  ///< its list of hits is to begin with the nearest
  /// Whether parity is to be right too where the ray touches an edge or a vertex from one side.
  bool parity_where_touching = false;
  bool tells_normals = false;  ///< or sides
  NormalSense sense = NormalSense::by_vertices;
  double most_ulps = 0;     ///< that t of the closest hit may be off by its promise; 0: it promises nothing
  double most_degrees = 0;  ///< the same of the angle between a normal and the exact one
  std::function<void(std::span<const AskedRay>, std::span<Testimony>)> ask{};  ///< from several threads at once
};

/// The subject that asks the method about each candidate of a ray. Every face that the method hits is reported. The
/// closest is the least by the method's order of hits or, if it has none, by t; among equals that with the lowest
/// number. The source is inside if the number of hits is odd: the number of faces hit, if the contract gives a shared
/// edge to exactly one face; else the number of hits that differ in the order, or in t. Method and surface must
/// outlive the subject.
Subject subject_of(const Method& method, const Surface& surface);

}  // namespace tribunal::leak
