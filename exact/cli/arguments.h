// What a command line may say. The library that reads it, CLI11, takes seconds to compile wherever it is included:
// arguments.cpp includes it, and nothing else does.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tribunal {

/// The options of one command. A variable that is declared here holds the default value until the command line is
/// parsed, and must live until then.
class Arguments {
 public:
  /// What more can be said of an option when it is declared. Each function returns the option itself.
  class Option {
   public:
    /// The command line must give the option.
    Option required();
    /// The help shows the value that the variable holds now.
    Option shows_default();
    /// The value is a number above 0.
    Option above_zero();
    /// The value is a number of either sign, not 0 or more.
    Option of_either_sign();
    /// The value is a number of this type from `least` to `most`, both allowed.
    template <class Number>
    Option between(Number least, Number most);
    /// The value is one of these words.
    Option one_of(const std::vector<std::string>& words);

   private:
    friend class Arguments;
    struct Declared;
    explicit Option(std::shared_ptr<Declared> declared) : declared_(std::move(declared)) {}
    std::shared_ptr<Declared> declared_;
  };

  /// Declares an option by its names, separated by commas: "-o,--out". A name without dashes is that of an argument
  /// known by its place, and "--in,FILE" of one that may stand either way. `Value` is a string, a double, an int or an
  /// unsigned integer. An integer is 0 or more, in digits alone; a double is finite, and 0 or more unless more is said.
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help);

  /// Declares an option that may be given several times, each time with one value.
  Option repeatable(const std::string& name, std::vector<std::string>& values, const std::string& help);

  /// Declares an argument known by its place that may stand several times, one after the other.
  Option several(const std::string& name, std::vector<std::string>& values, const std::string& help);

  /// Declares an option without a value.
  void flag(const std::string& name, bool& given, const std::string& help);

  /// Whoever gives the option must give the other one too. Both are declared before.
  void needs(const std::string& option, const std::string& other);

  /// Whoever gives the option may not give the other one. Both are declared before.
  void excludes(const std::string& option, const std::string& other);

 private:
  friend class CommandLine;
  struct Parser;
  explicit Arguments(std::shared_ptr<Parser> parser) : parser_(std::move(parser)) {}
  std::shared_ptr<Parser> parser_;
};

/// What the help and the version of a program say: its name, and what stands above and below its list of commands.
struct About {
  std::string name, summary, footer, version;
};

/// The command line of a program with commands, of which it takes one or none.
class CommandLine {
 public:
  explicit CommandLine(const About& about);

  /// Adds a command, which then declares its options. The footer ends its help.
  Arguments add(const std::string& name, const std::string& summary, const std::string& footer);

  /// Reads the words after the program's name. Returns the help or the version if they ask for it: no command is to be
  /// run then. Fails with Exit::usage on a word that was not declared, or a value that was not allowed.
  std::optional<std::string> parse(const std::vector<std::string>& words);

  /// The command that was named, counted from 0 in the order of add(), if one was.
  std::optional<std::size_t> chosen() const;

  /// The help of the program, or of the command that was named.
  std::string help() const;

 private:
  struct Parser;
  std::shared_ptr<Parser> parser_;
};

}  // namespace tribunal
