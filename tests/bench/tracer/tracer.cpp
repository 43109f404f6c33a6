// Closest hits of sf-filtered in the tracer's tree against Embree 3 and CGAL's AABB tree, and whole frames against
// POV-Ray, all on one thread. `./run bench tracer` builds and runs it. Casters of one population are interleaved in
// random order, 15 times each; CPU time, since others may use the machine. The last lines are `ratio NAME VALUE`: our
// rays a second over theirs, of medians, with those of opposite quartiles in brackets.
//
// We trace rays one by one (`ours`) and many in a call (`ours_batch`), with equal answers. What the ratios are
// of: `embree_*`: ours one by one over Embree's rtcIntersect1, like with like; `aabb_*`: our batch over CGAL's tree,
// which has no such call; `embree_batch_*` our batch over Embree; `aabb_single_*` ours one by one over CGAL's tree.
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <deque>

#include "exact/filtered/batch.h"
#include "tests/bench/tracer/frames.h"
#include "tests/bench/tracer/peers.h"
#include "tests/bench/tracer/scenes.h"

namespace tribunal::bench {
namespace {

constexpr int side = 256;  ///< rays of a population: side²

struct CasterRow {
  std::string name;
  std::unique_ptr<Caster> (*make)(const Mesh&);
};

const CasterRow rows[] = {
    {"ours", make_ours}, {"ours_batch", make_ours_batch}, {"embree", make_embree}, {"aabb", make_aabb}};

struct Population {
  std::string name;
  std::vector<Ray> rays;
};

/// One mesh and all its casters.
struct Subject {
  std::string name;
  Mesh mesh;
  std::vector<std::unique_ptr<Caster>> casters{};
};

std::size_t heap() {
  const struct mallinfo2 info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::string named(const Subject& subject, const Population& population, const std::string& caster) {
  return population.name + "_" + subject.name + "/" + caster;
}

/// Builds all casters; prints what each keeps, in bytes a triangle, the mesh not counted.
void build(Subject& subject) {
  for (const CasterRow& row : rows) {
    const std::size_t before = heap();
    const std::clock_t start = std::clock();
    subject.casters.push_back(row.make(subject.mesh));
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const std::size_t known = subject.casters.back()->bytes(), bytes = known > 0 ? known : heap() - before;
    std::printf("%s/%s: %zu triangles, %.1f bytes a triangle, built in %.2f CPU seconds\n", subject.name.c_str(),
                row.name.c_str(), subject.mesh.triangles.size(),
                static_cast<double>(bytes) / static_cast<double>(subject.mesh.triangles.size()), seconds);
  }
}

std::vector<std::int64_t> answers(Caster& caster, const Population& population) {
  std::vector<std::int64_t> hits(population.rays.size());
  caster.first_hits(population.rays, hits);
  return hits;
}

/// Prints for each caster on how many rays its answers differ from ours, which are exact.
void compare(const Subject& subject, const Population& population) {
  const std::vector<std::int64_t> exact = answers(*subject.casters[0], population);
  const auto hit = std::count_if(exact.begin(), exact.end(), [](std::int64_t id) { return id >= 0; });
  std::printf("%s_%s: %zu rays, %td hit\n", population.name.c_str(), subject.name.c_str(), exact.size(), hit);
  for (std::size_t c = 1; c < subject.casters.size(); ++c) {
    const std::vector<std::int64_t> theirs = answers(*subject.casters[c], population);
    std::size_t lost = 0, invented = 0, others = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      lost += theirs[i] < 0 && exact[i] >= 0;
      invented += theirs[i] >= 0 && exact[i] < 0;
      others += theirs[i] >= 0 && exact[i] >= 0 && theirs[i] != exact[i];
    }
    std::printf("  %s: %zu hits lost, %zu invented, %zu on another triangle\n", rows[c].name.c_str(), lost, invented,
                others);
  }
}

void time_casters(const Subject& subject, const Population& population) {
  for (std::size_t c = 0; c < subject.casters.size(); ++c) {
    Caster* caster = subject.casters[c].get();
    const std::vector<Ray>* rays = &population.rays;
    benchmark::RegisterBenchmark(named(subject, population, rows[c].name).c_str(), [=](benchmark::State& state) {
      std::vector<std::int64_t> hits(rays->size());
      for (auto _ : state) {
        caster->first_hits(*rays, hits);
        benchmark::DoNotOptimize(hits.data());
        benchmark::ClobberMemory();
      }
      state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rays->size()));
    });
  }
}

/// A ratio to print; the head of this file says which.
struct Comparison {
  const char *name, *peer, *ours;
};

const Comparison comparisons[] = {{"embree", "embree", "ours"},
                                  {"aabb", "aabb", "ours_batch"},
                                  {"embree_batch", "embree", "ours_batch"},
                                  {"aabb_single", "aabb", "ours"}};

void print_ratios(const Medians& m, const std::vector<std::string>& scenes) {
  for (const Comparison& c : comparisons) {
    for (const std::string at : {"coherent_16k", "random_16k", "coherent_1m", "random_1m"}) {
      m.print_ratio(c.name + ("_" + at), at + "/" + c.peer, at + "/" + c.ours);
    }
  }
  for (const char* rays : {"coherent", "random"}) {
    for (const char* who : {"ours", "ours_batch", "embree", "aabb"}) {
      m.print_ratio(std::string("slowdown_") + rays + "_" + who, std::string(rays) + "_1m/" + who,
                    std::string(rays) + "_16k/" + who);
    }
  }
  double log_sum = 0;
  int drawn = 0;
  for (const std::string& scene : scenes) {
    m.print_ratio("povray_frame_" + scene, scene + "/povray", scene + "/ours");
    if (!m.has(scene + "/povray")) continue;
    log_sum += std::log(m.median(scene + "/povray") / m.median(scene + "/ours"));
    ++drawn;
  }
  if (drawn > 0)
    std::printf("ratio povray_frame %.3f (geometric mean of %d scenes)\n", std::exp(log_sum / drawn), drawn);
}

}  // namespace
}  // namespace tribunal::bench

int main(int argc, char** argv) {
  using namespace tribunal::bench;
  const std::vector<std::string> scenes = {"paper-2a", "paper-2b", "paper-2c",
                                           "paper-2h", "elephant", "mirror-and-prism"};
  Population populations[] = {{"coherent", coherent_rays(side)}, {"random", random_rays(side * side)}};
  std::deque<Subject> subjects;
  subjects.push_back({"16k", torus(64)});
  subjects.push_back({"1m", torus(512)});
  std::printf("vector target %s; one thread each\n", std::string(tribunal::batch_targets().front()).c_str());
  for (Subject& subject : subjects) {
    build(subject);
    for (const Population& p : populations) {
      compare(subject, p);
      time_casters(subject, p);
    }
  }
  return run_benchmarks(
      argc, argv, {.repetitions = 5}, "ns a ray, or a pixel",
      [&](const Medians& medians) { print_ratios(medians, scenes); },
      [&](Medians& medians) { time_frames(scenes, 3, medians); });
}
