// tribunal cases: generated cases as a file, for tests that live elsewhere.
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/output.h"
#include "exact/cases/case_io.h"
#include "exact/cli/command.h"

namespace tribunal {
namespace {

/// A file of so many cases has about 4 GB, as much as we read; polygons have more points.
constexpr std::uint64_t most_cases = 10'000'000, most_polygons = 2'500'000;

struct Options {
  std::string families, format, out = "-";
  std::uint64_t seed = 1, count = 10'000;
  bool with_answers = false;
};

std::vector<Stream> in_format(std::vector<Stream> streams, const std::string& format) {
  std::erase_if(streams, [&](const Stream& s) { return !format.empty() && format != name_of(s.format); });
  return streams;
}

/// Case g: the streams take turns, as in fuzz.
Case case_at(const std::vector<Stream>& streams, std::uint64_t g, const Options& o) {
  const Stream& stream = streams[g % streams.size()];
  const std::uint64_t number = g / streams.size();
  const std::string k = std::to_string(number);
  const Trial trial = stream.family->make(stream.format, o.seed, number);
  Case c;
  c.id = std::string(stream.family->name) + "-" + std::string(name_of(stream.format)) + "-" + k;
  c.format = stream.format;
  c.query = trial.query;
  c.source = "family " + std::string(stream.family->name) + ", seed " + std::to_string(o.seed) + ", case " + k;
  if (!o.with_answers) return c;
  const Truth truth = truth_of(trial, number);
  c.expect = truth.hit();
  c.class_id = truth.class_id;
  return c;
}

int run(const Options& o) {
  const std::vector<Stream> streams = in_format(streams_named(o.families), o.format);
  if (streams.front().family->operands == Operands::polygons && o.count > most_polygons) {
    throw Failure(Exit::usage, "--count is " + std::to_string(o.count) + ", expected at most " +
                                   std::to_string(most_polygons) + " polygons");
  }
  std::string lines;
  for (std::uint64_t g = 0; g < o.count; ++g) lines += from_case(case_at(streams, g, o)).dump() + "\n";
  write_file(o.out, lines);
  return 0;
}

}  // namespace

Action declare_cases(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("--family", o->families, family_help());
  arguments.option("--fmt", o->format, "only cases of this format (default both, in turn)")
      .one_of({"binary32", "binary64"});
  arguments.option("--seed", o->seed, "seed of the cases").shows_default();
  arguments.option("--count", o->count, "cases in all").between(std::uint64_t{1}, most_cases).shows_default();
  arguments.flag("--with-answers", o->with_answers,
                 "give the exact answer (and of triangles the class) with each case");
  arguments.option("--out", o->out, "case file (JSON Lines); - is standard output").shows_default();
  return [o] { return run(*o); };
}

}  // namespace tribunal
