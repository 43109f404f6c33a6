#include "tracer/render/compare.h"

#include <algorithm>

#include "exact/methods/methods.h"
#include "exact/record/counterexample.h"
#include "exact/trial/fuzz.h"
#include "exact/trial/judge.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

constexpr Pixel magenta = {255, 0, 200};
constexpr Pixel yellow = {255, 220, 0};

std::vector<Decision> decisions_at(const World& world, const Method& method, const DifferingPixel& pixel, int depth) {
  std::vector<Decision> log;
  RayTally uncounted;
  WhittedTracer tracer(world, method, uncounted, &log);
  tracer.trace(CameraRays(world.scene->camera).through(pixel.column, pixel.row), depth);
  return log;
}

/// The faces on which the methods may differ: first those that either reported as hit, since a wrong hit is the
/// better evidence, then all that the acceleration offers.
std::vector<std::uint32_t> suspects(const World& world, const Decision& a, const Decision& b) {
  std::vector<std::uint32_t> ids;
  if (a.kind != RayKind::shadow) {
    for (const Decision* d : {&a, &b}) {
      if (d->outcome >= 0) ids.push_back(static_cast<std::uint32_t>(d->outcome));
    }
  }
  const std::vector<std::uint32_t> all = candidates(world, a.probe);
  ids.insert(ids.end(), all.begin(), all.end());
  return ids;
}

bool same(const Decision& a, const Decision& b) {
  if (a.kind != b.kind || a.probe.index() != b.probe.index()) return false;
  if (const Ray* r = std::get_if<Ray>(&a.probe)) {
    return r->o == std::get<Ray>(b.probe).o && r->d.v == std::get<Ray>(b.probe).d.v;
  }
  return std::get<Segment>(a.probe).p == std::get<Segment>(b.probe).p;
}

std::string id_of(const DifferingPixel& pixel, const Parting& parting, bool polygon) {
  return "px-" + std::to_string(pixel.column) + "-" + std::to_string(pixel.row) + "-" +
         std::string(name_of(parting.kind)) + (polygon ? "-face" : "-tri") + std::to_string(*parting.face);
}

std::string source_of(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
                      const Parting& parting) {
  return world.scene->file + ", pixel " + std::to_string(pixel.column) + "," + std::to_string(pixel.row) + ", " +
         std::string(name_of(parting.kind)) + " ray, solid \"" +
         world.scene->solids[world.solid_of[*parting.face]].name + "\": " + a.name + " against " + b.name;
}

/// The case with the exact answer, and with a finding of a method whose wrong answer shows.
Case judged(Case c, const Method& a, const Method& b) {
  const Truth truth = exact_truth(c.query);
  c.expect = truth.hit();
  for (const Method* m : {&a, &b}) {
    const Answer answer = m->ask(c.query);
    if (is_wrong(judge(*m, truth, answer)) && shows_wrong_answer(*m, c.query)) {
      c = with_finding(std::move(c), *m, truth, answer);
    }
  }
  return c;
}

}  // namespace

std::vector<DifferingPixel> differing_pixels(const Rendering& a, const Rendering& b) {
  std::vector<DifferingPixel> pixels;
  for (std::size_t i = 0; i < a.decisions.size(); ++i) {
    if (a.decisions[i] == b.decisions[i]) continue;
    const auto width = static_cast<std::size_t>(a.image.width);
    pixels.push_back(
        {static_cast<int>(i % width), static_cast<int>(i / width), a.image.pixels[i] != b.image.pixels[i]});
  }
  return pixels;
}

Image difference_image(const Image& image, const std::vector<DifferingPixel>& pixels) {
  Image marked = dimmed(image);
  for (const DifferingPixel& p : pixels) {
    marked.pixels[static_cast<std::size_t>(p.row) * static_cast<std::size_t>(image.width) +
                  static_cast<std::size_t>(p.column)] = p.colour_differs ? magenta : yellow;
  }
  return marked;
}

std::optional<Parting> parting_at(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
                                  int depth) {
  const std::vector<Decision> of_a = decisions_at(world, a, pixel, depth);
  const std::vector<Decision> of_b = decisions_at(world, b, pixel, depth);
  RayTally uncounted;
  const Visibility eye_a(world, a, uncounted), eye_b(world, b, uncounted);
  for (std::size_t i = 0; i < std::min(of_a.size(), of_b.size()); ++i) {
    if (of_a[i].outcome == of_b[i].outcome && of_a[i].kind == of_b[i].kind) continue;
    Parting parting{of_a[i].kind, of_a[i].probe, std::nullopt, !same(of_a[i], of_b[i])};
    for (const std::uint32_t id : suspects(world, of_a[i], of_b[i])) {
      if (eye_a.sees(parting.probe, id) == eye_b.sees(parting.probe, id)) continue;
      parting.face = id;
      break;
    }
    return parting;
  }
  return std::nullopt;
}

bool shows_wrong_answer(const Method& method, const Query& query) {
  const Answer answer = method.ask(query), exact = reference_method().ask(query);
  if (is_hit_in_picture(query.probe, answer) == is_hit_in_picture(query.probe, exact)) return false;
  const Outcome outcome = judge(method, exact_truth(query), answer);
  const bool other_end = is_visible_hit(answer) && is_visible_hit(exact) && answer.at != At::unsaid;
  return is_wrong(outcome) || (outcome == Outcome::right && other_end);
}

Case to_case(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
             const Parting& parting) {
  const PolygonData* const polygon = world.polygon(*parting.face);
  const Target face = polygon != nullptr ? Target(*polygon) : Target(world.triangles[*parting.face]);
  return judged({.id = id_of(pixel, parting, polygon != nullptr),
                 .format = world.format,
                 .query = {parting.probe, face},
                 .source = source_of(world, a, b, pixel, parting)},
                a, b);
}

}  // namespace tribunal
