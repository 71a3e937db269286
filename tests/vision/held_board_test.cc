// Boards of other kinds than the station's, held before a pair of cameras. The truth is the ray
// caster's own; poses are drawn at random, not chosen.
#include "vision/held_board.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

HeldOptions NearGrid() {
  // As on photographs of such a board: 110 deg, f 0.35 of the width, 9.7 cm between the cameras.
  HeldOptions options{.board = PlainGrid(4, 3, 0.09, 0.06, Radians(80.0)),
                      .camera = PinholeCamera(720, 540, Radians(110.0), -0.03)};
  options.baseline_m = 0.097;
  options.r_min_m = 0.2;
  options.r_max_m = 0.45;
  return options;
}

HeldOptions FarGrid() {
  HeldOptions options{.board = PlainGrid(4, 3, 0.09, 0.05, Radians(80.0)),
                      .camera = EquidistantCamera(640, 480, Radians(90.0))};
  options.r_max_m = 1.5;
  options.roll_rad = Radians(60.0);
  return options;
}

/// Prints the result and expects no wrong name and no wrong pose.
HeldScore Scored(const HeldOptions& options, int count, int in_view) {
  const HeldScore score = ScoreHeld(options, count, in_view);
  std::printf("    %d of %d accepted; %d marks; worst place %.2e of the range, turn %.3f deg\n",
              score.accepted, score.pairs, score.marks, score.worst_place,
              Degrees(score.worst_turn_rad));
  EXPECT_EQ(score.wrong_poses, 0);
  EXPECT_EQ(score.wrong_marks, 0);
  return score;
}

TEST(HeldBoard, PlainGridIsFoundNearAndThroughAWideLens) {
  HeldOptions options = NearGrid();
  options.left_only = true;
  const HeldScore one = Scored(options, 20, 12);
  EXPECT_EQ(one.accepted, 20);
  EXPECT_EQ(one.marks, 20 * 12);
  EXPECT_LT(one.worst_place, 1e-3);
  EXPECT_LT(one.worst_turn_rad, Radians(0.2));
  options.left_only = false;
  const HeldScore both = Scored(options, 12, 12);
  EXPECT_EQ(both.accepted, 12);
}

TEST(HeldBoard, PlainGridIsFoundInAnyRollThatItsFileAllows) {
  HeldOptions options = FarGrid();
  EXPECT_EQ(Scored(options, 12, 12).accepted, 12);
}

TEST(HeldBoard, PlainGridIsFoundByOneCameraInNoise) {
  HeldOptions options = FarGrid();
  options.left_only = true;
  options.noise_dn = 5.0;
  EXPECT_EQ(Scored(options, 20, 12).accepted, 20);
}

TEST(HeldBoard, OtherDiscsAboutDoNotMisleadAPlainGrid) {
  HeldOptions options = FarGrid();
  options.clutter = 12;
  EXPECT_GE(Scored(options, 15, 12).accepted, 14);
}

TEST(HeldBoard, PartOfAGridIsRefusedWhereItCouldBeAnotherPart) {
  // Without its left column the grid may just as well lack the right one.
  HeldOptions options = FarGrid();
  options.covered_share = 0.25;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const HeldSample sample = TakeHeld(options, i);
    if (sample.in_view < 9) continue;
    EXPECT_FALSE(sample.report.accepted);
    EXPECT_EQ(sample.report.reason, "ambiguous");
  }
}

TEST(HeldBoard, PartOfALargerGridIsRefused) {
  // Upright, and turned by 45 deg, where a slant makes other squares of it.
  for (const double roll : {0.0, kPi / 4.0}) {
    const HeldOptions options = FarGrid();
    for (std::uint64_t i = 0; i < 4; ++i) {
      HeldSample sample = TakeHeld(options, i);
      sample.scene.board = PlainGrid(7, 6, 0.09, 0.05, kPi);
      sample.scene.X_DB.R = sample.scene.X_DB.R * RotZ(roll);
      const StereoRig rig = HeldRig(options);
      const auto report =
          LocateBoard(SyntheticPair(sample.scene, rig), rig, options.board, {}).report;
      EXPECT_GE(report.DetectedBy(0), 20);
      EXPECT_FALSE(report.accepted) << "roll " << roll << ", image pair " << i;
    }
  }
}

TEST(HeldBoard, AGridWithoutOneDiscKeepsItsNames) {
  HeldOptions options = FarGrid();
  FiducialBoard printed = options.board;
  printed.fiducials.erase(printed.fiducials.begin() + 5);
  for (std::uint64_t i = 0; i < 10; ++i) {
    HeldSample sample = TakeHeld(options, i);
    if (sample.in_view < 12) continue;
    sample.scene.board = printed;
    const StereoRig rig = HeldRig(options);
    const auto out = LocateBoard(SyntheticPair(sample.scene, rig), rig, options.board, {});
    ASSERT_TRUE(out.report.accepted) << i << ": " << out.report.reason;
    const Pose3 X_RB = Inverse(sample.scene.X_DR) * sample.scene.X_DB;
    EXPECT_LT((out.report.X_RB.p - X_RB.p).norm(), 0.002 * X_RB.p.norm());
    EXPECT_EQ(out.report.marks.size(), 22u);
  }
}

TEST(HeldBoard, AsymmetricGridIsNamedInEveryRoll) {
  FiducialBoard board = PlainGrid(4, 5, 0.08, 0.03, kPi);
  board.width_m = 0.42;
  for (std::size_t i = 0; i < board.fiducials.size(); ++i) {
    const int row = static_cast<int>(i) / 4;
    board.fiducials[i].p_BF.x() += row % 2 == 1 ? 0.04 : 0.0;
    board.fiducials[i].p_BF.y() *= 0.5;
  }
  board.height_m = 0.24;
  HeldOptions options{.board = board, .camera = EquidistantCamera(640, 480, Radians(90.0))};
  options.r_max_m = 0.9;
  options.roll_rad = kPi;
  EXPECT_EQ(Scored(options, 16, 20).accepted, 16);
}

TEST(HeldBoard, FourToSevenBarsAreFound) {
  for (const int marks : {4, 5, 6, 7}) {
    HeldOptions options{.board = BarBoard(marks, 0.06),
                        .camera = EquidistantCamera(640, 480, Radians(90.0))};
    options.tilt_rad = Radians(28.0);  // the board must hang plumb to 30 deg
    options.r_min_m = 0.7;
    options.left_only = true;
    std::printf("  %d bars\n", marks);
    EXPECT_EQ(Scored(options, 10, marks).accepted, 10);
    options.left_only = false;
    const HeldScore both = Scored(options, 10, marks);
    EXPECT_EQ(both.accepted, 10);
    EXPECT_LT(both.worst_place, 1e-3);
  }
}

TEST(HeldBoard, TwelveBarsOfOneRotationAreNamedByTheirLayout) {
  FiducialBoard board = BarBoard(8, 0.05);
  board.width_m = 0.6;
  board.height_m = 0.4;
  board.fiducials.clear();
  const double layout[12][2] = {{-.26, -.16}, {-.10, -.15}, {.05, -.17}, {.24, -.14},
                                {-.24, -.03}, {-.08, .02},  {.11, -.02}, {.25, .03},
                                {-.27, .15},  {-.06, .16},  {.04, .13},  {.22, .16}};
  for (const auto& [x, y] : layout) board.fiducials.push_back({.p_BF = {x, y}, .rotation = 0.0});
  HeldOptions options{.board = board, .camera = EquidistantCamera(640, 480, Radians(90.0))};
  options.tilt_rad = Radians(28.0);
  options.r_min_m = 0.7;
  EXPECT_EQ(Scored(options, 8, 12).accepted, 8);
}

TEST(HeldBoard, IsNotSeenWhereThereIsNone) {
  for (const bool plain : {true, false}) {
    for (const int marks : {4, 5, 7}) {
      HeldOptions options = FarGrid();
      if (plain && marks != 4) continue;
      if (!plain) options.board = BarBoard(marks, 0.06);
      options.has_board = false;
      int discs = 0;
      options.samples = 2;
      for (std::uint64_t i = 0; i < 6; ++i) {
        options.clutter = static_cast<int>(8 * i);  // up to 40 discs like the board's
        const HeldSample sample = TakeHeld(options, i);
        discs += sample.report.DetectedBy(0) + sample.report.DetectedBy(1);
        EXPECT_FALSE(sample.report.accepted) << marks << " marks, image pair " << i;
      }
      EXPECT_GT(discs, 100);  // or the test shows nothing
    }
  }
}

}  // namespace
}  // namespace dockyard
