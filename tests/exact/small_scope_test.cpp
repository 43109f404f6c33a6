// The whole sets of segments: how many queries they have, and that they do not depend on the threads.
#include "exact/certificate/small_scope.h"

#include <gtest/gtest.h>

#include "exact/methods/methods.h"

namespace tribunal {
namespace {

Method method(const char* name) { return *find_method(name); }

TEST(SmallScope, LinesAndTheLatticeHaveEveryClass) {
  const ScopeResult lines = line_run(method("sf-rational"));
  EXPECT_EQ(lines.count.asked, 40'625U);
  EXPECT_EQ(lines.count.wrong, 0U);
  EXPECT_TRUE(lines.complete);
  const ScopeResult lattice = lattice_run(method("sf-double"), 2, 2);
  EXPECT_EQ(lattice.count.asked, 32'768U);
  EXPECT_EQ(lattice.answers_hash, lattice_run(method("sf-rational"), 2, 1).answers_hash);
}

}  // namespace
}  // namespace tribunal
