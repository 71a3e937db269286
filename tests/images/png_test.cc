#include "sim/images/png.h"

#include <gtest/gtest.h>

#include <numeric>

namespace dockyard {
namespace {

std::vector<std::uint8_t> Ramp(std::size_t count) {
  std::vector<std::uint8_t> ramp(count);
  std::iota(ramp.begin(), ramp.end(), std::uint8_t{7});
  return ramp;
}

TEST(Png, GivesBackThePixelsThatItGot) {
  for (const auto& [width, height] : {std::pair{1, 1}, {37, 5}, {1, 300}, {640, 3}}) {
    const auto count = static_cast<std::size_t>(width * height);
    const GrayImage gray{width, height, Ramp(count)};
    EXPECT_EQ(DecodePng<GrayImage>(EncodePng(gray)), gray);
    const RgbImage rgb{width, height, Ramp(3 * count)};
    EXPECT_EQ(DecodePng<RgbImage>(EncodePng(rgb)), rgb);
  }
}

TEST(Png, OfAnotherKindIsNotDecoded) {
  const std::string gray = EncodePng(GrayImage{4, 3, Ramp(12)});
  const std::string rgb = EncodePng(RgbImage{2, 2, Ramp(12)});
  const std::string deep = EncodePng(DeepImage{2, 1, 12, {0, 4095}});
  for (const std::string& bytes : {rgb, deep, std::string(), std::string("P5 1 1 255\na")}) {
    EXPECT_FALSE(DecodePng<GrayImage>(bytes));
  }
  EXPECT_FALSE(DecodePng<RgbImage>(gray));
  for (std::size_t length = 0; length < gray.size(); ++length) {
    EXPECT_FALSE(DecodePng<GrayImage>(gray.substr(0, length))) << length;
  }
}

TEST(Png, OfTooManyPixelsIsNotDecoded) {
  std::string png = EncodePng(GrayImage{4, 4, Ramp(16)});
  EXPECT_TRUE(DecodePng<GrayImage>(png));
  png.replace(16, 8, std::string("\0\0\x75\x30\0\0\x75\x30", 8));  // 30000 x 30000
  EXPECT_FALSE(DecodePng<GrayImage>(png));
}

}  // namespace
}  // namespace dockyard
