// tribunal cases: generated cases as a file, for tests that live elsewhere.
#include <memory>

#include "exact/cli/command.h"
#include "exact/cli/polygon_streams.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"

namespace tribunal {
namespace {

/// A file of so many cases has about 4 GB, as much as we read; polygons have more points.
constexpr std::uint64_t most_cases = 10'000'000, most_polygons = 2'500'000;

struct Options {
  std::string families, format, out = "-";
  std::uint64_t seed = 1, count = 10'000;
  bool with_answers = false;
};

template <class S>
std::vector<S> in_format(std::vector<S> streams, const std::string& format) {
  std::erase_if(streams, [&](const S& s) { return !format.empty() && format != name_of(s.format); });
  return streams;
}

void add_answer(Case& c, const Truth& truth) {
  c.expect = truth.hit();
  c.class_id = truth.class_id;
}

void add_answer(PolygonCase& c, const PolygonTruth& truth) { c.expect = truth.hit(); }

/// Case g: the streams take turns, as in fuzz.
template <class On>
typename On::Case case_at(const std::vector<BasicStream<On>>& streams, std::uint64_t g, const Options& o) {
  const BasicStream<On>& stream = streams[g % streams.size()];
  const std::uint64_t number = g / streams.size();
  const std::string k = std::to_string(number);
  const auto trial = stream.family->make(stream.format, o.seed, number);
  typename On::Case c;
  c.id = std::string(stream.family->name) + "-" + std::string(name_of(stream.format)) + "-" + k;
  c.format = stream.format;
  c.query = trial.query;
  c.source = "family " + std::string(stream.family->name) + ", seed " + std::to_string(o.seed) + ", case " + k;
  if (o.with_answers) add_answer(c, On::truth_of(trial, number));
  return c;
}

template <class On>
int run(const Options& o, const std::vector<BasicStream<On>>& streams) {
  std::string lines;
  for (std::uint64_t g = 0; g < o.count; ++g) lines += from_case(case_at(streams, g, o)).dump() + "\n";
  write_file(o.out, lines);
  return 0;
}

int run(const Options& o) {
  const auto polygons = polygon_streams_named(o.families);
  if (polygons.empty()) return run(o, in_format(streams_named(o.families), o.format));
  if (o.count > most_polygons) {
    throw Failure(Exit::usage, "--count is " + std::to_string(o.count) + ", expected at most " +
                                   std::to_string(most_polygons) + " polygons");
  }
  return run(o, in_format(polygons, o.format));
}

}  // namespace

Action declare_cases(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("--family", o->families, family_help() + polygon_family_help());
  app.add_option("--fmt", o->format, "only cases of this format (default both, in turn)")
      ->check(CLI::IsMember({"binary32", "binary64"}));
  app.add_option("--seed", o->seed, "seed of the cases")->check(whole_number())->capture_default_str();
  app.add_option("--count", o->count, "cases in all")
      ->check(whole_number())
      ->check(CLI::Range(std::uint64_t{1}, most_cases))
      ->capture_default_str();
  app.add_flag("--with-answers", o->with_answers, "give the exact answer (and of triangles the class) with each case");
  app.add_option("--out", o->out, "case file (JSON Lines); - is standard output")->capture_default_str();
  return [o] { return run(*o); };
}

}  // namespace tribunal
