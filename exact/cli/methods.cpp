#include "exact/methods/methods.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include "exact/base/files.h"
#include "exact/base/json.h"
#include "exact/cli/command.h"
#include "exact/record/contract_json.h"

namespace tribunal {
namespace {

std::string table() {
  std::string text;
  char line[400];
  constexpr const char* row = "%-22s %-27s %-67s %-12s %s (%s)\n";
  std::snprintf(line, sizeof line, row, "method", "number type", "contract", "convention", "what it does", "reference");
  text += line;
  for (const Method& m : all_methods()) {
    std::snprintf(line, sizeof line, row, m.name.c_str(), m.card.number.c_str(), in_words(m.contract).c_str(),
                  std::string(name_of(m.contract.convention)).c_str(), m.card.summary.c_str(),
                  m.card.reference.c_str());
    text += line;
  }
  return text +
         "\nclosed: a hit iff the point sets meet. transversal: the same, but a probe in the triangle's plane is a "
         "miss. unspecified: nothing is promised of such a probe that meets the triangle.\n";
}

template <class Values>
Json names_of(const Values& values) {
  Json names = Json::array();
  for (const auto v : values) names.push_back(name_of(v));
  return names;
}

Json capabilities_of(const Method& m) {
  std::vector<Capability> held;
  std::ranges::copy_if(all_capabilities, std::back_inserter(held), [&](Capability c) { return has(m, c); });
  return names_of(held);
}

std::string lines() {
  std::string text;
  for (const Method& m : all_methods()) {
    const Json row = {{"name", m.name},
                      {"number", m.card.number},
                      {"contract", in_words(m.contract)},
                      {"convention", name_of(m.contract.convention)},
                      {"exact", m.contract.exact},
                      {"summary", m.card.summary},
                      {"reference", m.card.reference},
                      {"terms", from_contract(m.contract)},
                      {"capabilities", capabilities_of(m)},
                      {"roles", names_of(roles_of(m))}};
    text += row.dump() + "\n";
  }
  return text;
}

}  // namespace

Action declare_methods(Arguments& arguments) {
  const auto json = std::make_shared<bool>(false);
  arguments.flag("--json", *json, "print JSON Lines instead of a table");
  return with_plugins(arguments, [json] {
    print(*json ? lines() : table());
    return 0;
  });
}

}  // namespace tribunal
