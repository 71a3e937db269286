#include "controller/stereo/face_greys.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "sim/base/random.h"

namespace dockyard {
namespace {

constexpr int kSide_px = 41, kGroundFrom_px = 30;

// A face of 40 with stains of 6, one sigma once they are smoothed by a pixel as FindPatch() does,
// and below a row the ground.
cv::Mat FaceOverGround(float ground) {
  RandomStream random(5);
  cv::Mat stains(kSide_px, kSide_px, CV_32F), smooth;
  for (int i = 0; i < kSide_px * kSide_px; ++i) {
    stains.at<float>(i / kSide_px, i % kSide_px) = static_cast<float>(random.Uniform(6.0, 74.0));
  }
  stains.rowRange(kGroundFrom_px, kSide_px) = ground;
  cv::GaussianBlur(stains, smooth, {}, 1.0);
  return smooth;
}

// By the same stains before ground that is dark and before ground that is bright: what counts in
// both has the same grey.
TEST(FaceGreys, WhatCountsDoesNotChangeWithTheGroundBehind) {
  const cv::Mat on_face(kSide_px, kSide_px, CV_8U, cv::Scalar(255));
  const cv::Mat bright = FaceOverGround(220.0F), dark = FaceOverGround(30.0F);
  const auto own = OwnGreys(bright, on_face, 1.0);
  ASSERT_TRUE(own);
  int counts = 0;
  for (int v = 0; v < kSide_px; ++v) {
    for (int u = 0; u < kSide_px; ++u) {
      if (own->at<std::uint8_t>(v, u) == 0) continue;
      ++counts;
      EXPECT_NEAR(bright.at<float>(v, u), dark.at<float>(v, u), 1.0) << u << " " << v;
    }
  }
  EXPECT_GT(counts, 0.9 * kSide_px * (kGroundFrom_px - 4));
}

TEST(FaceGreys, NoneCountWhereTheFaceIsPlainAndOnlyThoseOnTheFace) {
  cv::Mat on_face(kSide_px, kSide_px, CV_8U, cv::Scalar(255));
  EXPECT_FALSE(OwnGreys(cv::Mat(kSide_px, kSide_px, CV_32F, cv::Scalar(40.0)), on_face, 1.0));
  on_face.colRange(0, 20) = 0;
  const auto own = OwnGreys(FaceOverGround(220.0F), on_face, 1.0);
  ASSERT_TRUE(own);
  EXPECT_EQ(cv::countNonZero(own->colRange(0, 20)), 0);
  EXPECT_GT(cv::countNonZero(own->colRange(20, kSide_px)), 0);
}

}  // namespace
}  // namespace dockyard
