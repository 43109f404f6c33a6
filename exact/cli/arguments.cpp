#include "exact/cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "exact/base/failure.h"
#include "exact/base/shown.h"

namespace tribunal {

struct Arguments::Option::Declared {
  CLI::Option* option;
  bool either_sign = false;
};

struct Arguments::Parser {
  CLI::App* app;
};

struct CommandLine::Parser {
  CLI::App app;
  std::vector<const CLI::App*> commands;
};

// --- options -----------------------------------------------------------------------------------------------------

Arguments::Option Arguments::Option::required() {
  declared_->option->required();
  return *this;
}

Arguments::Option Arguments::Option::shows_default() {
  declared_->option->capture_default_str();
  return *this;
}

Arguments::Option Arguments::Option::above_zero() {
  declared_->option->check([](const std::string& text) {
    double x = 0;
    const bool good = CLI::detail::lexical_cast(text, x) && x > 0;
    return good ? std::string() : "expected a number above 0, found " + text;
  });
  return *this;
}

Arguments::Option Arguments::Option::of_either_sign() {
  declared_->either_sign = true;
  return *this;
}

template <class Number>
Arguments::Option Arguments::Option::between(Number least, Number most) {
  declared_->option->check(CLI::Range(least, most));
  return *this;
}

template Arguments::Option Arguments::Option::between(int, int);
template Arguments::Option Arguments::Option::between(unsigned, unsigned);
template Arguments::Option Arguments::Option::between(unsigned long, unsigned long);
template Arguments::Option Arguments::Option::between(unsigned long long, unsigned long long);

Arguments::Option Arguments::Option::one_of(const std::vector<std::string>& words) {
  declared_->option->check(CLI::IsMember(words));
  return *this;
}

// --- a command ---------------------------------------------------------------------------------------------------

namespace {

/// What is wrong with the text of an integer; empty if nothing is. CLI11 itself would take −3 as 2⁶⁴ − 3.
template <class Integer>
std::string fault_of_integer(const std::string& text) {
  Integer x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  const bool good = error == std::errc{} && end == text.data() + text.size() && x >= 0 && text[0] != '-';
  return good ? std::string() : "expected a whole number in digits, found " + text;
}

std::string fault_of_double(const std::string& text, bool either_sign) {
  double x = 0;
  const bool good = CLI::detail::lexical_cast(text, x) && std::isfinite(x) && (either_sign || x >= 0);
  return good ? std::string() : "expected a number" + std::string(either_sign ? "" : ", 0 or more") + ", found " + text;
}

}  // namespace

template <class Value>
Arguments::Option Arguments::option(const std::string& names, Value& value, const std::string& help) {
  const auto declared = std::make_shared<Option::Declared>(parser_->app->add_option(names, value, help));
  if constexpr (std::is_integral_v<Value>) {
    declared->option->check(fault_of_integer<Value>);
  } else if constexpr (std::is_floating_point_v<Value>) {
    declared->option->check(
        [declared](const std::string& text) { return fault_of_double(text, declared->either_sign); });
  }
  return Option(declared);
}

template Arguments::Option Arguments::option(const std::string&, std::string&, const std::string&);
template Arguments::Option Arguments::option(const std::string&, double&, const std::string&);
template Arguments::Option Arguments::option(const std::string&, int&, const std::string&);
template Arguments::Option Arguments::option(const std::string&, unsigned&, const std::string&);
template Arguments::Option Arguments::option(const std::string&, unsigned long&, const std::string&);
template Arguments::Option Arguments::option(const std::string&, unsigned long long&, const std::string&);

Arguments::Option Arguments::repeatable(const std::string& name, std::vector<std::string>& values,
                                        const std::string& help) {
  return Option(
      std::make_shared<Option::Declared>(parser_->app->add_option(name, values, help)->allow_extra_args(false)));
}

Arguments::Option Arguments::several(const std::string& name, std::vector<std::string>& values,
                                     const std::string& help) {
  return Option(std::make_shared<Option::Declared>(parser_->app->add_option(name, values, help)));
}

void Arguments::flag(const std::string& name, bool& given, const std::string& help) {
  parser_->app->add_flag(name, given, help);
}

void Arguments::needs(const std::string& option, const std::string& other) {
  parser_->app->get_option(option)->needs(parser_->app->get_option(other));
}

void Arguments::excludes(const std::string& option, const std::string& other) {
  parser_->app->get_option(option)->excludes(parser_->app->get_option(other));
}

// --- the whole line ----------------------------------------------------------------------------------------------

namespace {

/// The full name of the command that was being parsed: "tribunal", or "tribunal fuzz".
std::string parsed_name(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app.get_name() : app.get_name() + " " + chosen.front()->get_name();
}

Failure usage_failure(const CLI::App& app, std::string what) {
  std::replace(what.begin(), what.end(), '\n', ' ');
  return Failure(Exit::usage, what + " (see " + parsed_name(app) + " --help)");
}

}  // namespace

CommandLine::CommandLine(const About& about) : parser_(std::make_shared<Parser>()) {
  CLI::App& app = parser_->app;
  app.name(about.name)->description(about.summary);
  app.set_version_flag("--version", about.version);
  app.require_subcommand(0, 1);
  app.footer(about.footer);
}

Arguments CommandLine::add(const std::string& name, const std::string& summary, const std::string& footer) {
  CLI::App* const command = parser_->app.add_subcommand(name, summary)->footer(footer);
  parser_->commands.push_back(command);
  return Arguments(std::make_shared<Arguments::Parser>(command));
}

std::optional<std::string> CommandLine::parse(const std::vector<std::string>& words) {
  CLI::App& app = parser_->app;
  for (const std::string& word : words) {
    if (!shows_as_it_is(word)) throw Failure(Exit::usage, "expected printable UTF-8, found \"" + word + "\"");
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 takes the last word first
    return std::nullopt;
  } catch (const CLI::CallForHelp&) {
    return app.help();
  } catch (const CLI::CallForVersion&) {
    return app.version() + "\n";
  } catch (const CLI::ParseError& error) {
    throw usage_failure(app, error.what());
  }
}

std::optional<std::size_t> CommandLine::chosen() const {
  const auto& commands = parser_->commands;
  const auto found = std::ranges::find_if(commands, [](const CLI::App* command) { return command->parsed(); });
  if (found == commands.end()) return std::nullopt;
  return static_cast<std::size_t>(found - commands.begin());
}

std::string CommandLine::help() const { return parser_->app.help(); }

}  // namespace tribunal
