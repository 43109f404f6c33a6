// What `leak` and `judge --mesh`, and `render --against` write must look like.
#include <string>

#include "exact/report/shapes.h"

namespace tribunal {
namespace {

using namespace shape;

// --- a mesh trial ---------------------------------------------------------------------------------------------------

/// Rays, and of these those with each outcome; for parity, of those that were judged for it.
void require_tally(const Record& tally, std::uint64_t rays, const char* of) {
  require_part(tally, tally.count("rays"), rays, of);
  for (const auto& [key, n] : tally.members()) {
    const bool parity = key == "parity" && tally.has("parity_judged");
    require_part(tally, n.count(), parity ? tally.count("parity_judged") : tally.count("rays"), key.c_str());
  }
}

Check tally() {
  return [](const Record& r) {
    r.count("rays");
    named(count())(r);
  };
}

Check worst_face() { return object({needed("face", count()), needed("leaks", count()), if_there("tri", triangle())}); }

Check subject() {
  return object({needed("name", name()), needed("all", tally()), if_there("judged", text()),
                 if_there("by_aim", named(tally())), if_there("worst_faces", list(worst_face())),
                 if_there("worst_t_ulps", number(0, 1e300)), if_there("worst_normal_degrees", number(0, 180)),
                 if_there("faults", named(count()))});
}

void require_subject(const Record& subject, const Record& trial) {
  const Record all = subject.member("all");
  require_tally(all, trial.count("rays"), "rays");
  std::uint64_t aimed = 0;
  if (const auto aims = subject.find("by_aim")) {
    for (const auto& [aim, one] : aims->members()) {
      require_tally(one, all.count("rays") - aimed, "rays of all aims");
      aimed += one.count("rays");
      for (const auto& [key, n] : one.members()) {
        if (all.has(key)) require_part(one, n.count(), all.count(key), key.c_str());
      }
    }
  }
  for (const Record& face : subject.items_or_none("worst_faces")) {
    if (trial.has("faces") && face.count("face") >= trial.count("faces")) face.fail_at("face", "is none of the mesh");
    require_part(face, face.count("leaks"), all.count_or("leak", 0), "leaks");
  }
  if (const auto faults = subject.find("faults")) {
    for (const auto& [fault, rays] : faults->members())
      require_part(subject, rays.count(), all.count("rays"), "faults");
  }
}

Check trial() {
  return object({needed("fmt", format()), needed("rays", count()), needed("subjects", list(subject())),
                 if_there("topology", text()), if_there("closed", truth()),
                 needed("faces", count(std::uint64_t{1} << 32)), if_there("from_inside", count()),
                 if_there("exactly_through_edges_or_vertices", count()), if_there("skipped", count())},
                [](const Record& r) {
                  const std::uint64_t rays = r.count("rays");
                  for (const char* key : {"from_inside", "exactly_through_edges_or_vertices"}) {
                    require_part(r, r.count_or(key, 0), rays, key);
                  }
                  for (const Record& one : r.items("subjects")) require_subject(one, r);
                });
}

// --- pictures -------------------------------------------------------------------------------------------------------

constexpr std::uint64_t most_side = std::uint64_t{1} << 24;

Check pixel() {
  return object({needed("x", count(most_side)), needed("y", count(most_side)), if_there("colour", truth()),
                 if_there("parted_on", text()), needed("why", word({"face", "order", "start", "unexamined"})),
                 if_there("case", text()), if_there("wrong", list(text()))});
}

/// Nothing that is said of the pixels that differ is about more of them than there are.
void require_difference(const Record& difference, std::size_t pixels) {
  if (difference.has("pixels") && difference.count("pixels") != pixels) {
    difference.fail_at("pixels", "expected " + std::to_string(pixels) + ", those listed");
  }
  for (const auto& [key, value] : difference.members()) {
    if (key == "method" || key == "against" || key == "pixels" || key == "parted_on") continue;
    if (value.json().is_number()) require_part(difference, value.count(), pixels, key.c_str());
  }
  if (const auto kinds = difference.find("parted_on")) require_part(difference, sum_of(*kinds), pixels, "parted_on");
}

Check difference() {
  return object({needed("method", name()), needed("against", name()), if_there("pixels", count()),
                 if_there("pixels_of_other_colour", count()), if_there("examined", count()),
                 if_there("parted_on", named(count())), if_there("parted_on_visibility", count()),
                 if_there("parted_on_shadow", count()), if_there("parted_on_secondary", count()),
                 if_there("parted_on_order_only", count()), if_there("parted_on_start_only", count()),
                 if_there("cases", count())});
}

Check solid() {
  return named(either({text(), truth(), count()}, "a text, true or false, or a whole number, 0 or more"));
}

/// Work that was done: counts, and groups of counts.
Check work() {
  const Check figure = either({count(), text()}, "a whole number, 0 or more");
  const Check ray_kind = object({needed("cast", count()), needed("hit", count())},
                                [](const Record& r) { require_part(r, r.count("hit"), r.count("cast"), "hit"); });
  return object({needed("method", name()), if_there("rays", named(ray_kind)), if_there("box_tests", count()),
                 if_there("triangle_tests", count()), if_there("triangle_hits", count()),
                 if_there("polygon_tests", count()), if_there("polygon_hits", count()), if_there("hit_share", share()),
                 if_there("answers_by_stage", named(count())), if_there("points_computed", count()),
                 if_there("starts", named(figure))});
}

void require_pixels(const Record& r) {
  const std::uint64_t width = r.count("width"), height = r.count("height");
  const std::vector<Record> pixels = r.items("pixels");
  require_part(r, pixels.size(), width * height, "pixels");
  for (const Record& p : pixels) {
    if (p.count("x") >= width) p.fail_at("x", "expected less than the width");
    if (p.count("y") >= height) p.fail_at("y", "expected less than the height");
  }
  require_difference(r.member("difference"), pixels.size());
}

}  // namespace

void require_leak_record(const Record& record) {
  static const Check shape =
      object({needed("trials", list(trial())), if_there("mesh", text()), if_there("seed", whole()),
              if_there("command", command()), if_there("environment", environment())});
  shape(record);
}

void require_render_record(const Record& record) {
  static const Check option = either({text(), truth(), number(-1e300, 1e300)}, "a text, a number, true or false");
  static const Check shape =
      object({needed("width", count(most_side)), needed("height", count(most_side)), needed("difference", difference()),
              needed("pixels", list(pixel())), needed("files", named(text())), if_there("scene", text()),
              if_there("fmt", format()), if_there("accel", word({"none", "boxes", "bvh"})),
              if_there("depth", count(1000)), if_there("triangles", count()), if_there("polygons", count()),
              if_there("solids", list(solid())), if_there("methods", list(work())),
              if_there("options", named(null_or(option))), if_there("environment", environment())},
             require_pixels);
  shape(record);
}

}  // namespace tribunal
