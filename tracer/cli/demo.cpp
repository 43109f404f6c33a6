// tribunal demo: runs the other commands one after the other and makes a page of what they wrote.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/cli/program.h"
#include "exact/record/counterexample.h"
#include "exact/report/page.h"
#include "tracer/cli/command.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

struct Options {
  std::string out = "out", scene = "data/scenes/elephant.json";
  unsigned threads = 1;
};

constexpr int stages = 5;

/// The two methods that the page compares: the same test in double and in rational arithmetic.
constexpr const char* floating = "sf-double";
constexpr const char* exact = "sf-rational";

/// A command as one would type it, and the exit code that shows the expected result.
struct Step {
  const char* command;
  Action (*declare)(Arguments&);
  std::vector<std::string> arguments;
  Exit expected = Exit::ok;

  std::string line() const {
    std::string text = std::string("tribunal ") + command;
    for (const std::string& argument : arguments) text += " " + argument;
    return text;
  }
};

int run_step(const Step& step) {
  const Command command{step.command, "", "", step.declare};
  std::vector<std::string> words{step.command};
  words.insert(words.end(), step.arguments.begin(), step.arguments.end());
  return run_command({&command, 1}, words);
}

bool is_interruption(int exit) { return exit == code(Exit::interrupted) || exit == code(Exit::terminated); }

/// Runs steps, and keeps their command lines and the unexpected results.
class Runner {
 public:
  void announce(int stage, const std::string& what) {
    print("\n" + std::to_string(stage) + "/" + std::to_string(stages) + " " + what + "\n");
  }

  void run(const Step& step) {
    lines_.push_back(step.line());
    print("\n$ " + step.line() + "\n");
    const int exit = run_step(step);
    if (is_interruption(exit)) throw Failure(static_cast<Exit>(exit), "interrupted; no page written");
    if (exit == code(step.expected)) return;
    unexpected_.push_back(step.line() + " ended with exit code " + std::to_string(exit) + ", expected " +
                          std::to_string(code(step.expected)));
  }

  const std::vector<std::string>& lines() const { return lines_; }
  const std::vector<std::string>& unexpected() const { return unexpected_; }

 private:
  std::vector<std::string> lines_, unexpected_;
};

/// Refuses a scene that cannot be read, before anything is run or written.
void require_scene(const std::string& file) {
  try {
    read_scene(file);
  } catch (const Failure& failure) {
    throw Failure(failure.exit(), std::string(failure.what()) +
                                      " (run from the repository; `./run build` unpacks the meshes into data/meshes)");
  }
}

Json json_from(const std::string& file) { return parse_json(read_file(file), {file}); }

void run_fuzz(Runner& runner, const Options& o) {
  runner.announce(1, "fuzz: hunt for wrong answers of several methods");
  runner.run({"fuzz",
              declare_fuzz,
              {"--method", "sf-float,sf-double,sf-double-eps,mt-float,mt-double,sf-epick", "--count", "400000",
               "--keep", "5", "--threads", std::to_string(o.threads), "--out", o.out + "/" + demo_files::fuzz},
              Exit::disagreement});
}

void run_certify(Runner& runner, const Options& o) {
  runner.announce(2, "certify: one test in two arithmetics");
  const auto certify = [&](const char* method, Exit expected) {
    runner.run({"certify",
                declare_certify,
                {"--method", method, "--budget", "quick", "--threads", std::to_string(o.threads), "--out",
                 o.out + "/" + certificate_directory(method)},
                expected});
  };
  certify(floating, Exit::disagreement);
  certify(exact, Exit::ok);
}

constexpr const char* pictured[] = {"mt-float", "sf-double"};

std::string stats_file(const Options& o, const std::string& method) {
  return o.out + "/render/exact-" + method + ".json";
}

/// Two renders for each method: the reference against the method, which gives the exact picture and the difference,
/// and the method alone, which gives its own picture. Both round the scene to the method's format.
void run_render(Runner& runner, const Options& o) {
  runner.announce(3, "render: what wrong answers do to a picture");
  make_directory(o.out + "/render");
  const std::string threads = std::to_string(o.threads);
  for (const std::string method : pictured) {
    runner.run({"render",
                declare_render,
                {o.scene, "--method", exact, "--against", method, "-o", o.out + "/" + exact_picture(method), "--stats",
                 stats_file(o, method), "--threads", threads}});
    runner.run({"render",
                declare_render,
                {o.scene, "--method", method, "-o", o.out + "/" + own_picture(method), "--threads", threads}});
  }
}

void run_chart(Runner& runner, const Options& o) {
  runner.announce(4, "chart: speed against accuracy");
  runner.run({"chart",
              declare_chart,
              {"--quick", "--threads", std::to_string(o.threads), "--out", o.out + "/" + demo_files::charts}});
}

/// Writes the plainest counterexample to a file of its own and adds it to the page, with what `replay` says of it.
void add_counterexample(Tour& tour) {
  tour.counterexample =
      plainest(read_cases(tour.directory + "/" + certificate_directory(floating) + "/counterexamples.jsonl"));
  write_file(tour.directory + "/" + demo_files::counterexample, to_lines(std::vector{tour.counterexample}));
  bool wrong = false;
  tour.replay = replay(tour.counterexample, wrong);
}

std::vector<Case> cases_in(const std::string& file) {
  return read_file(file).empty() ? std::vector<Case>{} : read_cases(file);
}

Tour read_tour(const Options& o, const Runner& runner) {
  Tour tour;
  tour.directory = o.out;
  tour.commands = runner.lines();
  tour.floating = certificate_figures(json_from(o.out + "/" + certificate_directory(floating) + "/certificate.json"));
  tour.exact = certificate_figures(json_from(o.out + "/" + certificate_directory(exact) + "/certificate.json"));
  tour.fuzz = fuzz_figures(json_from(o.out + "/" + demo_files::fuzz + "/summary.json"));
  for (const std::string method : pictured) {
    const std::string cases = o.out + "/render/exact-" + method + ".cases.jsonl";
    tour.pictures.push_back(picture_figures(json_from(stats_file(o, method)), cases_in(cases)));
  }
  tour.chart = json_from(o.out + "/" + demo_files::charts + "/chart.json");
  add_counterexample(tour);
  return tour;
}

int run(const Options& o) {
  const auto start = std::chrono::steady_clock::now();
  require_scene(o.scene);
  make_directory(o.out);
  Runner runner;
  run_fuzz(runner, o);
  run_certify(runner, o);
  run_render(runner, o);
  run_chart(runner, o);
  runner.announce(5, "page");
  Tour tour = read_tour(o, runner);
  tour.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_file(o.out + "/index.html", page(tour));
  print("\nOpen " + o.out + "/index.html\n");
  for (const std::string& line : runner.unexpected()) print("UNEXPECTED: " + line + "\n");
  return code(runner.unexpected().empty() ? Exit::ok : Exit::disagreement);
}

}  // namespace

Action declare_demo(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("--out", o->out, "directory for the page and all that it shows").shows_default();
  arguments.option("--scene", o->scene, "the scene to render").shows_default();
  add_threads_option(arguments, o->threads);
  return [o] { return run(*o); };
}

}  // namespace tribunal
