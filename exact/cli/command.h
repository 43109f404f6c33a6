// The shape of a command: main.cpp holds the table, each command its own file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/method.h"
#include "exact/cases/own/own_data.h"
#include "exact/cli/arguments.h"
#include "exact/sweep/sweep.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// What a command does once its options are parsed; returns an exit code or throws Failure.
using Action = std::function<int()>;

struct Command {
  const char* name;
  const char* summary;  ///< one line
  const char* example;  ///< shown at the end of --help
  Action (*declare)(Arguments& arguments);
};

/// The named methods ("a,b,c"), in the order given. Fails with Exit::usage, naming the nearest known method.
std::vector<Method> methods_named(const std::string& comma_separated);

/// Declares --method, and --methods for it, of the methods on trial; `otherwise` says who is asked where it is not
/// given and no plugin is.
Arguments::Option add_methods_option(Arguments& arguments, std::string& names, const std::string& otherwise = "");

/// The methods on trial: those named; if none is, those of the plugins; without plugins the ones of `otherwise`. Fails
/// with Exit::usage if that leaves nobody: a plugin is never loaded and not asked.
std::vector<Method> methods_on_trial(const std::string& named, const std::string& otherwise = "");

/// The one method on trial. Fails with Exit::usage if there are several.
Method method_on_trial(const std::string& named);

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

/// --threads, defaulting to default_threads().
void add_threads_option(Arguments& arguments, unsigned& threads);

/// Whether a command offers --isolate: not if it measures time, or asks so many queries that it would be too slow to
/// send them to other processes.
enum class MayIsolate { no, yes };

/// Declares --plugin, repeatable, with --isolate and --time-limit, and returns an action that loads the plugins
/// first.
Action with_plugins(Arguments& arguments, Action action, MayIsolate may_isolate = MayIsolate::yes);

/// 128 + signal if a signal asked for an end, as shells expect; else the exit code of work that was done.
int exit_code_after(int code_if_done, int signal);

Action declare_methods(Arguments& arguments);
Action declare_classify(Arguments& arguments);
/// Reads the rays and faces of a scene file.
using ReadScene = OwnData (*)(const std::string& file);

/// The reader of scenes comes from a room further down.
Action declare_fuzz(Arguments& arguments, ReadScene read_scene);
Action declare_shrink(Arguments& arguments);
Action declare_replay(Arguments& arguments);
Action declare_cases(Arguments& arguments);
Action declare_certify(Arguments& arguments);
Action declare_check(Arguments& arguments);
Action declare_verify(Arguments& arguments);
Action declare_report(Arguments& arguments);

/// A stress axis that aims rays at a mesh, before the mesh is known.
struct MeshAxisMaker {
  std::string_view name, quantity;
  MeshAxis (*of_file)(const std::string& file);  ///< of a mesh of the program's own if no file is named
};

/// The axis of a mesh comes from a room further down.
Action declare_sweep(Arguments& arguments, const MeshAxisMaker& maker);

}  // namespace tribunal
