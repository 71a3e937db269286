// Centres from the grey levels: on images made here, blurred by sampling, against the closed-form
// bound.
#include "controller/vision/board/disc_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

constexpr double kBlur = 0.7, kWhite = 160.0, kBlack = 20.0, kNoise = 2.0;

struct Disc {
  Eigen::Vector2d centre_px;
  double radius_px = 0.0;
  double bar_rad = 0.0;
};

/// The print in a light, blurred by a Gaussian: albedo on a grid of an eighth of a pixel, smoothed
/// along x, then along y.
GrayImage ImageOf(const Disc& disc, RandomStream& random,
                  const std::function<double(const Eigen::Vector2d&)>& light = {}) {
  constexpr int kSize = 44, kFine = 8, kReach = 24;  // three pixels either side
  const FiducialBoard board = TestBoard();
  const Eigen::Vector2d along(std::cos(disc.bar_rad), -std::sin(disc.bar_rad));
  const Eigen::Vector2d across(std::sin(disc.bar_rad), std::cos(disc.bar_rad));
  const double length = board.bar_length_m / board.disc_diameter_m * disc.radius_px;
  const double width = board.bar_width_m / board.disc_diameter_m * disc.radius_px;
  const int fine = kSize * kFine + 2 * kReach;
  const auto place = [&](int i) { return static_cast<double>(i - kReach) / kFine; };
  Eigen::MatrixXd albedo(fine, fine);
  for (int y = 0; y < fine; ++y) {
    for (int x = 0; x < fine; ++x) {
      const Eigen::Vector2d at(place(x), place(y)), from = at - disc.centre_px;
      const bool bar = std::abs(from.dot(along)) < length && std::abs(from.dot(across)) < width;
      albedo(y, x) =
          (from.norm() > disc.radius_px || bar ? kWhite : kBlack) * (light ? light(at) : 1.0);
    }
  }
  Eigen::MatrixXd smooth = Eigen::MatrixXd::Zero(fine, kSize);  // fine to pixels, one axis
  for (int pixel = 0; pixel < kSize; ++pixel) {
    for (int i = 0; i <= 2 * kReach; ++i) {
      const double off = static_cast<double>(i - kReach) / kFine / kBlur;
      smooth(pixel * kFine + i, pixel) = std::exp(-0.5 * off * off);
    }
    smooth.col(pixel) /= smooth.col(pixel).sum();
  }
  const Eigen::MatrixXd exact = smooth.transpose() * albedo * smooth;
  GrayImage image{.width = kSize, .height = kSize, .pixels = {}};
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const double value = exact(y, x) + kNoise * random.Normal();
      image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)));
    }
  }
  return image;
}

Disc Somewhere(double radius_px, RandomStream& random) {
  return {.centre_px = {21.0 + random.Uniform(0.0, 1.0), 21.0 + random.Uniform(0.0, 1.0)},
          .radius_px = radius_px,
          .bar_rad = random.Uniform(0.0, kPi)};
}

/// The result of a fit to the rim: centre and radius a little off.
Ellipse Rim(const Disc& disc, RandomStream& random) {
  return {.centre_px = disc.centre_px + 0.15 * Eigen::Vector2d(random.Normal(), random.Normal()),
          .shape_px = (disc.radius_px + random.Uniform(-0.15, 0.15)) * Eigen::Matrix2d::Identity()};
}

/// Bound on one axis for a black disc on white: the information of its blurred edge,
/// contrast^2 sqrt(pi) R / (2 blur noise^2).
double Bound(double radius_px) {
  const double contrast = kWhite - kBlack;
  return kNoise / contrast * std::sqrt(2.0 * kBlur / (std::sqrt(kPi) * radius_px));
}

TEST(DiscFit, ErrorIsWithinTwiceTheCramerRaoBound) {
  RandomStream random(StreamKey(1, "disc"));
  for (const double radius_px : {4.0, 5.0, 6.0, 9.0, 14.0}) {
    double squares = 0.0, predicted = 0.0;
    constexpr int kCount = 30;
    for (int i = 0; i < kCount; ++i) {
      const Disc disc = Somewhere(radius_px, random);
      const GrayImage image = ImageOf(disc, random);
      const auto fit = FitDisc(image, Rim(disc, random), disc.bar_rad, TestBoard());
      ASSERT_TRUE(fit) << radius_px;
      squares += 0.5 * (fit->centre_px - disc.centre_px).squaredNorm();
      predicted += kNoise * fit->sigma_px / kCount;
    }
    const double error = std::sqrt(squares / kCount);
    // The bound includes neither the light's gradient, which is fitted too, nor the bar's edges;
    // and the edge's model is a cubic. [1.2 to 1.8 times the bound]
    EXPECT_LT(error, 2.0 * Bound(radius_px)) << radius_px;
    EXPECT_NEAR(predicted, Bound(radius_px), 0.4 * Bound(radius_px)) << radius_px;
  }
}

TEST(DiscFit, SlopingLightDoesNotMoveTheCentre) {
  RandomStream random(StreamKey(2, "disc"));
  for (const double radius_px : {5.0, 10.0}) {
    for (int i = 0; i < 10; ++i) {
      const Disc disc = Somewhere(radius_px, random);
      const auto light = [&](const Eigen::Vector2d& at) {
        return 1.0 + 0.3 * (at - disc.centre_px).x() / (radius_px + 2.0);  // 0.7 to 1.3 across it
      };
      const auto fit =
          FitDisc(ImageOf(disc, random, light), Rim(disc, random), disc.bar_rad, TestBoard());
      ASSERT_TRUE(fit);
      EXPECT_LT((fit->centre_px - disc.centre_px).norm(), 0.06);
    }
  }
}

TEST(DiscFit, LeavesDiscsThatAShadowsEdgeCutsToTheRim) {
  RandomStream random(StreamKey(3, "disc"));
  for (const double radius_px : {5.0, 10.0}) {
    for (int i = 0; i < 10; ++i) {
      const Disc disc = Somewhere(radius_px, random);
      const auto light = [&](const Eigen::Vector2d& at) {
        return (at - disc.centre_px).x() > 0.0 ? 0.25 : 1.0;
      };
      EXPECT_FALSE(
          FitDisc(ImageOf(disc, random, light), Rim(disc, random), disc.bar_rad, TestBoard()));
    }
  }
}

TEST(DiscFit, NeedsTheRingWholeInTheImage) {
  RandomStream random(StreamKey(4, "disc"));
  const GrayImage image = ImageOf(Somewhere(5.0, random), random);
  const Ellipse at_border{.centre_px = {5.5, 20.0}, .shape_px = 5.0 * Eigen::Matrix2d::Identity()};
  EXPECT_FALSE(FitDisc(image, at_border, 0.0, TestBoard()));
}

}  // namespace
}  // namespace dockyard
