#include "tracer/leak/mesh_subject.h"

#include <memory>

namespace tribunal::leak {
namespace {

using Mesh = std::shared_ptr<const PreparedMesh>;

Mesh prepared(const MeshPlugin& plugin, const Surface& surface) {
  std::vector<std::size_t> corners;
  for (std::uint32_t f = 0; f < surface.face_count(); ++f) {
    for (const std::uint32_t v : surface.corners(f)) corners.push_back(v);
  }
  return std::make_shared<const PreparedMesh>(plugin.functions, plugin.file, surface.vertices(), corners);
}

std::vector<Ray> rays_of(std::span<const AskedRay> asked) {
  std::vector<Ray> rays;
  for (const AskedRay& a : asked) rays.push_back(a.ray);
  return rays;
}

Reported reported(const tribunal_mesh_hit& hit, bool with_t) {
  return {static_cast<std::uint32_t>(hit.face), with_t ? std::optional(hit.t) : std::nullopt};
}

Subject closest_of(const MeshPlugin& plugin, const Mesh& mesh) {
  const bool with_t = plugin.functions.tells_t != 0;
  return {.name = plugin.name + "/closest",
          .contract = plugin.contract,
          .told = "the closest hit of a tree",
          .tells_closest = true,
          .most_ulps = plugin.functions.most_ulps,
          .ask = [mesh, with_t](std::span<const AskedRay> asked, std::span<Testimony> said) {
            const auto hits = mesh->closest(rays_of(asked));
            for (std::size_t i = 0; i < hits.size(); ++i) {
              const bool none = hits[i].face == TRIBUNAL_NO_FACE;
              said[i].closest = none ? std::nullopt : std::optional(reported(hits[i], with_t));
            }
          }};
}

Subject any_of(const MeshPlugin& plugin, const Mesh& mesh) {
  return {.name = plugin.name + "/any",
          .contract = plugin.contract,
          .told = "whether a tree has any hit",
          .ask = [mesh](std::span<const AskedRay> asked, std::span<Testimony> said) {
            const auto answers = mesh->any(rays_of(asked));
            for (std::size_t i = 0; i < answers.size(); ++i) said[i].any = answers[i] != 0;
          }};
}

Subject all_of(const MeshPlugin& plugin, const Mesh& mesh) {
  const bool with_t = plugin.functions.tells_t != 0;
  return {.name = plugin.name + "/all",
          .contract = plugin.contract,
          .told = "all hits of a tree",
          .sorted = plugin.functions.sorted != 0,
          .ask = [mesh, with_t](std::span<const AskedRay> asked, std::span<Testimony> said) {
            for (std::size_t i = 0; i < asked.size(); ++i) {
              said[i].hits.emplace();
              for (const auto& hit : mesh->all(asked[i].ray)) said[i].hits->push_back(reported(hit, with_t));
            }
          }};
}

Subject inside_of(const MeshPlugin& plugin, const Mesh& mesh) {
  return {.name = plugin.name + "/inside",
          .contract = plugin.contract,
          .told = "whether a tree has the source of a ray inside",
          .tells_hits = false,
          .tells_parity = true,
          .parity_where_touching = true,
          .ask = [mesh](std::span<const AskedRay> asked, std::span<Testimony> said) {
            const auto answers = mesh->inside(rays_of(asked));
            for (std::size_t i = 0; i < answers.size(); ++i) said[i].inside = answers[i] != 0;
          }};
}

}  // namespace

std::vector<Subject> subjects_of(const MeshPlugin& plugin, const Surface& surface) {
  const Mesh mesh = prepared(plugin, surface);
  const tribunal_mesh_plugin& f = plugin.functions;
  std::vector<Subject> subjects;
  if (f.closest != nullptr) subjects.push_back(closest_of(plugin, mesh));
  if (f.any != nullptr) subjects.push_back(any_of(plugin, mesh));
  if (f.all != nullptr) subjects.push_back(all_of(plugin, mesh));
  if (f.inside != nullptr && surface.topology().closed()) subjects.push_back(inside_of(plugin, mesh));
  return subjects;
}

}  // namespace tribunal::leak
