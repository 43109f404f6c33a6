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
  return std::make_shared<const PreparedMesh>(prepare(plugin, surface.vertices(), corners));
}

std::vector<Ray> rays_of(std::span<const AskedRay> asked) {
  std::vector<Ray> rays;
  for (const AskedRay& a : asked) rays.push_back(a.ray);
  return rays;
}

Reported reported(const tribunal_mesh_hit& hit, bool with_t) {
  return {static_cast<std::uint32_t>(hit.face), with_t ? std::optional(hit.t) : std::nullopt};
}

Facing side_of(int side) {
  return side == TRIBUNAL_SIDE_FRONT ? Facing::front : side == TRIBUNAL_SIDE_BACK ? Facing::back : Facing::unsaid;
}

/// The closest hit with what the tree says that it tells of it. A side that is not said is no side.
Reported reported(const ClosestHit& closest, const tribunal_mesh_plugin& tells) {
  Reported r = reported(closest.hit, tells.tells_t != 0);
  const double* const n = closest.normal.normal;
  if (tells.tells_normal != 0) r.normal = Point3(n[0], n[1], n[2]);
  if (tells.tells_side != 0) r.side = side_of(closest.normal.side);
  return r;
}

/// What each answer says, or the fault that there was instead.
template <class Answer, class Say>
void take(const std::vector<Told<Answer>>& told, std::span<Testimony> said, const Say& say) {
  for (std::size_t i = 0; i < told.size(); ++i) {
    said[i].fault = told[i].fault;
    if (!told[i].fault) say(told[i].answer, said[i]);
  }
}

Subject closest_of(const MeshPlugin& plugin, const Mesh& mesh) {
  const tribunal_mesh_plugin& f = plugin.functions;
  return {
      .name = plugin.name + "/closest",
      .contract = plugin.contract,
      .told = "the closest hit of a tree",
      .tells_closest = true,
      .tells_normals = f.tells_normal != 0 || f.tells_side != 0,
      .sense = f.normal_sense == TRIBUNAL_NORMAL_BY_VERTICES ? NormalSense::by_vertices : NormalSense::towards_source,
      .most_ulps = f.most_ulps,
      .most_degrees = f.most_degrees,
      .ask = [mesh, f](std::span<const AskedRay> asked, std::span<Testimony> said) {
        take(mesh->closest(rays_of(asked)), said, [&](const ClosestHit& c, Testimony& s) {
          const bool none = c.hit.face == TRIBUNAL_NO_FACE;
          s.closest = none ? std::nullopt : std::optional(reported(c, f));
        });
      }};
}

Subject any_of(const MeshPlugin& plugin, const Mesh& mesh) {
  return {.name = plugin.name + "/any",
          .contract = plugin.contract,
          .told = "whether a tree has any hit",
          .ask = [mesh](std::span<const AskedRay> asked, std::span<Testimony> said) {
            take(mesh->any(rays_of(asked)), said, [](int any, Testimony& s) { s.any = any != 0; });
          }};
}

Subject all_of(const MeshPlugin& plugin, const Mesh& mesh) {
  const bool with_t = plugin.functions.tells_t != 0;
  return {.name = plugin.name + "/all",
          .contract = plugin.contract,
          .told = "all hits of a tree",
          .sorted = plugin.functions.sorted != 0,
          .ask = [mesh, with_t](std::span<const AskedRay> asked, std::span<Testimony> said) {
            take(mesh->all(rays_of(asked)), said, [&](const std::vector<tribunal_mesh_hit>& hits, Testimony& s) {
              s.hits.emplace();
              for (const auto& hit : hits) s.hits->push_back(reported(hit, with_t));
            });
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
            take(mesh->inside(rays_of(asked)), said, [](int inside, Testimony& s) { s.inside = inside != 0; });
          }};
}

}  // namespace

std::vector<Subject> subjects_of(const MeshPlugin& plugin, const Surface& surface) {
  const Mesh mesh = prepared(plugin, surface);
  const tribunal_mesh_plugin& f = plugin.functions;
  std::vector<Subject> subjects;
  if (plugin.has_closest()) subjects.push_back(closest_of(plugin, mesh));
  if (f.any != nullptr) subjects.push_back(any_of(plugin, mesh));
  if (f.all != nullptr) subjects.push_back(all_of(plugin, mesh));
  if (f.inside != nullptr && surface.topology().closed()) subjects.push_back(inside_of(plugin, mesh));
  return subjects;
}

}  // namespace tribunal::leak
