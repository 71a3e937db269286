#include "sim/base/crc32.h"

#include <gtest/gtest.h>

#include <string>

namespace dockyard {
namespace {

TEST(Crc32, IsThatOfTheStandard) {
  EXPECT_EQ(Crc32("123456789"), 0xcbf43926u);  // the check value of ITU-T V.42
  EXPECT_EQ(Crc32(""), 0u);
}

TEST(Crc32, ChangesWithEachBit) {
  const std::string row = "17,123456789,docked,0.30000000000000004";
  for (std::size_t bit = 0; bit < 8 * row.size(); ++bit) {
    std::string changed = row;
    changed[bit / 8] = static_cast<char>(changed[bit / 8] ^ (1 << bit % 8));
    EXPECT_NE(Crc32(changed), Crc32(row)) << bit;
  }
}

}  // namespace
}  // namespace dockyard
