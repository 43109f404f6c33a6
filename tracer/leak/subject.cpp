#include "tracer/leak/subject.h"

#include <algorithm>
#include <utility>

#include "exact/trial/observe.h"

namespace tribunal::leak {
namespace {

/// A method and the surface whose faces it is asked about.
class FaceByFace {
 public:
  FaceByFace(Method method, const Surface& surface) : method_(std::move(method)), surface_(surface) {}

  bool counts_faces() const { return method_.contract.boundary == Boundary::half_open; }
  bool tells_t() const { return method_.parameter != nullptr; }
  bool has_order() const { return method_.compare_hits != nullptr; }
  bool tells_order() const { return has_order() || tells_t(); }

  Testimony ask(const AskedRay& asked) const {
    std::vector<Reported> hits = hits_of(asked);
    Testimony said;
    if (tells_order()) said.closest = closest_of(asked.ray, hits);
    if (counts_faces()) said.inside = hits.size() % 2 == 1;
    if (!counts_faces() && tells_order()) said.inside = different_hits(asked.ray, hits) % 2 == 1;
    said.hits = std::move(hits);
    return said;
  }

 private:
  std::vector<Reported> hits_of(const AskedRay& asked) const {
    std::vector<Reported> hits;
    for (const std::uint32_t f : asked.candidates) {
      const Triangle& t = surface_.triangle(f);
      if (method_.contract.triangles == Triangles::proper && surface_.is_flat(f)) continue;
      const Answer answer = ask_or_fail(method_, {asked.ray, t});
      if (!answer.hit) continue;
      const std::optional<double> at = tells_t() ? method_.parameter(asked.ray, t) : std::nullopt;
      hits.push_back({f, at, answer.contact == Contact::coplanar || (tells_t() && !at)});
    }
    return hits;
  }

  /// The sign of the t of a minus the t of b.
  Sign compare(const Ray& ray, const Reported& a, const Reported& b) const {
    if (!has_order()) return sign_of(*a.t - *b.t);
    return method_.compare_hits(ray, surface_.triangle(a.face), surface_.triangle(b.face));
  }

  /// The closest of the hits; hits in the plane of their face have no single t and are left out.
  std::optional<Reported> closest_of(const Ray& ray, const std::vector<Reported>& hits) const {
    const Reported* best = nullptr;
    for (const Reported& hit : hits) {
      if (hit.in_plane) continue;
      if (best == nullptr || compare(ray, hit, *best) == Sign::negative) best = &hit;
    }
    return best == nullptr ? std::nullopt : std::optional(*best);
  }

  std::size_t different_hits(const Ray& ray, const std::vector<Reported>& hits) const {
    std::vector<Reported> different;
    for (const Reported& hit : hits) {
      const auto is_same = [&](const Reported& other) { return compare(ray, hit, other) == Sign::zero; };
      if (!hit.in_plane && std::ranges::none_of(different, is_same)) different.push_back(hit);
    }
    return different.size();
  }

  Method method_;
  const Surface& surface_;
};

std::string what_is_told(const FaceByFace& m) {
  std::string text = "asked face by face";
  if (m.tells_order()) text += m.has_order() ? "; closest by its order of hits" : "; closest by t";
  if (m.counts_faces()) return text + "; parity of the number of faces";
  if (!m.tells_order()) return text + "; no parity: it tells no order of hits";
  return text +
         (m.has_order() ? "; parity of the hits that its order tells apart" : "; parity of the number of different t");
}

}  // namespace

Subject subject_of(const Method& method, const Surface& surface) {
  const FaceByFace faces(method, surface);
  return {.name = method.name,
          .contract = method.contract,
          .told = what_is_told(faces),
          .tells_parity = faces.counts_faces() || faces.tells_order(),
          .tells_closest = faces.tells_order(),
          .parity_where_touching = faces.counts_faces(),
          .ask = [faces](std::span<const AskedRay> asked, std::span<Testimony> said) {
            for (std::size_t i = 0; i < asked.size(); ++i) said[i] = faces.ask(asked[i]);
          }};
}

}  // namespace tribunal::leak
