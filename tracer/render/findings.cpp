#include "tracer/render/findings.h"

#include <algorithm>

#include "exact/base/json.h"

namespace tribunal {
namespace {

Why why_of(const Parting& parting) { return parting.face ? Why::face : parting.other_start ? Why::start : Why::order; }

/// Those of the two whose wrong answer to the case shows.
std::vector<std::string> wrong_on(const Case& c, const Method& a, const Method& b) {
  std::vector<std::string> names;
  for (const Method* m : {&a, &b}) {
    if (shows_wrong_answer(*m, c.query)) names.push_back(m->name);
  }
  return names;
}

/// Those whose order of hits is wrong where they part by order alone: it differs from an exact method's, and is the
/// method's own. The tracer orders the hits of methods that say nothing of where they are.
std::vector<std::string> wrong_in_order(const Method& a, const Method& b) {
  std::vector<std::string> names;
  for (const auto& [m, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const bool exact = other->contract.exact && other->compare_hits;
    if (exact && !m->contract.exact && (m->compare_hits || m->parameter)) names.push_back(m->name);
  }
  return names;
}

}  // namespace

std::string_view name_of(Why why) {
  constexpr std::string_view names[] = {"face", "order", "start", "unexamined"};
  return names[static_cast<int>(why)];
}

std::size_t Findings::count(Why why) const {
  return static_cast<std::size_t>(std::ranges::count(pixels, why, &ExaminedPixel::why));
}

Findings examine(const World& world, const Method& a, const Method& b, const std::vector<DifferingPixel>& pixels,
                 int depth, std::size_t max_cases) {
  Findings f;
  for (const DifferingPixel& pixel : pixels) {
    f.colours += pixel.colour_differs;
    ExaminedPixel& examined = f.pixels.emplace_back(ExaminedPixel{.pixel = pixel});
    if (f.cases.size() == max_cases) continue;
    const std::optional<Parting> parting = parting_at(world, a, b, pixel, depth);
    if (!parting) continue;
    ++f.by_kind[static_cast<std::size_t>(parting->kind)];
    examined.why = why_of(*parting);
    examined.kind = parting->kind;
    if (examined.why == Why::order) examined.wrong = wrong_in_order(a, b);
    if (!parting->face) continue;
    const Case& c = f.cases.emplace_back(to_case(world, a, b, pixel, *parting));
    examined.id = c.id;
    examined.wrong = wrong_on(c, a, b);
  }
  return f;
}

Json to_json(const Findings& f, const Method& a, const Method& b) {
  Json kinds;
  for (const RayKind k : all_ray_kinds) kinds[std::string(name_of(k))] = f.by_kind[static_cast<std::size_t>(k)];
  return {{"method", a.name},
          {"against", b.name},
          {"pixels", f.pixels.size()},
          {"pixels_of_other_colour", f.colours},
          {"examined", f.examined()},
          {"parted_on", kinds},
          {"parted_on_visibility", f.by_kind[0]},
          {"parted_on_shadow", f.by_kind[1]},
          {"parted_on_secondary", f.by_kind[2] + f.by_kind[3]},
          {"parted_on_order_only", f.count(Why::order)},
          {"parted_on_start_only", f.count(Why::start)},
          {"cases", f.cases.size()}};
}

Json pixels_json(const Findings& f) {
  Json all = Json::array();
  for (const ExaminedPixel& p : f.pixels) {
    Json row = {{"x", p.pixel.column}, {"y", p.pixel.row}, {"colour", p.pixel.colour_differs}};
    if (p.why != Why::unexamined) row["parted_on"] = name_of(p.kind);
    row["why"] = name_of(p.why);
    if (p.why == Why::face) row["case"] = p.id;
    if (p.why == Why::face || !p.wrong.empty()) row["wrong"] = p.wrong;
    all.push_back(std::move(row));
  }
  return all;
}

}  // namespace tribunal
