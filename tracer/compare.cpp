#include "tracer/compare.h"

#include <algorithm>

#include "exact/harness/counterexample.h"
#include "exact/methods.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

constexpr Pixel magenta = {255, 0, 200};
constexpr Pixel yellow = {255, 220, 0};

std::vector<Decision> decisions_at(const World& world, const Method& method, const DifferingPixel& pixel, int depth) {
  std::vector<Decision> log;
  Tally uncounted;
  WhittedTracer tracer(world, method, uncounted, &log);
  tracer.trace(CameraRays(world.scene->camera).through(pixel.column, pixel.row), depth);
  return log;
}

/// The triangles that either method named first, then all that the tree offers: a wrong hit is the better evidence.
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

/// Up to the first different outcome both logs hold the same questions, since all else is shared arithmetic.
std::optional<Parting> parting_at(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
                                  int depth) {
  const std::vector<Decision> of_a = decisions_at(world, a, pixel, depth);
  const std::vector<Decision> of_b = decisions_at(world, b, pixel, depth);
  for (std::size_t i = 0; i < std::min(of_a.size(), of_b.size()); ++i) {
    if (of_a[i].outcome == of_b[i].outcome) continue;
    Parting parting{of_a[i].kind, of_a[i].probe, std::nullopt};
    for (const std::uint32_t id : suspects(world, of_a[i], of_b[i])) {
      const Triangle& t = world.triangles[id];
      if (sees(a, parting.probe, t) == sees(b, parting.probe, t)) continue;
      parting.triangle = id;
      break;
    }
    return parting;
  }
  return std::nullopt;
}

Case to_case(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
             const Parting& parting) {
  const std::string place = std::to_string(pixel.column) + "-" + std::to_string(pixel.row);
  Case c;
  c.id = "px-" + place + "-" + std::string(name_of(parting.kind)) + "-tri" + std::to_string(*parting.triangle);
  c.format = world.format;
  c.query = {parting.probe, world.triangles[*parting.triangle]};
  const Truth truth = exact_truth(c.query);
  c.expect = truth.hit();
  for (const Method* m : {&a, &b}) {
    const Answer answer = m->ask(c.query);
    if (judge(*m, truth, answer) == Judgement::wrong) c.finding = finding_of(*m, c.query, c.format, truth, answer);
  }
  c.source = world.scene->file + ", pixel " + std::to_string(pixel.column) + "," + std::to_string(pixel.row) + ", " +
             std::string(name_of(parting.kind)) + " ray, solid \"" +
             world.scene->solids[world.solid_of[*parting.triangle]].name + "\": " + a.name + " against " + b.name;
  return c;
}

}  // namespace tribunal
