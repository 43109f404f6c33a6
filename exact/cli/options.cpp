// Options that several commands share.
#include <algorithm>
#include <memory>
#include <sstream>
#include <thread>

#include "exact/base/failure.h"
#include "exact/base/suggestion.h"
#include "exact/cases/family_table.h"
#include "exact/cli/command.h"
#include "exact/methods/methods.h"
#include "exact/plugin/exit_guard.h"
#include "exact/plugin/load.h"

namespace tribunal {
namespace {

const Method& method_named(const std::string& name) {
  if (const Method* found = find_method(name)) return *found;
  std::vector<std::string> names;
  for (const Method& m : all_methods()) names.push_back(m.name);
  throw Failure(Exit::usage,
                "unknown method \"" + name + "\"" + suggestion(name, names, "one that `tribunal methods` lists"));
}

const Family& family_named(const std::string& name) {
  if (const Family* found = find_family(name)) return *found;
  std::vector<std::string> known;
  for (const Operands operands : {Operands::triangles, Operands::polygons}) {
    for (const Family& f : families_of(operands)) known.emplace_back(f.name);
  }
  throw Failure(Exit::usage,
                "unknown family \"" + name + "\"" + suggestion(name, known, "one that `tribunal fuzz --help` lists"));
}

std::string list_of(Operands operands) {
  std::string text;
  for (const Family& f : families_of(operands))
    text += " " + std::string(f.name) + " (" + std::string(f.stresses) + ")";
  return text;
}

}  // namespace

std::vector<std::string> split(const std::string& comma_separated) {
  std::vector<std::string> parts;
  std::istringstream in(comma_separated);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

std::vector<Method> methods_named(const std::string& comma_separated) {
  std::vector<Method> methods;
  for (const std::string& name : split(comma_separated)) {
    if (std::ranges::find(methods, name, &Method::name) != methods.end()) {
      throw Failure(Exit::usage, "method " + name + " is named twice");
    }
    methods.push_back(method_named(name));
  }
  if (methods.empty()) throw Failure(Exit::usage, "no method given, expected names separated by commas");
  return methods;
}

Arguments::Option add_methods_option(Arguments& arguments, std::string& names, const std::string& otherwise) {
  return arguments.option("--method,--methods", names,
                          "methods, separated by commas (default: those of plugins" +
                              (otherwise.empty() ? "" : "; without any, " + otherwise) + ")");
}

std::vector<Method> methods_on_trial(const std::string& named, const std::string& otherwise) {
  if (!named.empty()) return methods_named(named);
  std::vector<Method> methods;
  for (const std::string& name : loaded_methods()) methods.push_back(method_named(name));
  if (!methods.empty()) return methods;
  if (!loaded_meshes().empty()) {
    throw Failure(
        Exit::usage,
        "the plugin has a tree and no test of single triangles: `tribunal leak` asks it, others need --method");
  }
  if (!otherwise.empty()) return methods_named(otherwise);
  throw Failure(Exit::usage, "no method given, expected --method with one that `tribunal methods` lists, or --plugin");
}

Method method_on_trial(const std::string& named) {
  const std::vector<Method> methods = methods_on_trial(named);
  if (methods.size() == 1) return methods.front();
  std::string names;
  for (const Method& m : methods) names += (names.empty() ? "" : ",") + m.name;
  throw Failure(Exit::usage, "expected one method, found " + names + ": say which with --method");
}

std::vector<Stream> streams_named(const std::string& comma_separated) {
  if (comma_separated.empty()) return streams_of(Operands::triangles);
  std::vector<Stream> streams;
  for (const std::string& name : split(comma_separated)) {
    const Family& family = family_named(name);
    if (std::ranges::any_of(streams, [&](const Stream& s) { return s.family == &family; })) {
      throw Failure(Exit::usage, "family " + name + " is named twice");
    }
    if (!streams.empty() && streams.front().family->operands != family.operands) {
      throw Failure(Exit::usage, "family " + name + " asks other operands than " +
                                     std::string(streams.front().family->name) + ": ask for it apart");
    }
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

std::string family_help() {
  return "families, separated by commas (default all of triangles):" + list_of(Operands::triangles) +
         "; or polygon families, by themselves:" + list_of(Operands::polygons);
}

void require_polygons(const Method& method) {
  if (!method.polygon) throw Failure(Exit::usage, method.name + " takes no polygons");
}

unsigned default_threads() { return std::max(1U, std::thread::hardware_concurrency()); }

void add_threads_option(Arguments& arguments, unsigned& threads) {
  threads = default_threads();
  arguments.option("--threads", threads, "worker threads").between(1U, 1024U).shows_default();
}

namespace {

struct PluginOptions {
  std::vector<std::string> files;
  bool isolate = false;
  double time_limit = 5;
};

void add_isolation_options(Arguments& arguments, PluginOptions& o) {
  arguments.flag("--isolate", o.isolate,
                 "run plugins in child processes: a crash, an exit, an exception or a call that "
                 "does not return is a finding, and the run goes on");
  arguments.option("--time-limit", o.time_limit, "seconds within which an isolated plugin must answer")
      .above_zero()
      .shows_default();
  arguments.needs("--isolate", "--plugin");
  arguments.needs("--time-limit", "--isolate");
}

}  // namespace

Action with_plugins(Arguments& arguments, Action action, MayIsolate may_isolate) {
  const auto o = std::make_shared<PluginOptions>();
  arguments.repeatable("--plugin", o->files,
                       "shared library with a method of your own (docs/bring-your-own.md); repeatable");
  if (may_isolate == MayIsolate::yes) add_isolation_options(arguments, *o);
  return [o, action = std::move(action)] {
    for (const std::string& file : o->files) load_plugin(file, o->isolate ? Isolation(o->time_limit) : Isolation());
    const ExitGuard guard(!o->files.empty() && !o->isolate);
    return action();
  };
}

int exit_code_after(int code_if_done, int signal) { return signal != 0 ? 128 + signal : code_if_done; }

}  // namespace tribunal
