// Colour of light and of images, dust; and that grey is the luminance of colour.
#include <gtest/gtest.h>

#include <cmath>

#include "render/blackbody.h"
#include "render/board_ink.h"
#include "render/measure.h"
#include "render/shading.h"

namespace dockyard {
namespace {

TEST(Blackbody, HasThePublishedChromaticities) {
  // Planckian locus, CIE 1931 (Wyszecki and Stiles, Color Science, 2nd ed.): illuminant A, a
  // black body at 2856 K, has x 0.4476, y 0.4074; one at 6500 K x 0.3135, y 0.3237.
  const Eigen::Vector2d a = BlackbodyChromaticity(2856.0), day = BlackbodyChromaticity(6500.0);
  EXPECT_NEAR(a.x(), 0.4476, 1e-3);  // the fit's own error
  EXPECT_NEAR(a.y(), 0.4074, 1e-3);
  EXPECT_NEAR(day.x(), 0.3135, 5e-4);
  EXPECT_NEAR(day.y(), 0.3237, 5e-4);
}

TEST(Blackbody, LowSunIsRedderAndNoBrighter) {
  const Eigen::Vector3d low = BlackbodyRgb(3500), high = BlackbodyRgb(6500);
  EXPECT_GT(low.x() / low.z(), 2.0 * high.x() / high.z());
  EXPECT_NEAR(Luminance(low), 1.0, 1e-12);
  EXPECT_NEAR(Luminance(high), 1.0, 1e-12);
}

TEST(Colour, LuminanceIsTheGreyImage) {
  auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  yard->scene.light.sun_rgb = BlackbodyRgb(4500);
  yard->scene.light.sky_rgb = BlackbodyRgb(9000);
  yard->scene.boards[0].dust_cover = 0.2;
  yard->scene.objects[0].albedo = {0.7, 0.3, 0.1};
  const StereoRig rig = SampleRig(320, 240);
  StereoRenderer renderer;
  const auto grey = renderer.RenderRadiance(yard->scene, rig, yard->X_WR);
  const auto colour = renderer.RenderColour(yard->scene, rig, yard->X_WR);
  const Eigen::Vector3d share = ChannelWeights(Channel::kGrey);
  double worst = 0.0, least_alike = 0.0;
  for (int view = 0; view < 2; ++view) {
    for (std::size_t i = 0; i < grey[view].values.size(); ++i) {
      const double r = colour[view][0].values[i], g = colour[view][1].values[i],
                   b = colour[view][2].values[i];
      const double luminance = share[0] * r + share[1] * g + share[2] * b;
      worst = std::max(worst, std::abs(luminance / grey[view].values[i] - 1.0));
      least_alike = std::max(least_alike, r / b);
    }
  }
  EXPECT_LT(worst, 1e-5);
  EXPECT_GT(least_alike, 3.0) << "the painted station is red";
}

TEST(Colour, OfWhiteLightOnGreyIsGrey) {
  Scene scene = BoardOnly();
  const StereoRig rig =
      RigAt(EquidistantCamera(160, 120, kPi / 2), LookAt({1.5, 0, 0.7}, {0, 0, 0.7}));
  const auto colour = StereoRenderer().RenderColour(scene, rig, {});
  for (std::size_t i = 0; i < colour[0][0].values.size(); ++i) {
    ASSERT_NEAR(colour[0][0].values[i], colour[0][2].values[i], 1e-6);
  }
}

TEST(Dust, CoversTheShareAskedForAndStaysWhereItIs) {
  BoardView board;
  board.dust_cover = 0.3;
  board.dust_seed = 5;
  double sum = 0.0, least = 1.0, most = 0.0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 400; ++x) {
      const float share = DustShare(board, {-0.8f + 0.004f * x, -0.4f + 0.004f * y});
      sum += share;
      least = std::min<double>(least, share);
      most = std::max<double>(most, share);
    }
  }
  EXPECT_NEAR(sum / 80000, 0.3, 0.03);
  EXPECT_LT(least, 0.2);
  EXPECT_GT(most, 0.4);
  EXPECT_EQ(DustShare(board, {0.1f, 0.1f}), DustShare(board, {0.1f, 0.1f}));
}

TEST(Dust, SpotIsDustierThanTheRestAndEndsAtItsRim) {
  BoardView board;
  board.dust_seed = 5;
  board.dusty_spots = {{.p_B = {0.2, 0.1}, .radius_m = 0.3, .cover = 0.8}};
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 400; ++x) {
      const Eigen::Vector2f p_B(-0.8f + 0.004f * x, -0.4f + 0.004f * y);
      const float share = DustShare(board, p_B);
      const float away = (p_B - Eigen::Vector2f(0.2f, 0.1f)).norm();
      if (away > 0.3001f) {
        EXPECT_EQ(share, 0.0f);
      } else if (away < 0.2999f) {
        EXPECT_GE(share, 0.4f);
        sum += share;
        ++count;
      }
    }
  }
  EXPECT_NEAR(sum / count, 0.8, 0.08);
}

TEST(Dust, LowersTheContrastByItsShare) {
  Scene scene = BoardOnly();
  const StereoRig rig =
      RigAt(EquidistantCamera(640, 480, kPi / 2), LookAt({1.0, 0, 0.7}, {0, 0, 0.7}));
  StereoRenderer renderer;
  const auto clean = renderer.RenderRadiance(scene, rig, {})[0];
  scene.boards[0].dust_cover = 0.3;
  const auto dusty = renderer.RenderRadiance(scene, rig, {})[0];
  // On the board's pixels the image moves towards the dust's own radiance, pixel by pixel.
  const double dust =
      UnshadedRadiance(scene.light, {1, 0, 0}, Luminance(scene.boards[0].dust_albedo));
  double share = 0.0;
  int count = 0;
  for (int y = 180; y < 300; y += 3) {
    for (int x = 200; x < 440; x += 3) {
      const double moved = (dusty.at(x, y) - clean.at(x, y)) / (dust - clean.at(x, y));
      EXPECT_GE(moved, 0.1);
      EXPECT_LE(moved, 0.5);
      share += moved;
      ++count;
    }
  }
  EXPECT_NEAR(share / count, 0.3, 0.05);
}

}  // namespace
}  // namespace dockyard
