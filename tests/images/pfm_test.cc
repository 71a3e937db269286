#include "sim/images/pfm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace dockyard {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

TEST(Pfm, ReadsBackWhatItWrote) {
  const FloatImage image{3, 2, {0.0F, 300.25F, -1.5F, 1e-30F, 1024.0F, kInf}};
  EXPECT_EQ(DecodePfm(EncodePfm(image)), image);
}

// By hand after the format's page (P. Debevec): bottom row first, scale's sign the byte order.
TEST(Pfm, HasTheBottomRowFirstAndNothingAsInfinity) {
  const FloatImage image{1, 2, {1.0F, std::nanf("")}};
  const std::string bytes = EncodePfm(image);
  const std::string inf("\x00\x00\x80\x7f", 4), one("\x00\x00\x80\x3f", 4);
  EXPECT_EQ(bytes, "Pf\n1 2\n-1.0\n" + inf + one);
}

TEST(Pfm, ReadsEitherByteOrder) {
  const auto image = DecodePfm(std::string("Pf 2 1 1.0\n") + std::string("\x3f\x80\x00\x00", 4) +
                               std::string("\x43\x96\x00\x00", 4));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->pixels, (std::vector<float>{1.0F, 300.0F}));
}

TEST(Pfm, ReadsNothingElse) {
  const std::string number(4, '\0');
  for (const std::string& bytes :
       {std::string(), std::string("Pf"), "PF\n1 1\n-1\n" + number, "Pf\n0 1\n-1\n" + number,
        "Pf\n1 2\n-1\n" + number, "Pf\n1 -1\n-1\n" + number, "Pf\n1 1\n0\n" + number,
        "Pf\n99999 99999\n-1\n" + number, "Pf\n1x 1\n-1\n" + number}) {
    EXPECT_FALSE(DecodePfm(bytes)) << bytes;
  }
}

}  // namespace
}  // namespace dockyard
