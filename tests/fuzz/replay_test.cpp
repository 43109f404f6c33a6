// Every input that fuzzing has kept, once more: none may be accepted wrongly, or end the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "exact/base/files.h"
#include "tests/fuzz/targets.h"

namespace tribunal::fuzzing {

/// The name of a test tells its target by this.
static void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus(const std::string& name) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator("data/corpora/" + name)) files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

class Corpora : public testing::TestWithParam<Target> {};

TEST_P(Corpora, AreAcceptedRightlyOrRefused) {
  const std::vector<std::string> files = corpus(GetParam().name);
  ASSERT_GT(files.size(), 9u) << "hardly anything to replay";
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const std::string bytes = read_file(file);
    const std::vector<char> block(bytes.begin(), bytes.end());  // of exactly this size, for the sanitizers
    EXPECT_NO_THROW(GetParam().run({block.data(), block.size()}));
  }
}

TEST_P(Corpora, CutShortAreAcceptedRightlyOrRefused) {
  for (const std::string& file : corpus(GetParam().name)) {
    SCOPED_TRACE(file);
    const std::string bytes = read_file(file);
    for (const std::size_t part : {1, 2, 3}) {
      const std::vector<char> block(bytes.begin(),
                                    bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() * part / 4));
      EXPECT_NO_THROW(GetParam().run({block.data(), block.size()}));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzzed, Corpora, testing::ValuesIn(targets),
                         [](const auto& target) { return std::string(target.param.name); });

TEST(CorporaFolder, HasAFolderForEveryTargetAndNoOther) {
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator("data/corpora")) folders += entry.is_directory();
  EXPECT_EQ(folders, std::size(targets));
}

TEST(FuzzTargets, TellAViolation) {
  EXPECT_THROW(accepts([] { throw Failure(Exit::resources, "x"); }), Violation);
  EXPECT_THROW(accepts([] { throw Failure(Exit::bad_input, ""); }), Violation);
  EXPECT_THROW(demand(false, "x"), Violation);
  EXPECT_FALSE(accepts([] { throw Failure(Exit::bad_input, "x"); }));
}

}  // namespace
}  // namespace tribunal::fuzzing
