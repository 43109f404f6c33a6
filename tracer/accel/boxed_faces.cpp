#include "tracer/accel/boxed_faces.h"

namespace tribunal {

BoxedFaces::BoxedFaces(Accel mode, const FaceList& faces) {
  if (mode == Accel::bvh) {
    plant_tree(faces);
    return;
  }
  list_.assign(faces.triangles.begin(), faces.triangles.end());
  if (mode == Accel::boxes) box_solids(faces);
}

Triangle BoxedFaces::operator[](std::uint32_t id) const {
  if (tree_.empty()) return list_[id];
  const Place p = places_[id];
  return p.lane == in_list ? list_[p.leaf.bits()] : tree_.triangle(p);
}

void BoxedFaces::box_solids(const FaceList& faces) {
  boxed_ = true;
  for (std::uint32_t id = 0; id < list_.size(); ++id) {
    if (id == 0 || faces.solid_of[id] != faces.solid_of[id - 1]) solids_.push_back({Box(), id, id});
    solids_.back().box.add(faces.box(id));
    solids_.back().end = id + 1;
  }
}

void BoxedFaces::plant_tree(const FaceList& faces) {
  const auto count = static_cast<std::uint32_t>(faces.triangles.size());
  tree_ = WideTree(count, [&](std::uint32_t id) {
    Primitive p{faces.box(id), {}};
    if (faces.polygon_of[id] < 0) p.triangle = faces.triangles[id];
    return p;
  });
  places_.resize(count);
  tree_.for_each_place([&](Place p) { places_[tree_.id(p)] = p; });
  for (std::uint32_t id = 0; id < count; ++id) {
    if (faces.polygon_of[id] < 0) continue;
    places_[id] = {NodeRef(static_cast<std::uint32_t>(list_.size())), in_list};
    list_.push_back(faces.triangles[id]);
  }
}

void BoxedFaces::enter(const BoxProbe& probe, Waiting& waiting, RayTally& tally) const {
  waiting.clear();
  tally.box_tests += solids_.size();
  for (std::uint32_t solid = 0; solid < solids_.size(); ++solid) {
    const Span span = probe.span(solids_[solid].box);
    if (!span.empty()) waiting.emplace_back(span.first, solid);
  }
  std::sort(waiting.begin(), waiting.end());
}

std::size_t BoxedFaces::bytes() const {
  return list_.size() * sizeof(Triangle) + solids_.size() * sizeof(Solid) + tree_.bytes() +
         places_.size() * sizeof(Place);
}

}  // namespace tribunal
