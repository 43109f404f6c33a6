#include <cmath>

#include "exact/cases/case_io.h"
#include "exact/record/chain.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/targets.h"

namespace tribunal::fuzzing {
namespace {

/// What is written of a case is read as the same case.
void demand_same_again(const Case& c) {
  const std::string line = from_case(c).dump();
  const std::vector<Case> again = cases_in(line + "\n", "again");
  demand(again.size() == 1 && from_case(again[0]).dump() == line, "read again it is another case: " + line);
}

}  // namespace

void cases(std::string_view bytes) {
  accepts([&] {
    const std::vector<Case> read = cases_in(bytes, "fuzzed");
    demand(!read.empty(), "a file without cases was accepted");
    for (const Case& c : read) demand_same_again(c);
  });
}

void chain(std::string_view bytes) {
  const MemoryFile file(bytes);
  accepts([&] {
    const LogRecords log = read_log(file.path());
    ChainedLog again;
    for (const Json& r : log.records) again.add(r);
    demand(again.finish() == bytes, "an accepted log is written otherwise");
  });
}

}  // namespace tribunal::fuzzing
