#include "controller/stereo/face_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/base/random.h"
#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

constexpr int kFaceWidth = 320, kFaceHeight = 240;

// A face with stains of 15 %, some 5 px wide, lit by the sun on one side of a straight edge and by
// a fifth of it on the other, seen from a camera that was moved aside; with the sensor's noise.
GrayImage FaceInHalfShade(double aside_u, double aside_v, std::uint64_t noise_seed) {
  RandomStream waves(3), noise(noise_seed);
  std::vector<Eigen::Vector3d> stains;
  for (int i = 0; i < 60; ++i) {
    const double angle = waves.Uniform(-kPi, kPi), length_px = waves.Uniform(8.0, 30.0);
    const double phase = waves.Uniform(-kPi, kPi);
    stains.emplace_back(std::cos(angle) * 2.0 * kPi / length_px,
                        std::sin(angle) * 2.0 * kPi / length_px, phase);
  }
  GrayImage image{kFaceWidth, kFaceHeight, {}};
  for (int v = 0; v < kFaceHeight; ++v) {
    for (int u = 0; u < kFaceWidth; ++u) {
      const double x = u + aside_u, y = v + aside_v;
      double stain = 0.0;
      for (const Eigen::Vector3d& wave : stains) {
        stain += std::cos(wave.x() * x + wave.y() * y + wave.z());
      }
      const double albedo = 1.0 + 0.15 * stain * std::sqrt(2.0 / 60.0);
      const double light = x + 0.6 * y < 160.0 + 72.0 ? 120.0 : 24.0;
      const double grey = std::clamp(light * albedo + 0.7 * noise.Normal(), 0.0, 255.0);
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(grey)));
    }
  }
  return image;
}

// The target lies on the shadow's edge, along which the greys alone are alike.
TEST(FacePatch, IsFoundOnAShadowsEdge) {
  FacePatch patch{.left = FaceInHalfShade(0.0, 0.0, 1),
                  .focal_px = 800.0,
                  .centre_px = {160.0, 120.0},
                  .p_C = {0.0, 0.0, 1.0}};
  int found = 0;
  for (std::uint64_t seed = 2; seed < 12; ++seed) {
    const double du = static_cast<double>(seed % 5) - 2.0, dv = 3.0 - static_cast<double>(seed % 7);
    const PatchFound at =
        FindPatch(patch, FaceInHalfShade(-du, -dv, seed), Pose3{}, 8.0, 25.0, FacePatchSettings{});
    if (at.verdict != PatchVerdict::kFound) continue;
    ++found;
    EXPECT_NEAR(at.pixel.x(), 160.0 + du, 0.5) << seed;
    EXPECT_NEAR(at.pixel.y(), 120.0 + dv, 0.5) << seed;
  }
  EXPECT_EQ(found, 10);
}

// Stripes of 20 px across and 23 px down, in a picture moved by so much.
GrayImage Stripes(double aside_u, double aside_v) {
  GrayImage image{kFaceWidth, kFaceHeight, {}};
  for (int v = 0; v < kFaceHeight; ++v) {
    for (int u = 0; u < kFaceWidth; ++u) {
      const double grey = 100.0 + 20.0 * std::cos(2.0 * kPi * (u + aside_u) / 20.0) +
                          20.0 * std::cos(2.0 * kPi * (v + aside_v) / 23.0);
      image.pixels.push_back(static_cast<std::uint8_t>(std::lround(grey)));
    }
  }
  return image;
}

TEST(FacePatch, AmongPlacesAlikeThePredictionDecidesOnlyAsFarAsItIsSure) {
  const FacePatch patch{.left = Stripes(0.0, 0.0),
                        .focal_px = 800.0,
                        .centre_px = {160.0, 120.0},
                        .p_C = {0.0, 0.0, 1.0}};
  const GrayImage moved = Stripes(-3.0, 2.0);
  const PatchFound sure = FindPatch(patch, moved, Pose3{}, 4.0, 30.0, FacePatchSettings{});
  EXPECT_EQ(sure.verdict, PatchVerdict::kFound);
  EXPECT_NEAR(sure.pixel.x(), 163.0, 0.2);
  EXPECT_NEAR(sure.pixel.y(), 118.0, 0.2);
  const PatchFound unsure = FindPatch(patch, moved, Pose3{}, 20.0, 30.0, FacePatchSettings{});
  EXPECT_EQ(unsure.verdict, PatchVerdict::kAmbiguous);
}

// A ball of 15 cm about the origin with stains, from 1 m away and so far to the side.
struct BallView {
  GrayImage image{kFaceWidth, kFaceHeight, {}};
  Pose3 X_WC;
};
BallView BallFrom(double side_rad) {
  BallView view;
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  view.X_WC = {RotZ(side_rad) * axes, RotZ(side_rad) * Eigen::Vector3d(-1.0, 0.0, 0.0)};
  const RayScene scene{.stone = {0, 0, 0}, .stone_radius_m = 0.15, .grain_m = 0.012};
  for (int v = 0; v < kFaceHeight; ++v) {
    for (int u = 0; u < kFaceWidth; ++u) {
      const Eigen::Vector3d along =
          view.X_WC.R * Eigen::Vector3d((u - 160.0) / 800.0, (v - 120.0) / 800.0, 1.0).normalized();
      const double b = view.X_WC.p.dot(along);
      const double rest = b * b - view.X_WC.p.squaredNorm() + 0.15 * 0.15;
      const Eigen::Vector3d at = view.X_WC.p + (-b - std::sqrt(std::max(0.0, rest))) * along;
      const double grey =
          rest > 0.0 ? 40.0 + 80.0 * scene.Texture(at + Eigen::Vector3d(1, 2, 3)) : 90;
      view.image.pixels.push_back(static_cast<std::uint8_t>(std::lround(grey)));
    }
  }
  return view;
}

// A map alone moves the middle by 1.2 to 1.9 px.
TEST(FacePatch, OnABallItIsWhereItWasThoughThePatchIsWarpedByAPlane) {
  const BallView then = BallFrom(0.0);
  for (const double turned_deg : {-14.0, 14.0}) {
    const BallView now = BallFrom(Radians(turned_deg));
    // To either side and up.
    for (const double aside : {-0.4, 0.4}) {
      const Eigen::Vector3d normal(-std::sqrt(1.0 - aside * aside - 0.04), aside, 0.2);
      const Pose3 X_CW = Inverse(then.X_WC), X_NC = Inverse(now.X_WC) * then.X_WC;
      const FacePatch patch{.left = then.image,
                            .focal_px = 800.0,
                            .centre_px = {160.0, 120.0},
                            .p_C = X_CW * Eigen::Vector3d(0.15 * normal),
                            .normal_C = X_CW.R * normal};
      const Eigen::Vector3d p_N = X_NC * patch.p_C;
      const Eigen::Vector2d is = patch.centre_px + 800.0 * p_N.head<2>() / p_N.z();
      const PatchFound at = FindPatch(patch, now.image, X_NC, 6.0, 18.0, FacePatchSettings{});
      ASSERT_EQ(at.verdict, PatchVerdict::kFound) << turned_deg << " " << aside;
      EXPECT_LT((at.pixel - is).norm(), 0.5) << turned_deg << " " << aside;
    }
  }
}

// A boulder's edge before the ground: what is behind it moves by another way.
TEST(FacePatch, WhatIsNotOnTheFaceDoesNotCount) {
  const auto edge = [](int face_u, int ground_u) {
    const GrayImage face = FaceInHalfShade(-face_u - 150.0, 0.0, 1),
                    ground = FaceInHalfShade(-ground_u - 150.0, 300.0, 1);
    GrayImage image = face;
    for (int v = 0; v < 115; ++v) {
      for (int u = 0; u < kFaceWidth; ++u) {
        const auto i = static_cast<std::size_t>(v * kFaceWidth + u);
        image.pixels[i] = ground.pixels[i];
      }
    }
    return image;
  };
  FacePatch patch{
      .left = edge(0, 0), .focal_px = 800.0, .centre_px = {160.0, 120.0}, .p_C = {0.0, 0.0, 1.0}};
  const GrayImage moved = edge(4, -7);
  patch.on_face = {kFaceWidth, kFaceHeight, {}};
  for (int v = 0; v < kFaceHeight; ++v) {
    for (int u = 0; u < kFaceWidth; ++u) patch.on_face.pixels.push_back(v < 115 ? 0 : 255);
  }
  const PatchFound found = FindPatch(patch, moved, Pose3{}, 8.0, 25.0, FacePatchSettings{});
  ASSERT_EQ(found.verdict, PatchVerdict::kFound);
  EXPECT_GT(found.score, 0.95);
  EXPECT_NEAR(found.pixel.x(), 164.0, 0.3);
  EXPECT_NEAR(found.pixel.y(), 120.0, 0.3);
  patch.on_face = {};
  const double all = FindPatch(patch, moved, Pose3{}, 8.0, 25.0, FacePatchSettings{}).score;
  EXPECT_LT(1.0 - found.score, 0.5 * (1.0 - all));
}

}  // namespace
}  // namespace dockyard
