#include "sim/base/environment.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "sim/base/hash.h"
#include "sim/base/math_pin.h"

namespace dockyard {
namespace {

std::string Value(const std::string& name) {
  for (const Fact& fact : Environment()) {
    if (fact.name == name) return fact.value;
  }
  return "(no such fact)";
}

TEST(Environment, NamesEachFactOnceInALineWithoutCommas) {
  std::set<std::string> names;
  for (const Fact& fact : Environment()) {
    EXPECT_TRUE(names.insert(fact.name).second) << fact.name;
    EXPECT_FALSE(fact.value.empty()) << fact.name;
    EXPECT_EQ(fact.value.find_first_of(",\n\""), std::string::npos) << fact.value;
    EXPECT_NE(fact.value, "unknown") << fact.name;
  }
  EXPECT_EQ(Environment(), Environment());
}

TEST(Environment, SaysWhetherTheMathematicsIsPinned) {
  const char* before = std::getenv("GLIBC_TUNABLES");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("GLIBC_TUNABLES", PinnedTunables("").c_str(), 1);
  EXPECT_EQ(Value("variants"), "pinned");
  ::setenv("GLIBC_TUNABLES", "glibc.malloc.check=1", 1);
  EXPECT_EQ(Value("variants"), "of the processor");
  before == nullptr ? ::unsetenv("GLIBC_TUNABLES") : ::setenv("GLIBC_TUNABLES", kept.c_str(), 1);
  EXPECT_EQ(Value("mathematics"), HexText(MathFingerprint()));
}

TEST(HexText, HasSixteenDigits) {
  EXPECT_EQ(HexText(0), "0000000000000000");
  EXPECT_EQ(HexText(0x0123456789abcdefull), "0123456789abcdef");
}

}  // namespace
}  // namespace dockyard
