#include "exact/certificate/verify.h"

#include <cstdio>

#include "exact/certificate/small_scope.h"
#include "exact/harness/counterexample.h"
#include "exact/io/files.h"
#include "exact/io/polygon_case_io.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

void compare(Verification& v, const std::string& path, const std::string& due) {
  if (read_file(path) != due) v.faults.push_back(path + " is not what the log gives");
}

template <class C>
bool is_counterexample(const C& c) {
  const auto truth = exact_truth(c.query);
  const bool transversal = c.finding.value("convention", "") == name_of(Convention::transversal);
  const bool due = counts_as_hit(truth.contact, transversal ? Convention::transversal : Convention::closed);
  return mistaken_claim(c, truth).empty() && c.finding.value("expected", -1) == (due ? 1 : 0) &&
         c.finding.value("answered", -1) == (due ? 0 : 1) &&
         c.finding.value("exact", Json()) == exact_evidence(c.query);
}

/// Judged by the oracles, not by the method: a counterexample stands on its own.
void confirm(Verification& v, const Json& line) {
  const AnyCase any = to_any_case(line, {"log.jsonl"});
  std::visit(
      [&](const auto& c) {
        if (is_counterexample(c)) {
          ++v.confirmed;
        } else {
          v.faults.push_back("counterexample " + c.id + " is none");
        }
      },
      any);
}

template <class On>
void compare(Verification& v, const BasicScopeResult<On>& again) {
  char hash[20];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(again.answers_hash));
  const ProvedSet& logged = v.certificate.proved.front();
  if (logged.answers_hash != hash || logged.count != again.count) {
    v.faults.push_back("the set \"" + logged.name + "\", run again, gives other answers");
  }
  v.asked_again = again.size;
}

void ask_again(Verification& v) {
  const Method* method = find_method(v.certificate.method());
  if (v.certificate.proved.empty()) {
    v.not_asked = "its answers came from a file";
  } else if (method == nullptr) {
    v.not_asked = "the method is not known here";
  } else if (v.certificate.operands() == Operands::triangles) {
    compare(v, pocket_run(*method));
  } else if (method->polygon) {
    compare(v, pocket_of_rings_run(*method));
  } else {
    v.not_asked = "the method of this name takes no polygons here";
  }
}

}  // namespace

Verification verify(const std::string& directory) {
  const std::string path = directory + "/log.jsonl";
  Verification v{certificate_from(read_log(path), path)};
  compare(v, directory + "/certificate.json", to_json(v.certificate).dump(1) + "\n");
  compare(v, directory + "/certificate.md", to_markdown(v.certificate));
  compare(v, directory + "/counterexamples.jsonl", counterexample_lines(v.certificate));
  for (const Json& line : v.certificate.counterexamples) confirm(v, line);
  ask_again(v);
  return v;
}

}  // namespace tribunal
