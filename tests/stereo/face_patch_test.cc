#include "controller/stereo/face_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/base/random.h"

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
