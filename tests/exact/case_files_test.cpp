// The case files of data/cases that state their answer: every exact method must give it to each case that it takes.
#include <gtest/gtest.h>

#include "exact/base/files.h"
#include "exact/cases/case_io.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {
struct FileOfCases {
  const char* path;
  std::size_t cases;
};

/// Files of cases that were reported in the field, or found by attacks on this program; the files name the sources.
constexpr FileOfCases files[] = {{"data/cases/published-reports.jsonl", 569},
                                 {"data/cases/published-rivals.jsonl", 4},
                                 {"data/cases/ray-scales.jsonl", 5}};

TEST(CaseFiles, AreAnsweredAsTheySayByEveryExactMethod) {
  for (const FileOfCases& file : files) {
    const std::vector<Case> cases = read_cases(file.path);
    EXPECT_EQ(cases.size(), file.cases) << file.path;
    std::size_t judged = 0;
    for (const Case& c : cases) {
      ASSERT_TRUE(c.expect.has_value()) << file.path << " " << c.id;
      for (const Method& m : all_methods()) {
        if (!m.contract.exact) continue;
        const Answer answer = m.ask(c.query);
        if (answer.status != Status::ok) continue;
        ++judged;
        EXPECT_EQ(answer.hit, *c.expect) << file.path << " " << c.id << " by " << m.name;
      }
    }
    EXPECT_GE(judged, 4 * cases.size()) << file.path;
  }
}

}  // namespace
}  // namespace tribunal
