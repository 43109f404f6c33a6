#include "tracer/sweep/afar.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/cases/families/shapes.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/torus.h"
#include "exact/mesh/triangulate.h"
#include "exact/trial/judge.h"
#include "exact/trial/quick_truth.h"
#include "exact/trial/severity.h"
#include "tracer/leak/judge.h"
#include "tracer/leak/ray_files.h"

namespace tribunal {
namespace {

using namespace leak;

constexpr Format formats[] = {Format::binary32, Format::binary64};
constexpr std::size_t block_size = 128;

/// Up to where 16 units in the last place of the source are a tenth of the mesh.
constexpr int distances_64[] = {0, 1, 2, 3, 4, 6, 8, 11, 14, 17, 20, 24, 28, 32, 36, 40, 43, 45};
constexpr int distances_32[] = {0, 1, 2, 3, 4, 6, 8, 10, 12, 14, 16};

std::span<const int> distances(Format format) {
  if (format == Format::binary32) return distances_32;
  return distances_64;
}

/// The axis and what its figures say, which it refers to.
struct Described {
  std::string population;
  StressAxis axis;
};

std::shared_ptr<const StressAxis> described(const std::string& mesh, std::size_t faces) {
  const auto d = std::make_shared<Described>();
  d->population = "rays at the vertices, edges and faces in turn of " + mesh + " (" + std::to_string(faces) +
                  " triangles), from outside: as exactly as coordinates allow, and units in the last place beside it";
  d->axis = {.name = afar_name,
             .quantity = afar_quantity,
             .population = d->population,
             .probes = AxisProbes::rays,
             .easiest = zero,
             .values = distances,
             .stream = 0};
  return {d, &d->axis};
}

// --- one ray --------------------------------------------------------------------------------------------------------

struct Shown {
  leak::Outcome as_leak;
  SweptOutcome as_swept;
};

/// The errors that are counted. `lost` is a leak too; the others are about which hit is closest.
constexpr Shown counted[] = {{leak::Outcome::false_hit, SweptOutcome::false_hit},
                             {leak::Outcome::fault, SweptOutcome::fault},
                             {leak::Outcome::leak, SweptOutcome::leak},
                             {leak::Outcome::double_hit, SweptOutcome::double_hit},
                             {leak::Outcome::parity, SweptOutcome::parity}};

/// How hard the hardest of the faces is that the ray may be taken to meet: which of them made the answer wrong is not
/// known. Where it passes an edge within rounding, it is not in general position, however well-conditioned the volumes
/// of rounded differences are.
Severity severity_of_ray(const Surface& surface, const AskedRay& asked, const RayTruth& truth) {
  const bool is_near = std::ranges::any_of(truth.passages, [](const Passage& p) { return p.faces.size() > 1; });
  Severity hardest = is_near ? Severity::boundary : Severity::plain;
  for (const std::uint32_t face : asked.candidates) {
    const Query query{asked.ray, surface.triangle(face)};
    // Whether a case is extreme, its coordinates say alone; no more is asked where the answer is boundary at least.
    const Truth exact = is_near ? Truth{} : truth_in_class(certified_class(query), query);
    hardest = std::max(hardest, severity_of(query, exact));
    if (hardest == Severity::extreme) break;
  }
  return hardest;
}

/// Adds what one method said of a ray.
void add(Sweep& part, const SweepPlace& place, const AskedRay& asked, const RayTruth& truth, const Surface& surface,
         const Verdict& v) {
  MeshAnswer answer{.parity_judged = v.parity_judged};
  std::optional<Severity> severity;
  for (const Shown& s : counted) {
    if (!v.outcomes.has(s.as_leak)) continue;
    if (!severity) severity = severity_of_ray(surface, asked, truth);
    answer[s.as_swept] = severity;
    part.note(place, s.as_swept, {asked.k, {asked.ray, surface.triangle(*v.shown_by(s.as_leak))}, Status::ok});
  }
  part.counts[place].add(answer);
}

// --- many rays ------------------------------------------------------------------------------------------------------

/// Everything that is asked in one format.
struct Asked {
  const SweepPlan& plan;
  std::size_t axis;
  Surface surface;
  std::vector<std::size_t> methods{};  ///< of the plan
  std::vector<Subject> subjects{};     ///< in the same order
};

/// Boxes wider than their faces by 2048 unit roundoffs of the largest number that occurs, as a mesh trial has them: by
/// far more than a test may round.
FaceBoxes boxes_seen_from(const Surface& surface, int distance) {
  const Box& box = surface.bounds();
  const Point3 extent = box.hi - box.lo;
  double most = std::max({extent.x, extent.y, extent.z}) * std::ldexp(1.0, distance);
  for (int axis = 0; axis < 3; ++axis) most = std::max({most, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
  return {surface.triangles(), most * std::ldexp(2048.0, -digits_of(surface.format()))};
}

void ask_block(const Asked& asked, int distance, const FaceBoxes& boxes, std::size_t block, Sweep& part) {
  const std::uint64_t end = std::min<std::uint64_t>((block + 1) * block_size, asked.plan.cases);
  for (std::uint64_t k = block * block_size; k < end; ++k) {
    const std::optional<AimedRay> aimed = aimed_ray_from_afar(asked.surface, distance, asked.plan.seed, k);
    if (!aimed) continue;
    AskedRay ray{k, aimed->ray, {}};
    boxes.candidates(BoxProbe(aimed->ray), ray.candidates);
    const RayTruth truth = truth_of(asked.surface, *aimed, ray.candidates);
    if (truth.on_surface) continue;
    for (std::size_t i = 0; i < asked.subjects.size(); ++i) {
      Testimony said;
      asked.subjects[i].ask({&ray, 1}, {&said, 1});
      const SweepPlace place{asked.methods[i], asked.axis, asked.surface.format(), distance, ProbeKind::ray};
      add(part, place, ray, truth, asked.surface, judge(asked.surface, asked.subjects[i], *aimed, truth, said));
    }
  }
}

void ask_at(const Asked& asked, int distance, Progress& progress, Sweep& result) {
  const FaceBoxes boxes = boxes_seen_from(asked.surface, distance);
  const std::size_t blocks = (asked.plan.cases + block_size - 1) / block_size;
  std::mutex guard;
  const std::size_t done = run_blocks(blocks, asked.plan.threads, [&](std::size_t block, unsigned) {
    Sweep part;
    ask_block(asked, distance, boxes, block, part);
    progress.add(block_size);
    const std::scoped_lock lock(guard);
    result += part;
  });
  if (done < blocks) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no record written");
}

void run(const Mesh& mesh, const std::string& name, const SweepPlan& plan, std::size_t axis, Sweep& result) {
  for (const Format format : formats) {
    Asked asked{plan, axis, Surface(mesh, format, name)};
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      const Method& method = plan.methods[m];
      if (!takes(method, *plan.axes[axis]) || !takes(method, format)) continue;
      asked.methods.push_back(m);
      asked.subjects.push_back(subject_of(method, asked.surface));
    }
    if (asked.methods.empty()) continue;
    const std::span<const int> values = distances(format);
    Progress progress("sweep afar " + std::string(name_of(format)), "rays", plan.cases * values.size());
    for (const int distance : values) ask_at(asked, distance, progress, result);
  }
}

}  // namespace

MeshAxis afar_axis(Mesh mesh, const std::string& name) {
  std::string off;
  for (const Format format : formats) {
    const Surface surface(mesh, format, name);
    if (!surface.topology().closed()) throw bad_input(name, 0, "is not closed, expected a mesh that has an inside");
    const Point3 extent = surface.bounds().hi - surface.bounds().lo;
    const double farthest = std::ldexp(std::max({extent.x, extent.y, extent.z}), distances(format).back() + 1);
    if (!is_finite(in_format(Point3(farthest), format))) {
      throw bad_input(name, 0,
                      "is too large to be seen from afar, expected sources within " + std::string(name_of(format)));
    }
    off = to_off(surface);
  }
  const auto axis = described(name, mesh.triangles.size());
  const auto shared = std::make_shared<const Mesh>(std::move(mesh));
  return {.axis = axis,
          .run = [shared, name](const SweepPlan& plan, std::size_t a,
                                Sweep& result) { tribunal::run(*shared, name, plan, a, result); },
          .off = std::move(off)};
}

MeshAxis afar_axis_of_file(const std::string& file) {
  if (file.empty()) return afar_axis(torus(8, 4), "a torus");
  return afar_axis(triangulated(read_mesh(file), file), std::filesystem::path(file).filename().string());
}

}  // namespace tribunal
