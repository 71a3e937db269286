#include "sim/base/math_pin.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

TEST(PinnedTunables, SwitchOffFusedMultiplyAddAndKeepTheRest) {
  EXPECT_EQ(PinnedTunables(""), "glibc.cpu.hwcaps=-FMA,-FMA4");
  EXPECT_EQ(PinnedTunables("glibc.malloc.check=1"),
            "glibc.malloc.check=1:glibc.cpu.hwcaps=-FMA,-FMA4");
  EXPECT_EQ(PinnedTunables("glibc.cpu.hwcaps=-AVX2:glibc.malloc.check=1"),
            "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4:glibc.malloc.check=1");
  EXPECT_EQ(PinnedTunables("glibc.cpu.hwcaps=-FMA4,-FMA"), "glibc.cpu.hwcaps=-FMA4,-FMA");
}

// Else the program would start again for ever.
TEST(PinnedTunables, AreTheirOwnPinnedTunables) {
  for (const char* tunables : {"", "glibc.cpu.hwcaps=", "a=b:glibc.cpu.hwcaps=-AVX2", "a=b:"}) {
    const std::string pinned = PinnedTunables(tunables);
    EXPECT_EQ(PinnedTunables(pinned), pinned) << tunables;
  }
}

}  // namespace
}  // namespace dockyard
