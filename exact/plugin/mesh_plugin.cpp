#include "exact/plugin/mesh_plugin.h"

#include <cmath>
#include <exception>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/fp_environment.h"
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

/// What the call returns, if it keeps the promises of tribunal_plugin.h.
template <class Call>
auto guarded(const std::string& file, const char* function, const Call& call) {
  const auto fail = [&](Exit exit, const std::string& what) {
    require_exact_rounding();
    return Failure(exit, file + ": " + function + " of a mesh " + what);
  };
  const auto returned = [&] {
    try {
      return call();
    } catch (const std::exception& error) {
      throw fail(Exit::disagreement, std::string("threw ") + error.what());
    } catch (...) {
      throw fail(Exit::disagreement, "threw an exception of its own");
    }
  }();
  if (!has_exact_rounding()) throw fail(Exit::fp_environment, "changed the rounding mode or flushes to zero");
  return returned;
}

/// The same of a function that returns nothing.
template <class Call>
void guarded_void(const std::string& file, const char* function, const Call& call) {
  guarded(file, function, [&] {
    call();
    return 0;
  });
}

}  // namespace

PreparedMesh::PreparedMesh(const tribunal_mesh_plugin& plugin, std::string file, std::span<const Point3> vertices,
                           std::span<const std::size_t> corners)
    : plugin_(plugin), file_(std::move(file)), face_count_(corners.size() / 3) {
  const std::vector<double> x = coordinates_of(vertices);
  void* const made = guarded(file_, "prepare",
                             [&] { return plugin_.prepare(vertices.size(), x.data(), face_count_, corners.data()); });
  if (made == nullptr) throw Failure(Exit::resources, file_ + ": prepare of a mesh returned NULL");
  mesh_ = std::shared_ptr<void>(made, [release = plugin_.release](void* p) {
    if (release != nullptr) release(p);
  });
}

std::vector<tribunal_mesh_hit> PreparedMesh::closest(std::span<const Ray> rays) const {
  const std::vector<double> x = coordinates_of(rays);
  std::vector<tribunal_mesh_hit> hits(rays.size(), {face_count_, 0});  // no face has this number
  guarded_void(file_, "closest", [&] { plugin_.closest(mesh_.get(), rays.size(), x.data(), hits.data()); });
  for (const tribunal_mesh_hit& hit : hits) {
    if (hit.face != TRIBUNAL_NO_FACE) require_face("closest", hit.face);
  }
  return hits;
}

std::vector<tribunal_mesh_hit> PreparedMesh::all(const Ray& ray) const {
  const std::vector<double> x = coordinates_of({&ray, 1});
  std::vector<tribunal_mesh_hit> hits(16, {face_count_, 0});
  const auto ask = [&] {
    return guarded(file_, "all", [&] { return plugin_.all(mesh_.get(), x.data(), hits.size(), hits.data()); });
  };
  std::size_t count = ask();
  if (count > 64 * (face_count_ + 1)) {
    throw bad_input(
        file_, 0,
        "all of a mesh returned " + std::to_string(count) + " hits of " + std::to_string(face_count_) + " faces");
  }
  if (count > hits.size()) {
    hits.assign(count, {face_count_, 0});
    count = ask();
    if (count != hits.size()) throw bad_input(file_, 0, "all of a mesh found another number of hits when asked again");
  }
  hits.resize(count);
  for (const tribunal_mesh_hit& hit : hits) require_face("all", hit.face);
  return hits;
}

std::vector<int> PreparedMesh::any(std::span<const Ray> rays) const {
  const std::vector<double> x = coordinates_of(rays);
  std::vector<int> answers(rays.size(), -1);
  guarded_void(file_, "any", [&] { plugin_.any(mesh_.get(), rays.size(), x.data(), answers.data()); });
  require_answers("any", answers);
  return answers;
}

std::vector<int> PreparedMesh::inside(std::span<const Ray> rays) const {
  const std::vector<double> x = coordinates_of(rays);
  std::vector<int> answers(rays.size(), -1);
  guarded_void(file_, "inside", [&] { plugin_.inside(mesh_.get(), rays.size(), x.data(), answers.data()); });
  require_answers("inside", answers);
  return answers;
}

void PreparedMesh::require_face(const char* function, std::size_t face) const {
  if (face < face_count_) return;
  throw bad_input(file_, 0,
                  std::string(function) + " of a mesh said face " + std::to_string(face) + ", expected one of " +
                      std::to_string(face_count_) + ", from 0");
}

void PreparedMesh::require_answers(const char* function, const std::vector<int>& answers) const {
  for (const int answer : answers) {
    if (answer == 0 || answer == 1) continue;
    throw bad_input(file_, 0,
                    std::string(function) + " of a mesh answered " + std::to_string(answer) + ", expected 0 or 1");
  }
}

MeshPlugin mesh_plugin(const tribunal_plugin& plugin, const tribunal_mesh_plugin& meshes, const std::string& file) {
  require_version(meshes.abi, file);
  if (meshes.prepare == nullptr) throw bad_input(file, 0, "prepare of meshes is NULL, expected a function");
  if (meshes.closest == nullptr && meshes.any == nullptr && meshes.all == nullptr && meshes.inside == nullptr) {
    throw bad_input(file, 0, "closest, any, all and inside of meshes are NULL, expected one function at least");
  }
  if (!(meshes.most_ulps >= 0 && std::isfinite(meshes.most_ulps))) {
    throw bad_input(file, 0, "most_ulps of meshes is " + std::to_string(meshes.most_ulps) + ", expected 0 or more");
  }
  const Method method = described(plugin, file);
  return {method.name, file, method.contract, meshes};
}

}  // namespace tribunal
