#include "tracer/chart/pictures.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>

#include "exact/base/json.h"
#include "exact/chart/timing_json.h"
#include "exact/methods/methods.h"
#include "exact/trial/judge.h"
#include "tracer/leak/subject.h"
#include "tracer/render/compare.h"

namespace tribunal {
namespace {

/// A method whose first drawing of all scenes takes longer is not timed again.
constexpr double seconds_worth_repeating = 2;

std::uint64_t rays_of(const Rendering& r) {
  return std::accumulate(std::begin(r.tally.rays), std::end(r.tally.rays), std::uint64_t{0});
}

/// The tracer orders the hits of methods that say nothing of where they are.
bool orders_hits(const Method& m) { return m.compare_hits || m.parameter; }

PixelCause cause_at(const World& world, const Method& method, const DifferingPixel& pixel, int depth) {
  const std::optional<Parting> parting = parting_at(world, reference_method(), method, pixel, depth);
  if (!parting) return PixelCause::start;
  if (!parting->face) {
    if (parting->other_start) return PixelCause::start;
    return orders_hits(method) ? PixelCause::wrong : PixelCause::not_owed;
  }
  const Query query{parting->probe, world.triangles[*parting->face]};
  return shows_wrong_answer(method, query) ? PixelCause::wrong : PixelCause::not_owed;
}

/// All scenes in one format.
class Gallery {
 public:
  Gallery(const PicturePlan& plan, Format format) : plan_(plan), format_(format) {
    for (const Scene& scene : plan.scenes) {
      worlds_.push_back(make_world(scene, format, Accel::bvh, Faces::triangulated));
      truths_.push_back(render(worlds_.back(), reference_method(), {scene.depth, plan.threads}));
    }
  }

  /// The row of a method but for its time.
  PictureRow compared(std::size_t m) const {
    PictureRow row{.method = m, .format = format_};
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
      const int depth = plan_.scenes[i].depth;
      const Rendering drawn = render(worlds_[i], plan_.methods[m], {depth, plan_.threads});
      row.pixels += drawn.decisions.size();
      row.rays += rays_of(drawn);
      for (const DifferingPixel& pixel : differing_pixels(truths_[i], drawn)) {
        ++row.differing[static_cast<std::size_t>(cause_at(worlds_[i], plan_.methods[m], pixel, depth))];
      }
    }
    return row;
  }

  /// Seconds to draw all scenes on one thread.
  double seconds(std::size_t m) const {
    double sum = 0;
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
      sum += render(worlds_[i], plan_.methods[m], {plan_.scenes[i].depth, 1}).seconds;
    }
    return sum;
  }

 private:
  const PicturePlan& plan_;
  Format format_;
  std::vector<World> worlds_{};
  std::vector<Rendering> truths_{};
};

/// Each repetition draws with every method in turn, so that a change of the machine's speed meets all of them.
void time_rows(const PicturePlan& plan, const Gallery& gallery, std::span<PictureRow> rows) {
  std::vector<std::vector<double>> rates(rows.size());
  for (int repetition = 0; repetition < plan.repetitions; ++repetition) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double rays = static_cast<double>(rows[i].rays);
      if (repetition > 0 && rays / rates[i].front() > seconds_worth_repeating) continue;
      rates[i].push_back(rays / gallery.seconds(rows[i].method));
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].repetitions = static_cast<int>(rates[i].size());
    rows[i].rays_per_second = median_of(rates[i]);
  }
}

}  // namespace

std::vector<PictureRow> measure_pictures(const PicturePlan& plan) {
  std::vector<PictureRow> rows;
  for (const Format format : {Format::binary32, Format::binary64}) {
    const Gallery gallery(plan, format);
    const std::size_t first = rows.size();
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (leak::takes_rays(plan.methods[m]) && takes(plan.methods[m], format)) rows.push_back(gallery.compared(m));
    }
    time_rows(plan, gallery, std::span(rows).subspan(first));
  }
  return rows;
}

Json to_json(const PicturePlan& plan, const std::vector<PictureRow>& rows) {
  Json json = {{"scenes", Json::array()}, {"rows", Json::array()}};
  for (const Scene& s : plan.scenes) json["scenes"].push_back(std::filesystem::path(s.file).filename().string());
  for (const PictureRow& r : rows) {
    json["rows"].push_back({{"method", plan.methods[r.method].name},
                            {"fmt", name_of(r.format)},
                            {"pixels", r.pixels},
                            {"wrong", r.wrong()},
                            {"share", static_cast<double>(r.wrong()) / static_cast<double>(r.pixels)},
                            {"other_start", r.differing[static_cast<std::size_t>(PixelCause::start)]},
                            {"not_owed", r.differing[static_cast<std::size_t>(PixelCause::not_owed)]},
                            {"rays", r.rays},
                            {"repetitions", r.repetitions},
                            {"rays_per_second", median_json(r.rays_per_second)}});
  }
  return json;
}

std::string to_table(const PicturePlan& plan, const std::vector<PictureRow>& rows) {
  std::string text =
      "Scenes: wrong pixels of all (the same rays decided otherwise than exactly), and rays a second on one thread\n";
  char line[200];
  std::snprintf(line, sizeof line, "  %-22s %8s %12s %10s %12s %10s %12s\n", "method", "cases", "pixels", "wrong",
                "other start", "not owed", "rays/s");
  text += line;
  for (const PictureRow& r : rows) {
    std::snprintf(line, sizeof line, "  %-22s %8s %12llu %10llu %12llu %10llu %12.4g\n",
                  plan.methods[r.method].name.c_str(), std::string(name_of(r.format)).c_str(),
                  static_cast<unsigned long long>(r.pixels), static_cast<unsigned long long>(r.wrong()),
                  static_cast<unsigned long long>(r.differing[static_cast<std::size_t>(PixelCause::start)]),
                  static_cast<unsigned long long>(r.differing[static_cast<std::size_t>(PixelCause::not_owed)]),
                  r.rays_per_second.value);
    text += line;
  }
  return text + "\n";
}

}  // namespace tribunal
