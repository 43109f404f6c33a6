// What a thread computes in: it is looked at whole, repaired where a thread begins, and refused where work ends.
#include <gtest/gtest.h>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/fp_environment.h"
#include "exact/base/parallel.h"

namespace tribunal {
namespace {

/// Bits that are turned off and on, of MXCSR and of the x87 unit's control word.
struct Change {
  const char* name;
  unsigned sse_off, sse_on;
  unsigned short x87_off, x87_on;
};

constexpr Change changes[] = {
    {"flush to zero", 0, 0x8000, 0, 0},    {"denormals are zero", 0, 0x0040, 0, 0}, {"rounding down", 0, 0x2000, 0, 0},
    {"rounding up, x87", 0, 0, 0, 0x0800}, {"53 bits, x87", 0, 0, 0x0300, 0x0200},  {"24 bits, x87", 0, 0, 0x0300, 0},
    {"a trap", 0x1000, 0, 0, 0},           {"a trap, x87", 0, 0, 0x0020, 0},
};

void make(const Change& change) {
  unsigned short x87 = 0;
  __asm__ volatile("fnstcw %0" : "=m"(x87));
  x87 = static_cast<unsigned short>((x87 & ~change.x87_off) | change.x87_on);
  __asm__ volatile("fnclex; fldcw %0" : : "m"(x87));
  __builtin_ia32_ldmxcsr((__builtin_ia32_stmxcsr() & ~change.sse_off & ~0x3fU) | change.sse_on);
}

/// The exit code that the call fails with; 0 if it does not.
template <class Call>
int exit_of(const Call& call) {
  try {
    call();
  } catch (const Failure& failure) {
    return code(failure.exit());
  }
  return 0;
}

TEST(Environment, EveryChangeIsSeenAndRepaired) {
  ASSERT_FALSE(require_exact_rounding());
  for (const Change& change : changes) {
    make(change);
    const bool seen = !has_exact_rounding(), repaired = require_exact_rounding();
    EXPECT_TRUE(seen) << change.name;
    EXPECT_TRUE(repaired) << change.name;
    EXPECT_TRUE(has_exact_rounding()) << change.name;
  }
}

TEST(Environment, NothingIsWrittenInAnother) {
  const std::string file = testing::TempDir() + "written_in_another_environment";
  for (const Change& change : changes) {
    make(change);
    const int refused = exit_of([&] { write_file(file, "text"); });
    EXPECT_EQ(refused, code(Exit::fp_environment)) << change.name;
    EXPECT_THROW(read_file(file), Failure) << change.name;
    EXPECT_TRUE(has_exact_rounding()) << change.name;
  }
}

TEST(Environment, ABlockThatChangesItIsRefusedInEveryThread) {
  for (const Change& change : changes) {
    for (const unsigned threads : {1U, 2U}) {
      const auto work = [&](std::size_t, unsigned) { make(change); };
      EXPECT_EQ(exit_of([&] { run_blocks(2, threads, work); }), code(Exit::fp_environment)) << change.name;
      EXPECT_TRUE(has_exact_rounding()) << change.name;
    }
  }
}

TEST(Environment, WorkThatBeginsInAnotherIsRefused) {
  for (const Change& change : changes) {
    make(change);
    const int refused = exit_of([] { run_blocks(1, 1, [](std::size_t, unsigned) {}); });
    EXPECT_EQ(refused, code(Exit::fp_environment)) << change.name;
  }
}

}  // namespace
}  // namespace tribunal
