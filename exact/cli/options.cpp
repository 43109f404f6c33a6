// What several commands share.
#include <algorithm>
#include <charconv>
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

CLI::Validator above_zero() {
  return CLI::Validator(
      [](std::string& text) {
        double x = 0;
        const bool good = CLI::detail::lexical_cast(text, x) && x > 0;
        return good ? std::string() : "expected a number above 0, found " + text;
      },
      "");
}

CLI::Validator whole_number() {
  return CLI::Validator(
      [](std::string& text) {
        std::uint64_t x = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
        const bool good = error == std::errc{} && end == text.data() + text.size();
        return good ? std::string() : "expected a whole number in digits, found " + text;
      },
      "");
}

void add_threads_option(CLI::App& app, unsigned& threads) {
  threads = default_threads();
  app.add_option("--threads", threads, "worker threads")->check(CLI::Range(1U, 1024U))->capture_default_str();
}

namespace {

struct PluginOptions {
  std::vector<std::string> files;
  bool isolate = false;
  double time_limit = 5;
};

void add_isolation_options(CLI::App& app, PluginOptions& o, CLI::Option* plugin) {
  auto* const isolate = app.add_flag("--isolate", o.isolate,
                                     "run plugins in child processes: a crash, an exit, an exception or a call that "
                                     "does not return is a finding, and the run goes on");
  isolate->needs(plugin);
  app.add_option("--time-limit", o.time_limit, "seconds within which an isolated plugin must answer")
      ->check(above_zero())
      ->capture_default_str()
      ->needs(isolate);
}

}  // namespace

Action with_plugins(CLI::App& app, Action action, MayIsolate may_isolate) {
  const auto o = std::make_shared<PluginOptions>();
  auto* const plugin = app.add_option("--plugin", o->files,
                                      "shared library with a method of your own (docs/bring-your-own.md); repeatable");
  plugin->allow_extra_args(false);
  if (may_isolate == MayIsolate::yes) add_isolation_options(app, *o, plugin);
  return [o, action = std::move(action)] {
    for (const std::string& file : o->files) load_plugin(file, o->isolate ? Isolation(o->time_limit) : Isolation());
    const ExitGuard guard(!o->files.empty() && !o->isolate);
    return action();
  };
}

int exit_code_after(int code_if_done, int signal) { return signal != 0 ? 128 + signal : code_if_done; }

}  // namespace tribunal
