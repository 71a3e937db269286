#include "controller/stereo/plain_parts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "sim/base/random.h"

namespace dockyard {
namespace {

constexpr int kPlainWidth = 80, kPlainHeight = 60;

// Noise of 1 grey everywhere; stains of 6 grey, 3 px wide, on the left half.
GrayImage HalfStained() {
  RandomStream random(1);
  GrayImage image{kPlainWidth, kPlainHeight, {}};
  for (int v = 0; v < kPlainHeight; ++v) {
    for (int u = 0; u < kPlainWidth; ++u) {
      const double stain = u < kPlainWidth / 2 && (u / 3 + v / 3) % 2 == 0 ? 6.0 : 0.0;
      const double grey = 100.0 + stain + random.Normal();
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(grey)));
    }
  }
  return image;
}

TEST(PlainParts, LoseTheirDisparitiesAndStainedOnesKeepThem) {
  const GrayImage image = HalfStained();
  const Disparities all{kPlainWidth, kPlainHeight, std::vector<float>(image.pixels.size(), 20.0F)};
  const Disparities kept = WithoutPlainParts(all, image);
  int left = 0, right = 0;
  for (int v = 0; v < kPlainHeight; ++v) {
    for (int u = 0; u < kPlainWidth; ++u) {
      if (std::isnan(kept.at(u, v))) continue;
      (u < kPlainWidth / 2 ? left : right) += 1;
    }
  }
  EXPECT_EQ(left, kPlainHeight * kPlainWidth / 2);
  // Within half a block of the stains they still count.
  EXPECT_LE(right, kPlainHeight * 6);
}

TEST(PlainParts, AreRefusedForAnotherPicturesDisparities) {
  EXPECT_DEATH(WithoutPlainParts({3, 3, std::vector<float>(9)}, HalfStained()), "check failed");
}

}  // namespace
}  // namespace dockyard
