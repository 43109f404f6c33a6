#include "exact/methods.h"

#include <cstdio>
#include <memory>

#include "exact/cli/command.h"
#include "exact/io/files.h"
#include "exact/io/json.h"

namespace tribunal {
namespace {

std::string table() {
  std::string text;
  char line[400];
  std::snprintf(line, sizeof line, "%-14s %-27s %-41s %-12s %s\n", "method", "number type", "contract", "convention",
                "what it does (reference)");
  text += line;
  for (const Method& m : all_methods()) {
    std::snprintf(line, sizeof line, "%-14s %-27s %-41s %-12s %s (%s)\n", m.name.c_str(), m.number.c_str(),
                  m.contract.c_str(), std::string(name_of(m.convention)).c_str(), m.summary.c_str(),
                  m.reference.c_str());
    text += line;
  }
  return text +
         "\nclosed: a hit iff the point sets meet. transversal: the same, but a probe in the triangle's plane is a "
         "miss.\n";
}

std::string lines() {
  std::string text;
  for (const Method& m : all_methods()) {
    const Json row = {
        {"name", m.name},   {"number", m.number},   {"contract", m.contract},  {"convention", name_of(m.convention)},
        {"exact", m.exact}, {"summary", m.summary}, {"reference", m.reference}};
    text += row.dump() + "\n";
  }
  return text;
}

}  // namespace

Action declare_methods(CLI::App& app) {
  const auto json = std::make_shared<bool>(false);
  app.add_flag("--json", *json, "print JSON Lines instead of a table");
  return with_plugins(app, [json] {
    print(*json ? lines() : table());
    return 0;
  });
}

}  // namespace tribunal
