// tribunal demo: runs the other commands one after the other, the last of which makes a page of what they wrote.
#include <algorithm>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/cli/program.h"
#include "tracer/cli/command.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

struct Options {
  std::string out = "out", scene = "data/scenes/elephant.json";
  unsigned threads = 1;

  std::string in(const std::string& name) const { return out + "/" + name; }
};

constexpr int stages = 6;

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

/// Runs steps, and keeps what ended otherwise than expected.
class Runner {
 public:
  explicit Runner(const Options& o) : threads_(std::to_string(o.threads)) {}

  void announce(int stage, const std::string& what) {
    print("\n" + std::to_string(stage) + "/" + std::to_string(stages) + " " + what + "\n");
  }

  /// Returns the step's exit code.
  int run(Step step) {
    print("\n$ " + step.line() + "\n");
    const int exit = run_step(step);
    if (is_interruption(exit)) throw Failure(static_cast<Exit>(exit), "interrupted; no page written");
    if (exit == code(step.expected)) return exit;
    worst_ = std::max({worst_, exit, code(Exit::disagreement)});
    unexpected_.push_back(step.line() + " ended with exit code " + std::to_string(exit) + ", expected " +
                          std::to_string(code(step.expected)));
    return exit;
  }

  /// The same with the demo's number of threads.
  void run_threaded(Step step) {
    step.arguments.insert(step.arguments.end(), {"--threads", threads_});
    run(std::move(step));
  }

  const std::vector<std::string>& unexpected() const { return unexpected_; }

  /// The largest exit code of a step that ended otherwise than expected, at least that of a disagreement; 0 if all
  /// ended as expected.
  int worst() const { return worst_; }

 private:
  std::string threads_;
  std::vector<std::string> unexpected_;
  int worst_ = code(Exit::ok);
};

/// What the steps write, in the order of the report: a directory each.
constexpr const char* results[] = {
    "fuzz", "certificate-sf-double", "certificate-sf-filtered", "sweep", "map", "render", "charts"};

/// Removes what an earlier demo left: the page must show this one, and must not stay if a step fails.
void remove_earlier(const Options& o) {
  remove_tree(o.in("index.html"));
  for (const char* name : results) remove_tree(o.in(name));
}

/// Refuses a scene that cannot be read, before anything is run or written.
void require_scene(const std::string& file) {
  try {
    read_scene(file);
  } catch (const Failure& failure) {
    throw Failure(failure.exit(), std::string(failure.what()) +
                                      " (run from the repository; `./run build` unpacks the meshes into data/meshes)");
  }
}

void run_fuzz(Runner& runner, const Options& o) {
  runner.announce(1, "fuzz: hunt for wrong answers of several methods, the certified one among them");
  runner.run_threaded(
      {"fuzz",
       declare_fuzz,
       {"--method", "sf-float,sf-double,sf-double-eps,sf-filtered,mt-float,mt-double,woop-double,sf-epick", "--count",
        "400000", "--keep", "40", "--out", o.in("fuzz")},
       Exit::disagreement});
}

void run_certify(Runner& runner, const Options& o) {
  runner.announce(2, "certify: one test in two arithmetics");
  const auto certify = [&](const std::string& method, Exit expected) {
    runner.run_threaded({"certify",
                         declare_certify,
                         {"--method", method, "--budget", "quick", "--out", o.in("certificate-" + method)},
                         expected});
  };
  certify("sf-double", Exit::disagreement);
  certify("sf-filtered", Exit::ok);
}

void run_sweep(Runner& runner, const Options& o) {
  runner.announce(3, "sweep: where does each method begin to fail?");
  const std::string methods = "sf-float,sf-double,mt-double,sf-filtered";
  runner.run_threaded(
      {"sweep",
       declare_sweep,
       {"--method", methods, "--axis", "scale,sliver,grazing,ulps", "--count", "1312", "--out", o.in("sweep")}});
  runner.run_threaded(
      {"sweep", declare_sweep, {"--method", methods, "--map", "edge", "--map-size", "128", "--out", o.in("map")}});
}

void run_render(Runner& runner, const Options& o) {
  runner.announce(4, "render: what wrong answers do to a picture");
  make_directory(o.in("render"));
  for (const std::string method : {"mt-float", "sf-double"}) {
    runner.run_threaded(
        {"render",
         declare_render,
         {o.scene, "--method", method, "--against", "sf-filtered", "-o", o.in("render/" + method + ".png")}});
  }
}

void run_chart(Runner& runner, const Options& o) {
  runner.announce(5, "chart: speed against accuracy");
  runner.run_threaded({"chart", declare_chart, {"--quick", "--out", o.in("charts")}});
}

/// Whether the page was written.
bool run_report(Runner& runner, const Options& o) {
  runner.announce(6, "report: all of it as one page");
  std::vector<std::string> arguments;
  for (const char* name : results) arguments.push_back(o.in(name));
  arguments.insert(arguments.end(), {"--out", o.in("index.html")});
  return runner.run({"report", declare_report, arguments}) == code(Exit::ok);
}

int run(const Options& o) {
  require_scene(o.scene);
  make_directory(o.out);
  remove_earlier(o);
  Runner runner(o);
  run_fuzz(runner, o);
  run_certify(runner, o);
  run_sweep(runner, o);
  run_render(runner, o);
  run_chart(runner, o);
  if (run_report(runner, o)) print("\nOpen " + o.in("index.html") + "\n");
  for (const std::string& line : runner.unexpected()) print("UNEXPECTED: " + line + "\n");
  return runner.worst();
}

}  // namespace

Action declare_demo(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments
      .option("--out", o->out,
              "directory for the page and all that it shows; what an earlier demo left there is removed")
      .shows_default();
  arguments.option("--scene", o->scene, "the scene to render").shows_default();
  add_threads_option(arguments, o->threads);
  return [o] { return run(*o); };
}

}  // namespace tribunal
