// Motion blur against closed forms and against many more views.
#include "render/shutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "render/scene_samples.h"

namespace dockyard {
namespace {

constexpr int kWidth = 120, kHeight = 4;

/// An edge at x0, blurred by 1.5 px so that its samples hold its moments.
RadianceImage EdgeAt(double x0) {
  RadianceImage image{.width = kWidth, .height = kHeight, .values = {}};
  for (int i = 0; i < kWidth * kHeight; ++i) {
    const double x = i % kWidth;
    image.values.push_back(
        static_cast<float>(0.5 * std::erfc((x0 - x) / (1.5 * std::numbers::sqrt2))));
  }
  return image;
}

/// Mean place and variance of the edge in the first row, by its slope.
struct Spread {
  double mean = 0.0, variance = 0.0;
};
Spread SpreadOf(const RadianceImage& image) {
  Spread spread;
  double sum = 0.0, second = 0.0;
  for (int x = 1; x < kWidth; ++x) {
    const double slope = image.at(x, 0) - image.at(x - 1, 0);
    sum += slope;
    spread.mean += slope * (x - 0.5);
    second += slope * (x - 0.5) * (x - 0.5);
  }
  spread.mean /= sum;
  spread.variance = second / sum - spread.mean * spread.mean;
  return spread;
}

StereoRadiance MovedEdge(double motion_px) {
  return OverExposure(motion_px, [&](double share) -> StereoRadiance {
    return {EdgeAt(60.3 + share * motion_px), EdgeAt(60.3 - share * motion_px)};
  });
}

// A box of d px has the variance d^2 / 12.
TEST(Shutter, MovedEdgeIsWidenedByABox) {
  const double still = SpreadOf(EdgeAt(60.3)).variance;
  for (const double d : {0.25, 0.3, 0.9, 2.0, 5.0, 7.0}) {
    for (const RadianceImage& image : MovedEdge(d)) {
      const Spread spread = SpreadOf(image);
      EXPECT_NEAR(spread.mean, 60.3, 1e-3) << d;
      EXPECT_NEAR(spread.variance - still, d * d / 12.0, 2e-3 + 1e-3 * d * d) << d;
    }
  }
}

TEST(Shutter, ViewsAreLessThanHalfAPixelApart) {
  for (double d = 0.25; d < 7.9; d += 0.01) {
    const std::vector<double> moments = ExposureMoments(d);
    ASSERT_GE(moments.size(), 2u);
    ASSERT_LE(d * (moments[1] - moments[0]), 0.5 + 1e-12) << d;
    ASSERT_LT(std::abs(moments.front()), 0.5);
    ASSERT_NEAR(std::accumulate(moments.begin(), moments.end(), 0.0), 0.0, 1e-12);
  }
  EXPECT_EQ(ExposureMoments(1e6).size(), 16u);
}

// Against the box itself under the same blur: an edge's profile, at places all over it.
TEST(Shutter, StepsUnderABlurCannotBeSeenBehindIt) {
  const auto edge = [](double x, double sigma) {
    return 0.5 * std::erfc(-x / (sigma * std::numbers::sqrt2));
  };
  for (const double sigma : {0.7, 1.0, 1.5}) {
    for (double d = 0.1; d < 16.0 * sigma; d *= 1.3) {
      const std::vector<double> moments = ExposureMoments(d, StepsUnderBlur(sigma));
      double worst = 0.0;
      for (double x = -20.0; x <= 20.0; x += 0.1) {
        double views = 0.0, box = 0.0;
        for (const double moment : moments) {
          views += edge(x + moment * d, sigma) / static_cast<double>(moments.size());
        }
        constexpr int kFine = 200;
        for (int i = 0; i < kFine; ++i)
          box += edge(x + ((i + 0.5) / kFine - 0.5) * d, sigma) / kFine;
        worst = std::max(worst, std::abs(views - box));
      }
      EXPECT_LT(worst, 0.005) << sigma << " " << d << " " << moments.size();
    }
  }
}

TEST(Shutter, OneViewOfAStillCamera) {
  int views = 0;
  const StereoRadiance still = OverExposure(0.04, [&](double share) -> StereoRadiance {
    ++views;
    EXPECT_EQ(share, 0.0);
    return {EdgeAt(50.0), EdgeAt(50.0)};
  });
  EXPECT_EQ(views, 1);
  EXPECT_EQ(still[0].values, EdgeAt(50.0).values);
}

TEST(Shutter, MotionIsThatOfTurningAndOfTheWay) {
  const Camera camera = EquidistantCamera(1024, 768, Radians(90.0));
  const double f = 1024.0 / Radians(90.0);
  EXPECT_NEAR(MotionInExposure_px(camera, 0.1, 0.0, 3.0, 0.01), 1e-3 * f, 1e-9);
  EXPECT_NEAR(MotionInExposure_px(camera, 0.0, -0.05, 2.0, 0.01), 2.5e-4 * f, 1e-9);
  EXPECT_EQ(MotionInExposure_px(camera, 1.0, 1.0, 1.0, 0.0), 0.0);
}

double RmsApart(const RadianceImage& a, const RadianceImage& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    sum += std::pow(static_cast<double>(a.values[i]) - b.values[i], 2);
  }
  return std::sqrt(sum / static_cast<double>(a.values.size()));
}

// A camera that turns by 2 px before the board: five views stand for a box of 20. What is left are
// the steps of half a pixel at edges that no lens has blurred yet.
TEST(Shutter, TurningCameraSeesWhatManyMoreViewsShow) {
  StereoRenderer renderer;
  const StereoRig rig = SampleRig(160, 120);
  const Scene scene = BoardOnly();
  constexpr double kMotion_px = 2.0;
  constexpr int kViews = 20;
  const double turn_rad = kMotion_px / rig.left.focal_px().x();
  const auto view = [&](double share) {
    return renderer.RenderRadiance(scene, rig, LevelRover(-2.0, 0.0, share * turn_rad));
  };
  RadianceImage box = view(-0.5 + 0.5 / kViews)[0];
  for (int i = 1; i < kViews; ++i) {
    const RadianceImage more = view(-0.5 + (i + 0.5) / kViews)[0];
    for (std::size_t k = 0; k < box.values.size(); ++k) box.values[k] += more.values[k];
  }
  for (float& value : box.values) value /= static_cast<float>(kViews);
  const double still = RmsApart(view(0.0)[0], box);
  const double blurred = RmsApart(OverExposure(kMotion_px, view)[0], box);
  EXPECT_GT(still, 0.0);
  EXPECT_LT(blurred, 0.35 * still);
}

}  // namespace
}  // namespace dockyard
