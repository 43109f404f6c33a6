#include "exact/plugin/mesh_plugin.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/base/failure.h"
#include "exact/plugin/description.h"

namespace tribunal {
namespace {

std::vector<double> coordinates_of(std::span<const Ray> rays) {
  std::vector<double> x;
  for (const Ray& r : rays) {
    for (const Point3& p : {r.o, r.d.v}) x.insert(x.end(), {p.x, p.y, p.z});
  }
  return x;
}

std::vector<double> coordinates_of(std::span<const Point3> points) {
  std::vector<double> x;
  for (const Point3& p : points) x.insert(x.end(), {p.x, p.y, p.z});
  return x;
}

/// The line that ends the command.
Failure failure_of(const Fault& fault, const std::string& file, const char* function) {
  const std::string who = std::string(function) + " of a mesh ";
  if (fault.kind == Status::gave_no_answer) return bad_input(file, 0, who + fault.detail);
  if (fault.kind == Status::changed_environment) {
    return Failure(Exit::fp_environment,
                   file + ": " + who + "changed the rounding mode, precision or exceptions, or flushes to zero");
  }
  return Failure(Exit::disagreement, file + ": " + who + describe(fault));
}

bool is_answer(int answer) { return answer == 0 || answer == 1; }

std::string wrong_answer(int answer) {
  return is_answer(answer) ? "" : "answered " + std::to_string(answer) + ", expected 0 or 1";
}

}  // namespace

/// Asks about all rays at once; if that fails, about each alone. If none fails then, it is the first of them.
template <class Answer, class Ask>
void PreparedMesh::tell(const char* function, std::span<const double> rays, const Ask& ask,
                        std::span<Told<Answer>> told) const {
  try {
    ask(rays, told);
    return;
  } catch (const CallFailed& failed) {
    if (!calls_->isolated()) throw failure_of(failed.fault, file_, function);
    told[0].fault = failed.fault;
  }
  if (told.size() == 1) return;
  const Fault of_all = std::exchange(told[0].fault, {});
  for (std::size_t i = 0; i < told.size(); ++i) tell(function, rays.subspan(6 * i, 6), ask, told.subspan(i, 1));
  const bool found = std::ranges::any_of(told, [](const Told<Answer>& t) { return static_cast<bool>(t.fault); });
  if (!found) told[0].fault = {of_all.kind, of_all.detail + ", once, not when asked again"};
}

/// `wrong` says what is wrong with an answer, if something is.
template <class Answer, class Ask, class Wrong>
std::vector<Told<Answer>> PreparedMesh::told(const char* function, std::span<const Ray> rays, const Ask& ask,
                                             const Wrong& wrong) const {
  const std::vector<double> x = coordinates_of(rays);
  std::vector<Told<Answer>> told(rays.size());
  const std::size_t most = std::min(calls_->largest_batch(), rays.size());
  for (std::size_t first = 0; first < rays.size(); first += most) {
    const std::size_t n = std::min(most, rays.size() - first);
    tell(function, std::span(x).subspan(6 * first, 6 * n), ask, std::span(told).subspan(first, n));
  }
  for (Told<Answer>& t : told) {
    if (t.fault) continue;
    const std::string what = wrong(t.answer);
    if (what.empty()) continue;
    t.fault = {Status::gave_no_answer, what};
    if (!calls_->isolated()) throw failure_of(t.fault, file_, function);
  }
  return told;
}

std::vector<Told<ClosestHit>> PreparedMesh::closest(std::span<const Ray> rays) const {
  const auto ask = [&](std::span<const double> x, std::span<Told<ClosestHit>> told) {
    std::vector<tribunal_mesh_hit> hits(told.size());
    std::vector<tribunal_mesh_normal> normals(told.size());
    calls_->closest(x, hits, normals);
    for (std::size_t i = 0; i < told.size(); ++i) told[i].answer = {hits[i], normals[i]};
  };
  return told<ClosestHit>("closest", rays, ask, [&](const ClosestHit& c) {
    return c.hit.face == TRIBUNAL_NO_FACE ? "" : wrong_face(c.hit.face);
  });
}

std::vector<Told<std::vector<tribunal_mesh_hit>>> PreparedMesh::all(std::span<const Ray> rays) const {
  using Hits = std::vector<tribunal_mesh_hit>;
  const auto ask = [&](std::span<const double> x, std::span<Told<Hits>> told) {
    std::vector<std::size_t> counts(told.size());
    const Hits hits = calls_->all(x, counts);
    auto next = hits.begin();
    for (std::size_t i = 0; i < told.size(); ++i) {
      const auto end = next + static_cast<std::ptrdiff_t>(counts[i]);
      told[i].answer.assign(next, end);
      next = end;
    }
  };
  return told<Hits>("all", rays, ask, [&](const Hits& hits) {
    const auto bad = std::ranges::find_if(hits, [&](const tribunal_mesh_hit& h) { return h.face >= face_count_; });
    return bad == hits.end() ? "" : wrong_face(bad->face);
  });
}

std::vector<Told<int>> PreparedMesh::any(std::span<const Ray> rays) const {
  const auto ask = [&](std::span<const double> x, std::span<Told<int>> told) {
    std::vector<int> answers(told.size());
    calls_->any(x, answers);
    for (std::size_t i = 0; i < told.size(); ++i) told[i].answer = answers[i];
  };
  return told<int>("any", rays, ask, wrong_answer);
}

std::vector<Told<int>> PreparedMesh::inside(std::span<const Ray> rays) const {
  const auto ask = [&](std::span<const double> x, std::span<Told<int>> told) {
    std::vector<int> answers(told.size());
    calls_->inside(x, answers);
    for (std::size_t i = 0; i < told.size(); ++i) told[i].answer = answers[i];
  };
  return told<int>("inside", rays, ask, wrong_answer);
}

std::string PreparedMesh::wrong_face(std::size_t face) const {
  if (face < face_count_) return "";
  return "said face " + std::to_string(face) + ", expected one of " + std::to_string(face_count_) + ", from 0";
}

MeshPlugin mesh_plugin(const tribunal_plugin& plugin, const tribunal_mesh_plugin& meshes, const std::string& file,
                       PrepareMesh prepare) {
  if (meshes.prepare == nullptr) throw bad_input(file, 0, "prepare of meshes is NULL, expected a function");
  const Method method = described(plugin, file);
  MeshPlugin made{method.name, file, method.contract, meshes, std::move(prepare)};
  if (!made.has_closest() && meshes.any == nullptr && meshes.all == nullptr && meshes.inside == nullptr) {
    throw bad_input(file, 0, "closest, any, all and inside of meshes are NULL, expected one function at least");
  }
  const auto require_promise = [&](double promise, const char* field) {
    if (promise >= 0 && std::isfinite(promise)) return;
    throw bad_input(file, 0, std::string(field) + " of meshes is " + std::to_string(promise) + ", expected 0 or more");
  };
  require_promise(meshes.most_ulps, "most_ulps");
  require_promise(meshes.most_degrees, "most_degrees");
  if (meshes.closest_normal == nullptr && (meshes.tells_normal != 0 || meshes.tells_side != 0)) {
    throw bad_input(file, 0, "closest_normal of meshes is NULL, expected a function that tells normal or side");
  }
  if (meshes.normal_sense != TRIBUNAL_NORMAL_BY_VERTICES && meshes.normal_sense != TRIBUNAL_NORMAL_TOWARDS_SOURCE) {
    throw bad_input(file, 0,
                    "normal_sense of meshes is " + std::to_string(meshes.normal_sense) +
                        ", expected TRIBUNAL_NORMAL_BY_VERTICES or TRIBUNAL_NORMAL_TOWARDS_SOURCE");
  }
  return made;
}

PreparedMesh prepare(const MeshPlugin& plugin, std::span<const Point3> vertices, std::span<const std::size_t> corners) {
  try {
    return {plugin.prepare(coordinates_of(vertices), corners), plugin.file, corners.size() / 3};
  } catch (const CallFailed& failed) {
    const bool no_memory = failed.fault.kind == Status::gave_no_answer;
    if (no_memory) throw Failure(Exit::resources, plugin.file + ": prepare of a mesh " + failed.fault.detail);
    throw failure_of(failed.fault, plugin.file, "prepare");
  }
}

}  // namespace tribunal
