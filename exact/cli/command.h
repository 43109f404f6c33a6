// The shape of a command: main.cpp holds the table, each command its own file.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "core/method.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// What a command does once its options are parsed; returns an exit code or throws Failure.
using Action = std::function<int()>;

struct Command {
  const char* name;
  const char* summary;  ///< one line
  const char* example;  ///< shown at the end of --help
  Action (*declare)(CLI::App& app);
};

/// The named methods ("a,b,c"), in the order given. Fails with Exit::usage, naming the nearest known method.
std::vector<Method> methods_named(const std::string& comma_separated);

/// "a,b" → {"a", "b"}.
std::vector<std::string> split(const std::string& comma_separated);

/// The named families ("a,b,c"), in both formats; those of triangles if none is named. Fails with Exit::usage on an
/// unknown name, naming the nearest known family, and where families of triangles and of polygons are mixed.
std::vector<Stream> streams_named(const std::string& comma_separated);

/// "affine (what it stresses) ulp (…) …", for --help.
std::string family_help();

/// Fails with Exit::usage if the method takes no polygons.
void require_polygons(const Method& method);

/// The default number of worker threads: one for each core.
unsigned default_threads();

/// A check of an option: a number above 0.
CLI::Validator above_zero();

/// A check of an option: a whole number from 0 to 2^64 − 1, in digits.
CLI::Validator whole_number();

/// --threads, defaulting to default_threads().
void add_threads_option(CLI::App& app, unsigned& threads);

/// Whether a command offers --isolate: not if it measures time, or asks too often for questions to go to other
/// processes.
enum class MayIsolate { no, yes };

/// Declares --plugin, repeatable, with --isolate and --time-limit, and returns the action with loading the plugins
/// before it.
Action with_plugins(CLI::App& app, Action action, MayIsolate may_isolate = MayIsolate::yes);

/// 128 + signal if one asked for an end, as shells expect.
int exit_code_after(int code_if_done, int signal);

Action declare_methods(CLI::App& app);
Action declare_classify(CLI::App& app);
Action declare_fuzz(CLI::App& app);
Action declare_shrink(CLI::App& app);
Action declare_replay(CLI::App& app);
Action declare_cases(CLI::App& app);
Action declare_judge(CLI::App& app);
Action declare_certify(CLI::App& app);
Action declare_verify(CLI::App& app);
Action declare_chart(CLI::App& app);

}  // namespace tribunal
