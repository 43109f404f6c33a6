// What several commands share.
#include <algorithm>
#include <charconv>
#include <sstream>
#include <thread>

#include "exact/cli/command.h"
#include "exact/io/failure.h"
#include "exact/io/json.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

const Method& method_named(const std::string& name) {
  if (const Method* found = find_method(name)) return *found;
  std::vector<std::string> names;
  for (const Method& m : all_methods()) names.push_back(m.name);
  throw Failure(Exit::usage, "unknown method \"" + name + "\", did you mean \"" + nearest(name, names) +
                                 "\"? `tribunal methods` lists them");
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
  for (const std::string& name : split(comma_separated)) methods.push_back(method_named(name));
  if (methods.empty()) throw Failure(Exit::usage, "no method given, expected names separated by commas");
  return methods;
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

int exit_code_after(int code_if_done, int signal) { return signal != 0 ? 128 + signal : code_if_done; }

}  // namespace tribunal
