// Motion blur against closed forms and against many more views.
#include "render/shutter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "render/optics.h"
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
struct EdgeSpread {
  double mean = 0.0, variance = 0.0;
};
EdgeSpread EdgeSpreadOf(const RadianceImage& image) {
  EdgeSpread spread;
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

StereoRig EdgeRig() {
  const Camera camera = EquidistantCamera(kWidth, kHeight, Radians(60.0));
  return {camera, camera, {}, {}};
}

/// Both views of the edge, far away, while the cameras turn so that it goes right.
StereoRadiance MovedEdge(double motion_px) {
  const StereoRig rig = EdgeRig();
  const ExposureMotion turning{{0, 0, 0}, {0, -motion_px / rig.left.focal_px().x(), 0}};
  return OverExposure(motion_px, rig, turning, [&](double share, bool with_depth) {
    RadianceImage edge = EdgeAt(60.3 + share * motion_px);
    if (with_depth) edge.inverse_depth.assign(edge.values.size(), 0.0f);
    return StereoRadiance{edge, edge};
  });
}

// A box of d px has the variance d^2 / 12.
TEST(Shutter, MovedEdgeIsWidenedByABox) {
  const double still = EdgeSpreadOf(EdgeAt(60.3)).variance;
  for (const double d : {0.25, 0.3, 0.9, 2.0, 5.0, 7.0}) {
    for (const RadianceImage& image : MovedEdge(d)) {
      const EdgeSpread spread = EdgeSpreadOf(image);
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
  const auto view = [&](double share, bool with_depth) -> StereoRadiance {
    ++views;
    EXPECT_EQ(share, 0.0);
    EXPECT_FALSE(with_depth);
    return {EdgeAt(50.0), EdgeAt(50.0)};
  };
  const StereoRadiance still = OverExposure(0.04, EdgeRig(), {}, view);
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

/// The mean of 40 views evenly over an exposure.
RadianceImage ManyViews(const std::function<RadianceImage(double share)>& view) {
  constexpr int kViews = 40;
  RadianceImage box = view(-0.5 + 0.5 / kViews);
  for (int i = 1; i < kViews; ++i) {
    const RadianceImage more = view(-0.5 + (i + 0.5) / kViews);
    for (std::size_t k = 0; k < box.values.size(); ++k) box.values[k] += more.values[k];
  }
  for (float& value : box.values) value /= static_cast<float>(kViews);
  return box;
}

// A camera that drives and turns before the board so that it moves by 2 px, behind a lens of 0.6
// px. Slower motions are smaller than the renderer's own steps at edges: for them see
// MotionBlur.
TEST(Shutter, MovingCameraSeesWhatManyViewsShow) {
  StereoRenderer renderer;
  const StereoRig rig = SampleRig(160, 120);
  const Scene scene = BoardOnly();
  constexpr double kDistance_m = 2.0, kMotion_px = 2.0;
  // Half of the motion is a turn, half a displacement to the right of the view.
  const double turn_rad = 0.5 * kMotion_px / rig.left.focal_px().x();
  const double shift_m = turn_rad * kDistance_m;
  int views = 0;
  const auto rover = [&](double share) {
    Pose3 X_WR = LevelRover(-kDistance_m, 0.0, share * turn_rad);
    X_WR.p.y() -= share * shift_m;
    return X_WR;
  };
  const auto view = [&](double share, bool with_depth) {
    ++views;
    return renderer.RenderRadiance(scene, rig, rover(share), with_depth);
  };
  const auto behind_lens = [](RadianceImage image) {
    Blur(0.6, image);
    return image;
  };
  const RadianceImage box =
      behind_lens(ManyViews([&](double share) { return view(share, false)[0]; }));
  const double still = RmsApart(behind_lens(view(0.0, false)[0]), box);
  views = 0;
  const ExposureMotion motion =
      MotionOverExposure(rover(0.0).R, {0, -shift_m, 0}, {0, 0, turn_rad}, 1.0);
  const RadianceImage moving = OverExposure(kMotion_px, rig, motion, view)[0];
  EXPECT_EQ(views, 3);
  EXPECT_GT(still, 0.0);
  EXPECT_LT(RmsApart(behind_lens(moving), box), 0.3 * still);
}

TEST(Shutter, OneViewServesASlowMotion) {
  for (const auto& [motion_px, wanted] : {std::pair{0.3, 1}, {0.84, 1}, {0.9, 2}, {1e6, 16}}) {
    int views = 0;
    OverExposure(motion_px, EdgeRig(), {}, [&](double, bool with_depth) {
      ++views;
      RadianceImage edge = EdgeAt(50.0);
      if (with_depth) edge.inverse_depth.assign(edge.values.size(), 0.0f);
      return StereoRadiance{edge, edge};
    });
    EXPECT_EQ(views, wanted) << motion_px;
  }
}

}  // namespace
}  // namespace dockyard
