// Time per query of a segment and a prepared polygon: sf-filtered, the classical ways, and peers. `./run bench polygon`
// builds and runs it. All benchmarks run in one process in random order, several times each, so that a change of the
// machine's speed meets all of them. CPU time, since others may use the machine. Before that every population is asked
// of every exact method, and the answers compared. The last lines are `ratio NAME VALUE`, of medians.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <string>
#include <vector>

#include "core/classical_polygon.h"
#include "core/segura_feito_polygon.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/filtered/filtered_polygon.h"
#include "exact/kernels/rational_kernel.h"
#include "tests/bench/medians.h"
#include "tests/bench/polygon/polygon_peers.h"
#include "tests/bench/polygon/polygons.h"

namespace tribunal::bench {
namespace {

constexpr std::size_t polygons_each = 32;
constexpr std::size_t probes_each = 16'000;  ///< 900 KB: more than a branch predictor remembers, within the L2 cache
constexpr std::size_t slow_probes = 500;     ///< for methods that take microseconds
constexpr int vertex_counts[] = {3, 4, 6, 8, 16, 64, 256};

constexpr FormulaKernel<double> in_double;

/// How a method prepares a polygon, and how it answers. `exact` methods must agree with the population.
struct SfFiltered {
  static constexpr const char* name = "sf_filtered";
  static constexpr bool exact = true;
  using Prepared = FilteredPolygon;
  static Prepared prepare(const Polygon& p) { return Prepared(p); }
  static bool meets(const Prepared& p, const Segment& s) { return p.hits(s); }
};

/// Segura–Feito in double. The covering is prepared with exact signs, since in double few planar polygons would be
/// recognised as planar.
struct SfDouble {
  static constexpr const char* name = "sf_double";
  static constexpr bool exact = false;
  using Prepared = Covering;
  static Prepared prepare(const Polygon& p) { return cover(p, FilteredKernel()); }
  static bool meets(const Prepared& c, const Segment& s) { return segura_feito(s, c, in_double).hit; }
};

struct SfDoubleOnTheFly {
  static constexpr const char* name = "sf_double_on_the_fly";
  static constexpr bool exact = false;
  using Prepared = Polygon;
  static Prepared prepare(const Polygon& p) { return p; }
  static bool meets(const Prepared& p, const Segment& s) { return segura_feito(s, p, in_double).hit; }
};

template <class N>
struct Classical {
  static constexpr bool exact = false;
  using Prepared = ClassicalPolygon<N>;
  static Prepared prepare(const Polygon& p) { return classical_polygon<N>(p); }
};

template <class N>
struct Haines : Classical<N> {
  static constexpr const char* name = sizeof(N) == 8 ? "haines_double" : "haines_float";
  static bool meets(const ClassicalPolygon<N>& c, const Segment& s) {
    const auto hit = plane_hit(c, s);
    return hit && inside_by_crossings(c, hit->x);
  }
};

template <class N>
struct Feito : Classical<N> {
  static constexpr const char* name = sizeof(N) == 8 ? "feito_double" : "feito_float";
  static bool meets(const ClassicalPolygon<N>& c, const Segment& s) {
    const auto hit = plane_hit(c, s);
    return hit && inside_by_signed_triangles(c, hit->x);
  }
};

struct HainesTuned : Classical<double> {
  static constexpr const char* name = "haines_tuned";
  static bool meets(const Prepared& c, const Segment& s) { return meets_tuned(c, s); }
};

struct SfTuned {
  static constexpr const char* name = "sf_tuned";
  static constexpr bool exact = false;
  using Prepared = TunedCovering;
  static Prepared prepare(const Polygon& p) { return tuned_covering(p); }
  static bool meets(const Prepared& c, const Segment& s) { return meets_tuned(c, s); }
};

struct Uncertified {
  static constexpr const char* name = "uncertified";
  static constexpr bool exact = false;
  using Prepared = UncertifiedPolygon;
  static Prepared prepare(const Polygon& p) { return uncertified(p); }
  static bool meets(const Prepared& p, const Segment& s) { return meets_uncertified(p, s); }
};

struct Cgal {
  static constexpr const char* name = "cgal_triangulation";
  static constexpr bool exact = true;
  using Prepared = TriangulatedPolygon;
  static Prepared prepare(const Polygon& p) { return Prepared(p); }
  static bool meets(const Prepared& p, const Segment& s) { return p.meets(s); }
};

struct SfRational {
  static constexpr const char* name = "sf_rational";
  static constexpr bool exact = true;
  using Prepared = Covering;
  static Prepared prepare(const Polygon& p) { return cover(p, FilteredKernel()); }
  static bool meets(const Prepared& c, const Segment& s) { return segura_feito(s, c, RationalKernel{}).hit; }
};

/// Counts of wrong answers by method: over all populations in general position, and on the boundary.
class Verdicts {
 public:
  void add(const std::string& method, std::size_t asked, std::size_t wrong) {
    const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.method == method; });
    Row& row = found != rows_.end() ? *found : rows_.emplace_back(Row{method, 0, 0});
    row.asked += asked;
    row.wrong += wrong;
  }

  void print() const {
    for (const Row& r : rows_) std::printf("wrong %-30s %zu of %zu\n", r.method.c_str(), r.wrong, r.asked);
  }

 private:
  struct Row {
    std::string method;
    std::size_t asked, wrong;
  };
  std::vector<Row> rows_;
};

/// A method prepared for the polygons of a population, and its benchmark. `meets` is inlined into the timed loop
/// where possible.
template <class M>
class Contender {
 public:
  Contender(const Population& population, std::size_t probes) : population_(population), probes_(probes) {
    for (const PolygonData& p : population.polygons) prepared_.push_back(M::prepare(p));
  }

  std::string name() const { return population_.name() + "/" + M::name; }

  /// Compares all answers with those known by integers; stops the program if an exact method is wrong.
  void judge(Verdicts& verdicts) const {
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < probes_; ++i) {
      const PolygonProbe& probe = population_.probes[i];
      wrong += M::meets(prepared_[probe.polygon], probe.segment) != probe.hit;
    }
    const bool boundary = population_.mix == Mix::boundary;
    verdicts.add(M::name + std::string(boundary ? "/boundary" : ""), probes_, wrong);
    if (!M::exact || wrong == 0) return;
    std::fprintf(stderr, "%s: %zu answers wrong\n", name().c_str(), wrong);
    std::exit(6);
  }

  void time(benchmark::State& state) const {
    const auto* const polygons = prepared_.data();
    const PolygonProbe *const begin = population_.probes.data(), *const end = begin + probes_;
    for (auto _ : state) {
      std::size_t count = 0;
      for (const PolygonProbe* probe = begin; probe != end; ++probe) {
        count += M::meets(polygons[probe->polygon], probe->segment);
      }
      benchmark::DoNotOptimize(count);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * probes_));
  }

 private:
  const Population& population_;
  std::size_t probes_;
  std::vector<typename M::Prepared> prepared_;
};

template <class M>
void enter(const Population& population, Verdicts& verdicts, std::size_t probes = probes_each) {
  static std::deque<Contender<M>> contenders;  // lives as long as the benchmarks
  const Contender<M>& c = contenders.emplace_back(population, probes);
  c.judge(verdicts);
  benchmark::RegisterBenchmark(c.name().c_str(), [&c](benchmark::State& state) { c.time(state); });
}

void enter_all(const Population& population, Verdicts& verdicts) {
  const std::size_t few = population.vertices > 16 ? slow_probes : probes_each;
  enter<SfFiltered>(population, verdicts);
  enter<SfDouble>(population, verdicts);
  enter<Haines<double>>(population, verdicts);
  enter<HainesTuned>(population, verdicts);
  enter<SfTuned>(population, verdicts);
  if (population.vertices <= 16) enter<Uncertified>(population, verdicts);
  enter<Feito<double>>(population, verdicts);
  if (population.mix != Mix::hits_7 && population.mix != Mix::boundary) return;
  enter<SfDoubleOnTheFly>(population, verdicts);
  enter<Haines<float>>(population, verdicts);
  enter<Feito<float>>(population, verdicts);
  enter<Cgal>(population, verdicts, few);
  if (population.vertices <= 16) enter<SfRational>(population, verdicts, slow_probes);
}

/// How many probes the filter leaves to exact signs.
std::size_t count_past_filter(const Population& population) {
  std::vector<FilteredPolygon> prepared;
  for (const PolygonData& p : population.polygons) prepared.emplace_back(p);
  return static_cast<std::size_t>(
      std::count_if(population.probes.begin(), population.probes.end(),
                    [&](const PolygonProbe& p) { return !prepared[p.polygon].filter_hits(p.segment); }));
}

void register_all() {
  static std::deque<Population> populations;
  Verdicts verdicts;
  std::size_t asked = 0, past = 0;
  for (const Mix mix : all_mixes) {
    for (const Outline outline : all_outlines) {
      for (const int n : vertex_counts) {
        if (n < least_vertices(outline) || (mix == Mix::boundary && n > 16)) continue;
        const Population& p = populations.emplace_back(draw_population(outline, n, mix, polygons_each, probes_each));
        enter_all(p, verdicts);
        if (mix == Mix::hits_7) {
          std::printf("%-28s %4.1f %% miss the plane\n", p.name().c_str(),
                      100 * static_cast<double>(p.plane_missed) / static_cast<double>(p.probes.size()));
        }
        if (mix == Mix::boundary) continue;
        asked += p.probes.size();
        past += count_past_filter(p);
      }
    }
  }
  verdicts.print();
  std::printf("past the filter: %zu of %zu in general position\n", past, asked);
}

/// The name of the fastest classical method in double.
std::string best_classical(const Medians& m, const std::string& at, std::initializer_list<const char*> ways) {
  std::string best;
  for (const char* way : ways) {
    if (m.has(at + way) && (best.empty() || m.median(at + way) < m.median(best))) best = at + way;
  }
  return best;
}

void print_ratios(const Medians& m) {
  for (const Mix mix : all_mixes) {
    for (const Outline outline : all_outlines) {
      for (const int n : vertex_counts) {
        const std::string at = Population{outline, n, mix, {}, {}}.name() + "/";
        const std::string shipped = best_classical(m, at, {"haines_double", "feito_double"});
        const std::string best = best_classical(m, at, {"haines_double", "feito_double", "haines_tuned"});
        if (best.empty() || mix == Mix::boundary) continue;
        std::string suffix = outline == Outline::convex ? "" : std::string("_") + name_of(outline);
        suffix += "_n" + std::to_string(n);
        if (mix != Mix::hits_7) suffix += std::string("_") + name_of(mix);
        m.print_ratio("filtered_over_best_classical" + suffix, at + "sf_filtered", best);
        m.print_ratio("filtered_over_textbook_classical" + suffix, at + "sf_filtered", shipped);
        m.print_ratio("filtered_over_uncertified" + suffix, at + "sf_filtered", at + "uncertified");
        m.print_ratio("sf_double_over_best_classical" + suffix, at + "sf_double", best);
        m.print_ratio("sf_double_over_textbook_classical" + suffix, at + "sf_double", shipped);
        m.print_ratio("sf_tuned_over_best_classical" + suffix, at + "sf_tuned", best);
        m.print_ratio("sf_tuned_over_textbook_classical" + suffix, at + "sf_tuned", shipped);
        m.print_ratio("cgal_over_filtered" + suffix, at + "cgal_triangulation", at + "sf_filtered");
        m.print_ratio("rational_over_filtered" + suffix, at + "sf_rational", at + "sf_filtered");
      }
    }
  }
}

void print_boundary_ratios(const Medians& m) {
  for (const int n : {3, 4, 8}) {
    const std::string at = Population{Outline::convex, n, Mix::boundary, {}, {}}.name() + "/";
    const std::string suffix = "_over_filtered_boundary_n" + std::to_string(n);
    m.print_ratio("cgal" + suffix, at + "cgal_triangulation", at + "sf_filtered");
    m.print_ratio("rational" + suffix, at + "sf_rational", at + "sf_filtered");
  }
}

/// Prints what one more vertex costs: the slope of the time between the two largest polygons.
void print_growth(const Medians& m) {
  for (const char* method : {"sf_filtered", "sf_double", "sf_tuned", "haines_double", "haines_tuned", "feito_double"}) {
    const std::string few = std::string("hits_7/convex/n64/") + method,
                      many = std::string("hits_7/convex/n256/") + method;
    if (m.has(few) && m.has(many)) {
      std::printf("ratio ns_per_vertex_%s %.3f\n", method, (m.median(many) - m.median(few)) / (256 - 64));
    }
  }
}

}  // namespace
}  // namespace tribunal::bench

int main(int argc, char** argv) {
  using namespace tribunal::bench;
  register_all();
  return run_benchmarks(argc, argv, {.repetitions = 11, .seconds = 0.002}, "ns a query", [](const Medians& medians) {
    print_growth(medians);
    print_boundary_ratios(medians);
    print_ratios(medians);
  });
}
