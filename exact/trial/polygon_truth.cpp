#include <cstdlib>
#include <type_traits>

#include "core/segura_feito_polygon.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/oracles/polygon_oracles.h"
#include "exact/trial/truth_rules.h"

namespace tribunal {
namespace {

bool is_boundary(Contact contact) { return contact == Contact::edge || contact == Contact::vertex; }

const char* said(bool hit) { return hit ? "hit" : "no hit"; }

void require_agreement(const Query& query, bool reference, const char* oracle, bool answer) {
  if (answer == reference) return;
  contradiction(query, std::string("the reference says ") + said(reference),
                std::string(oracle) + " says " + said(answer));
}

template <class P>
Truth truth_for(const P& probe, const Query& query) {
  const RationalKernel k;
  const Polygon polygon = query.polygon();
  const Answer prepared = segura_feito(probe, cover(polygon, k), k);
  Answer on_the_fly = segura_feito(probe, polygon, k);
  on_the_fly.planar = prepared.planar;  // without preparation planarity is not computed
  if (on_the_fly != prepared) contradiction(query, "the prepared covering", "that made on the fly");
  const PolygonVerdicts v = ask_oracles<Dyadic>(probe, polygon);
  if (prepared.planar != v.planar) contradiction(query, "planar by volumes", "by normal");
  const bool hit = prepared.hit;
  const bool in_plane = prepared.contact == Contact::coplanar;
  if (v.planar) require_agreement(query, hit, "a generic ray in the plane", v.boundary || v.by_generic_ray);
  if (v.planar) require_agreement(query, hit, "the half-open crossings", v.boundary || v.by_half_open_crossings);
  const bool crossed = std::abs(v.surface_halves) % 4 == 2;
  if (!in_plane) require_agreement(query, hit, "the covering surface", v.boundary || crossed);
  if (!in_plane && is_boundary(prepared.contact) != v.boundary) {
    contradiction(query, "the reference says " + std::string(name_of(prepared.contact)),
                  std::string("Caratheodory that ") + (v.boundary ? "a" : "no") + " ring edge is met");
  }
  return {.contact = prepared.contact,
          .planar = prepared.planar,
          .boundary = v.boundary,
          .of_ray = std::is_same_v<P, Ray>,
          .at = prepared.at};
}

}  // namespace

Truth exact_truth_of_polygon(const Query& query) {
  return std::visit([&](const auto& probe) { return truth_for(probe, query); }, query.probe);
}

}  // namespace tribunal
