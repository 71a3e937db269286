#include "controller/stereo/patch_fit.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Stains with waves of 8 to 30 px, of any place.
class Stains {
 public:
  explicit Stains(std::uint64_t seed) {
    RandomStream waves(seed);
    for (int i = 0; i < 40; ++i) {
      const double angle = waves.Uniform(-kPi, kPi), length_px = waves.Uniform(8.0, 30.0);
      waves_.emplace_back(std::cos(angle) * 2.0 * kPi / length_px,
                          std::sin(angle) * 2.0 * kPi / length_px, waves.Uniform(-kPi, kPi));
    }
  }
  double At(const Vector2d& x) const {
    double sum = 0.0;
    for (const Eigen::Vector3d& wave : waves_) sum += std::cos(wave.head<2>().dot(x) + wave.z());
    return 60.0 + 6.0 * sum * std::sqrt(2.0 / 40.0);
  }

 private:
  std::vector<Eigen::Vector3d> waves_;
};

struct Pair {
  cv::Mat patch, on_face, picture;
};

// A patch of 41 px, and a picture of 81 px in which x = A p + t, with the greys 1.3 g - 5 and
// noise.
Pair Shown(const Stains& stains, const Matrix2d& A, const Vector2d& t, double noise,
           std::uint64_t seed) {
  RandomStream random(seed);
  Pair pair{cv::Mat(41, 41, CV_32F), cv::Mat(41, 41, CV_8U, cv::Scalar(255)),
            cv::Mat(81, 81, CV_32F)};
  for (int v = 0; v < 41; ++v) {
    for (int u = 0; u < 41; ++u) {
      pair.patch.at<float>(v, u) =
          static_cast<float>(stains.At(Vector2d(u - 20.0, v - 20.0)) + noise * random.Normal());
    }
  }
  const Matrix2d back = A.inverse();
  for (int v = 0; v < 81; ++v) {
    for (int u = 0; u < 81; ++u) {
      const Vector2d p = back * (Vector2d(u, v) - t);
      pair.picture.at<float>(v, u) =
          static_cast<float>(1.3 * stains.At(p) - 5.0 + noise * random.Normal());
    }
  }
  return pair;
}

TEST(PatchFit, FindsShiftAndMapWithoutNoise) {
  Matrix2d A;
  A << 1.04, 0.03, -0.05, 0.94;
  const Vector2d t(40.37, 39.22);
  const Pair pair = Shown(Stains(1), A, t, 0.0, 1);
  const auto fit = FitPatch(pair.patch, pair.on_face, pair.picture, {40.0, 40.0});
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->t.x(), t.x(), 0.05);
  EXPECT_NEAR(fit->t.y(), t.y(), 0.05);
  EXPECT_LT((fit->A - A).cwiseAbs().maxCoeff(), 0.01);
}

// A face seen from another height than its plane's normal foretells, and only its lower half
// counts: the shift alone is off by about the stretch times the middle of what counts, 0.12 x 10
// px.
TEST(PatchFit, AStretchedHalfDoesNotMoveTheMiddle) {
  Matrix2d A = Matrix2d::Identity();
  A(1, 1) = 1.12;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Vector2d t(40.3, 39.6);
    Pair pair = Shown(Stains(seed), A, t, 1.0, seed);
    pair.on_face(cv::Rect(0, 0, 41, 21)) = 0;
    const auto fit = FitPatch(pair.patch, pair.on_face, pair.picture, {40.0, 41.0});
    ASSERT_TRUE(fit.has_value()) << seed;
    EXPECT_NEAR(fit->t.x(), t.x(), 0.25) << seed;
    EXPECT_NEAR(fit->t.y(), t.y(), 0.35) << seed;
  }
}

// The rover's shadow came over a part of the face: there it is lit by a fifth.
TEST(PatchFit, AShadowThatCameOverAPartDoesNotMoveTheMiddle) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Vector2d t(40.4, 39.5);
    auto [patch, on_face, image] = Shown(Stains(seed), Matrix2d::Identity(), t, 1.0, seed);
    image(cv::Rect(0, 52, 81, 29)) *= 0.2;
    const auto fit = FitPatch(patch, on_face, image, {40.0, 40.0});
    ASSERT_TRUE(fit.has_value()) << seed;
    EXPECT_NEAR(fit->t.x(), t.x(), 0.25) << seed;
    EXPECT_NEAR(fit->t.y(), t.y(), 0.25) << seed;
  }
}

// A rounded face, whose edge the parallax moves by 3 px against the plane's. The map alone moves
// the middle by the mean of that, 2/3 of 3 px.
TEST(PatchFit, ABendDoesNotMoveTheMiddle) {
  const Vector2d edge(3.0, -1.0), t(40.3, 39.6);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Stains stains(seed);
    RandomStream random(seed);
    const Pair pair = Shown(stains, Matrix2d::Identity(), t, 1.0, seed);
    cv::Mat image(81, 81, CV_32F);
    for (int v = 0; v < 81; ++v) {
      for (int u = 0; u < 81; ++u) {
        Vector2d p = Vector2d(u, v) - t;
        for (int i = 0; i < 20; ++i) p = Vector2d(u, v) - t - edge * p.squaredNorm() / 400.0;
        image.at<float>(v, u) = static_cast<float>(1.3 * stains.At(p) - 5.0 + random.Normal());
      }
    }
    const auto fit_by = [&](const PatchFitSettings& settings) {
      return FitPatch(pair.patch, pair.on_face, image, {41.0, 39.0}, settings);
    };
    const auto fit = fit_by({.edge_px = edge});
    ASSERT_TRUE(fit.has_value()) << seed;
    EXPECT_LT((fit->t - t).norm(), 0.25) << seed;
    EXPECT_NEAR(fit->bend.x(), 1.0, 0.15) << seed;
    EXPECT_NEAR(fit->bend.y(), 0.0, 0.15) << seed;
    EXPECT_NEAR(fit->bend.z(), 1.0, 0.15) << seed;
    const auto plane = fit_by({});
    if (plane) {
      EXPECT_GT((plane->t - t).norm(), 1.0) << seed;
    }
  }
}

TEST(PatchFit, RefusesAnotherFaceAndOneOfWhichNothingCounts) {
  int fits = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Pair pair = Shown(Stains(seed), Matrix2d::Identity(), {40.0, 40.0}, 1.0, seed);
    pair.patch = Shown(Stains(seed + 100), Matrix2d::Identity(), {40.0, 40.0}, 1.0, seed).patch;
    fits += FitPatch(pair.patch, pair.on_face, pair.picture, {40.0, 40.0}).has_value();
  }
  EXPECT_LE(fits, 2);
  Pair hidden = Shown(Stains(1), Matrix2d::Identity(), {40.0, 40.0}, 0.0, 1);
  hidden.on_face = cv::Scalar(0);
  EXPECT_FALSE(FitPatch(hidden.patch, hidden.on_face, hidden.picture, {40.0, 40.0}).has_value());
}

}  // namespace
}  // namespace dockyard
