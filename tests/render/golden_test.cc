// Images against those that somebody last checked by sight; and that a change would be noticed.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>

#include "render/golden_views.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

GrayImage Kept(const GoldenView& view) {
  return ReadPng(SourceFile("tests/render/golden/") + view.name + ".png");
}

ImageDifference FromKept(const GoldenView& view, const GrayImage& drawn) {
  const ImageDifference d = Compare(Kept(view), drawn);
  std::printf("%s: mean %.3f levels, %.3f %% of the pixels off by more than 4, a block by %.2f\n",
              view.name, d.mean, 100.0 * d.beyond_4, d.block);
  return d;
}

class Golden : public testing::TestWithParam<GoldenView> {};

TEST_P(Golden, ImageIsStillTheSame) {
  const GoldenView& view = GetParam();
  const GrayImage drawn = DrawGolden(*GoldenYard(view), GoldenRig());
  const bool same = FromKept(view, drawn).small();
  EXPECT_TRUE(same);
  if (!same) {
    const std::string path = std::string(testing::TempDir()) + view.name + "_drawn.png";
    WritePng(path, drawn);
    std::printf("the image as drawn now: %s\n", path.c_str());
  }
}

// The other way round: differences that the tolerance must not let through.

TEST_P(Golden, APixelsShiftIsSeen) {
  StereoRig rig = GoldenRig();
  std::get<KannalaBrandt>(rig.left.lens).cx += 1.0;
  EXPECT_FALSE(FromKept(GetParam(), DrawGolden(*GoldenYard(GetParam()), rig)).small());
}

TEST_P(Golden, AMissingSunIsSeen) {
  const auto yard = GoldenYard(GetParam());
  yard->scene.light.sun_irradiance = 0.0;
  EXPECT_FALSE(FromKept(GetParam(), DrawGolden(*yard, GoldenRig())).small());
}

TEST_P(Golden, AMissingArmIsSeen) {
  const auto yard = GoldenYard(GetParam());
  yard->scene.objects.erase(yard->scene.objects.begin() + 7);
  EXPECT_FALSE(FromKept(GetParam(), DrawGolden(*yard, GoldenRig())).small());
}

TEST(GoldenShadow, ATurnOfTheSunByTwoDegreesIsSeen) {
  const GoldenView& view = GoldenViews().back();
  ASSERT_EQ(view.light, Light::kHardShadow);
  const auto yard = GoldenYard(view);
  yard->scene.light.to_sun_W = (RotZ(Radians(2.0)) * yard->scene.light.to_sun_W).eval();
  EXPECT_FALSE(FromKept(view, DrawGolden(*yard, GoldenRig())).small());
}

TEST(GoldenImages, AreAllInUse) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SourceFile("tests/render/golden"))) {
    files += entry.path().extension() == ".png";
  }
  EXPECT_EQ(files, static_cast<int>(GoldenViews().size()));
}

INSTANTIATE_TEST_SUITE_P(Views, Golden, testing::ValuesIn(GoldenViews()), [](const auto& info) {
  std::string name = info.param.name;
  for (char& c : name) c = c == '.' ? '_' : c;
  return name;
});

}  // namespace
}  // namespace dockyard
