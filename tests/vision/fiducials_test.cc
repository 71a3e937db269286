#include "controller/vision/board/fiducials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <optional>

#include "controller/vision/board/blobs.h"
#include "controller/vision/pose_refine.h"
#include "sim/base/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

struct Seen {
  int in_view = 0, found = 0, right_class = 0, false_marks = 0;
  double rms_px = 0.0;
};

/// Detections in the left image against the truth.
Seen Detect(const SyntheticScene& scene, const StereoRig& rig) {
  auto detections = DetectFiducials(SyntheticView(scene, rig.left, rig.X_RL), scene.board);
  const Pose3 X_CB = Inverse(scene.X_DR * rig.X_RL) * scene.X_DB;
  const Eigen::Matrix3d R_DC = scene.X_DR.R * rig.X_RL.R;
  AssignRotations(detections, rig.left, R_DC.transpose() * Eigen::Vector3d::UnitZ());
  Seen seen;
  for (const Fiducial& fiducial : scene.board.fiducials) {
    const auto truth = ProjectDisc(rig.left, X_CB, fiducial, scene.board.disc_diameter_m);
    const double radius = 0.05 * rig.left.focal_px().x() / X_CB.p.norm();
    if (truth && rig.left.Sees(*truth, 1.5 * radius)) ++seen.in_view;
  }
  double sum = 0.0;
  for (const DetectedFiducial& detection : detections) {
    bool known = false;
    for (const Fiducial& fiducial : scene.board.fiducials) {
      const auto truth = ProjectDisc(rig.left, X_CB, fiducial, scene.board.disc_diameter_m);
      const double error = truth ? (*truth - detection.rim.centre_px).norm() : 1e9;
      if (error > 2.0) continue;
      known = true;
      ++seen.found;
      sum += error * error;
      if (detection.rotation_class == RotationClass(fiducial.rotation)) ++seen.right_class;
    }
    if (!known) ++seen.false_marks;
  }
  seen.rms_px = seen.found > 0 ? std::sqrt(sum / seen.found) : 0.0;
  return seen;
}

SyntheticScene From(double r_m, double alpha_deg, double h_deg, double pitch_deg = 0.0) {
  SyntheticScene scene;
  scene.X_DR = RoverAt({r_m, Radians(alpha_deg), Radians(h_deg)}, Radians(pitch_deg));
  return scene;
}

TEST(Fiducials, AreAllFoundAtTwoMetres) {
  const Seen seen = Detect(From(2.0, 10.0, 5.0), TestRig(640, 480));
  EXPECT_EQ(seen.found, 8);
  EXPECT_EQ(seen.right_class, 8);
  EXPECT_EQ(seen.false_marks, 0);
}

TEST(Fiducials, AreMeasuredToAFewHundredthsOfAPixel) {
  // Published for ellipse fits on contours: 0.05-0.08 px at this size; edges do as well or better.
  EXPECT_LT(Detect(From(2.0, 10.0, 5.0), TestRig(640, 480)).rms_px, 0.06);
}

TEST(Fiducials, AreFoundEightPixelsAcross) {
  const Seen seen = Detect(From(5.0, 5.0, 0.0), TestRig(640, 480));
  EXPECT_GE(seen.found, 7);
  EXPECT_GE(seen.right_class, seen.found - 1);
}

TEST(Fiducials, AreFoundTwoHundredPixelsAcross) {
  // 0.32 m before the camera at 652 px/rad, tilted up: only some are in the image at all.
  const Seen seen = Detect(From(0.40, 0.0, 0.0, -15.0), TestRig(1024, 768));
  EXPECT_GE(seen.in_view, 2);
  EXPECT_GE(seen.found, seen.in_view);
  EXPECT_EQ(seen.right_class, seen.found);
}

TEST(Fiducials, AreFoundSevenPixelsAcrossThoughTheirBarsBlur) {
  const Seen seen = Detect(From(6.0, 5.0, 0.0), TestRig(640, 480));
  EXPECT_GE(seen.found, 6);
}

TEST(Fiducials, OfANearBoardAreNotJoinedByStones) {
  EXPECT_EQ(Detect(From(1.2, 0.0, 0.0), TestRig(640, 480)).false_marks, 0);
}

TEST(Fiducials, AreReadFromAsideAndAbove) {
  const Seen seen = Detect(From(1.8, 38.0, 5.0, 15.0), TestRig(640, 480));
  EXPECT_EQ(seen.right_class, seen.found);
  EXPECT_GE(seen.found, 7);
}

TEST(Fiducials, AreFoundInDimLight) {
  SyntheticScene scene = From(2.5, 0.0, 0.0);
  scene.white_dn = 45.0;  // 40 DN between white and black
  EXPECT_EQ(Detect(scene, TestRig(640, 480)).found, 8);
}

TEST(Fiducials, AreFoundThroughVeilingLight) {
  for (const double r_m : {1.5, 3.0, 5.0}) {
    const SyntheticScene scene = From(r_m, 10.0, 5.0);
    const StereoRig rig = TestRig(1024, 768);
    GrayImage image = SyntheticView(scene, rig.left, rig.X_RL);
    EXPECT_EQ(DetectFiducials(image, scene.board).size(), 8u) << r_m;
    for (std::uint8_t& pixel : image.pixels) pixel = static_cast<std::uint8_t>(120 + 2 * pixel / 5);
    EXPECT_EQ(DetectFiducials(image, scene.board).size(), 8u) << r_m;
  }
}

TEST(Fiducials, AreFoundUnderTheEdgeOfAShadow) {
  SyntheticScene scene = From(2.0, 0.0, 0.0);
  scene.shadow = SyntheticScene::ShadowEdge{.through_B = {-0.12, -0.18}, .normal_rad = 0.3};
  EXPECT_EQ(Detect(scene, TestRig(640, 480)).found, 8);
}

TEST(Fiducials, AreFoundInBrokenShade) {
  SyntheticScene scene = From(2.0, 0.0, 0.0);
  scene.speckle = 0.5;
  EXPECT_GE(Detect(scene, TestRig(640, 480)).found, 7);
}

TEST(Fiducials, AreNotSeenInAnEvenImage) {
  const GrayImage even{
      .width = 640, .height = 480, .pixels = std::vector<std::uint8_t>(640 * 480, 90)};
  EXPECT_TRUE(DetectFiducials(even, TestBoard()).empty());
}

TEST(Fiducials, AreNotSeenInTinyImages) {
  EXPECT_TRUE(DetectFiducials({}, TestBoard()).empty());
  for (const int size : {1, 2, 3, 20, 21, 22, 43}) {
    GrayImage image{.width = size, .height = size, .pixels = {}};
    for (int i = 0; i < size * size; ++i) image.pixels.push_back(i % 7 == 0 ? 10 : 200);
    EXPECT_TRUE(DetectFiducials(image, TestBoard()).empty());
  }
}

TEST(Fiducials, AreNotPlainDarkDiscs) {
  SyntheticScene scene;
  scene.has_board = false;
  scene.clutter_discs = 30;
  const StereoRig rig = TestRig(640, 480);
  const auto found = DetectFiducials(SyntheticView(scene, rig.left, rig.X_RL), scene.board);
  EXPECT_LE(found.size(), 1u);
}

GrayImage Noise(int width, int height) {
  GrayImage image{.width = width, .height = height, .pixels = {}};
  RandomStream random(1);
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  for (std::size_t i = 0; i < count; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(random.NextBits() >> 56));
  }
  return image;
}

/// All numbers of the blobs, in order.
std::vector<double> Numbers(const std::vector<Blob>& blobs) {
  std::vector<double> numbers;
  for (const Blob& blob : blobs) {
    const auto& [centre, shape] = blob.moments;
    numbers.insert(numbers.end(),
                   {centre.x(), centre.y(), shape(0, 0), shape(0, 1), shape(1, 1), blob.threshold});
  }
  return numbers;
}

TEST(Blobs, AreTheSameInTilesOfAnySize) {
  const StereoRig rig = TestRig(640, 480);
  for (const GrayImage& image :
       {SyntheticView(SyntheticScene{}, rig.left, rig.X_RL), Noise(400, 300)}) {
    const std::vector<BlobLevel> levels = BuildLevels(image);
    for (const BlobLevel& level : {levels[0], levels[1]}) {
      const std::vector<double> whole = Numbers(FindBlobs(level));
      EXPECT_FALSE(whole.empty() && level.level == 0);
      for (const int tile_px : {40, 97, 333}) EXPECT_EQ(Numbers(FindBlobs(level, tile_px)), whole);
    }
  }
}

TEST(Blobs, OfNoiseTakeTimeInProportionToThePixels) {
  // 12 megapixels took 14 s, now 1.5 s: one level in one piece takes the square of its outlines.
  const auto seconds = [](const GrayImage& image) {
    const std::vector<BlobLevel> levels = BuildLevels(image);
    const std::clock_t start = std::clock();
    FindBlobs(levels[0]);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  };
  const double small_s = seconds(Noise(1280, 1280)), large_s = seconds(Noise(1280, 6 * 1280));
  EXPECT_LT(large_s, 12.0 * small_s);  // 6 of them; 36 in one piece
}

TEST(RotationClass, FollowsTheBoardsConvention) {
  EXPECT_EQ(RotationClass(0.0), 0);
  EXPECT_EQ(RotationClass(kPi / 4.0), 1);
  EXPECT_EQ(RotationClass(kPi / 2.0), 2);
  EXPECT_EQ(RotationClass(-kPi / 2.0), 2);
  EXPECT_EQ(RotationClass(-kPi / 4.0), 3);
}

}  // namespace
}  // namespace dockyard
