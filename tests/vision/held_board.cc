#include "vision/held_board.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "sim/base/random.h"

namespace dockyard {
namespace {

/// The board r away, tilted about an axis in its plane, then rolled about the line of sight.
Pose3 Held(const HeldOptions& options, RandomStream& random) {
  const double r = options.r_min_m + (options.r_max_m - options.r_min_m) * random.Uniform();
  const double off = options.off_axis_rad * random.Uniform();
  const double towards = random.Uniform(-kPi, kPi), axis = random.Uniform(-kPi, kPi);
  const double tilt = options.tilt_rad * random.Uniform();
  const double roll = options.roll_rad * (2.0 * random.Uniform() - 1.0);
  const Eigen::Vector3d sight(std::sin(off) * std::cos(towards), std::sin(off) * std::sin(towards),
                              std::cos(off));
  const Eigen::Vector3d about(std::cos(axis), std::sin(axis), 0.0);
  Pose3 X_CB;
  X_CB.R = RotationBetween(Eigen::Vector3d::UnitZ(), sight) * RotZ(roll) *
           Eigen::AngleAxisd(tilt, about).toRotationMatrix();
  X_CB.p = r * sight;
  return X_CB;
}

bool Whole(const Camera& camera, const Pose3& X_CB, const Fiducial& mark, double diameter_m) {
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * kPi * i / 16;
    const Eigen::Vector2d p =
        mark.p_BF + 0.7 * diameter_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const auto pixel = camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0));
    if (!pixel || !camera.Sees(*pixel, 2.0)) return false;
  }
  return true;
}

bool Covered(const SyntheticScene& scene, const Fiducial& mark) {
  if (!scene.cover) return false;
  const Eigen::Vector2d from = (mark.p_BF - scene.cover->middle_B).cwiseAbs();
  const double margin = 0.5 * scene.board.disc_diameter_m;
  return ((from - 0.5 * scene.cover->size_m).array() < margin).all();
}

int WrongMarks(const HeldSample& sample, const StereoRig& rig, const Pose3& X_RB) {
  int wrong = 0;
  for (const SightingReport::Mark& mark : sample.report.marks) {
    const Camera& camera = mark.camera == 1 ? rig.right : rig.left;
    const Pose3 X_CB = Inverse(mark.camera == 1 ? rig.X_RQ : rig.X_RL) * X_RB;
    const Eigen::Vector2d p = sample.scene.board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0);
    const double radius_px =
        0.5 * sample.scene.board.disc_diameter_m * camera.focal_px().x() / p_C.norm();
    const auto pixel = camera.Project(p_C);
    wrong += !pixel || (*pixel - Eigen::Vector2d(mark.u_px, mark.v_px)).norm() > 0.5 * radius_px;
  }
  return wrong;
}

}  // namespace

FiducialBoard PlainGrid(int columns, int rows, double pitch_m, double diameter_m,
                        double upright_within_rad) {
  FiducialBoard board{
      .width_m = columns * pitch_m,
      .height_m = rows * pitch_m,
      .disc_diameter_m = diameter_m,
      .fiducials = {},
      .upright = {.against = Upright::Against::kImage, .within_rad = upright_within_rad}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      board.fiducials.push_back(
          {.p_BF = {(column - 0.5 * (columns - 1)) * pitch_m, (row - 0.5 * (rows - 1)) * pitch_m}});
    }
  }
  return board;
}

FiducialBoard BarBoard(int count, double diameter_m) {
  // In diameters: bars of four directions in the first four, wide apart.
  const double layout[8][3] = {{-3.0, -1.8, 0}, {2.6, -1.6, 45}, {3.0, 1.7, 90},  {-2.4, 1.8, -45},
                               {0.1, -1.9, 90}, {0.4, 1.6, 0},   {-3.1, 0.1, 45}, {2.9, 0.0, -45}};
  FiducialBoard board{.width_m = 8.0 * diameter_m,
                      .height_m = 5.4 * diameter_m,
                      .disc_diameter_m = diameter_m,
                      .bar_length_m = 0.64 * diameter_m,
                      .bar_width_m = 0.22 * diameter_m,
                      .fiducials = {}};
  for (int i = 0; i < count; ++i) {
    board.fiducials.push_back({.p_BF = diameter_m * Eigen::Vector2d(layout[i][0], layout[i][1]),
                               .rotation = Radians(layout[i][2])});
  }
  return board;
}

Camera PinholeCamera(int width, int height, double horizontal_fov_rad, double k1) {
  const double f = 0.5 * width / std::tan(0.5 * horizontal_fov_rad);
  BrownPinhole lens{.fx = f, .fy = f, .cx = 0.5 * (width - 1), .cy = 0.5 * (height - 1)};
  lens.k1 = k1;
  return {.width = width, .height = height, .lens = lens};
}

StereoRig HeldRig(const HeldOptions& options) {
  StereoRig rig = TestRig(640, 480);
  rig.left = rig.right = options.camera;
  rig.X_RL.p = {0.0, 0.5 * options.baseline_m, 0.0};
  rig.X_RQ.p = {0.0, -0.5 * options.baseline_m, 0.0};
  return rig;
}

HeldSample TakeHeld(const HeldOptions& options, std::uint64_t i) {
  RandomStream random(StreamKey(i, "held board"));
  const StereoRig rig = HeldRig(options);
  const Pose3 X_CB = Held(options, random);
  const Pose3 X_RB = rig.X_RL * X_CB;
  HeldSample sample;
  sample.scene.board = options.board;
  sample.scene.has_board = options.has_board;
  sample.scene.has_station = false;
  sample.scene.X_DR = Pose3::Translation(0.0, 0.0, 1.2);  // above the ground
  sample.scene.X_DB = sample.scene.X_DR * X_RB;
  sample.scene.clutter_fiducials = options.clutter;
  sample.scene.noise_dn = options.noise_dn;
  sample.scene.samples = options.samples;
  sample.scene.seed = i + 1;
  if (options.covered_share > 0.0) {
    const double width = options.covered_share * options.board.width_m;
    sample.scene.cover = {.middle_B = {0.5 * (width - options.board.width_m), 0.0},
                          .size_m = {width, options.board.height_m}};
  }
  for (const Fiducial& mark : options.board.fiducials) {
    sample.in_view +=
        Whole(rig.left, X_CB, mark, options.board.disc_diameter_m) && !Covered(sample.scene, mark);
  }
  sample.images.left = SyntheticView(sample.scene, rig.left, rig.X_RL);
  if (!options.left_only) sample.images.right = SyntheticView(sample.scene, rig.right, rig.X_RQ);
  sample.report = LocateBoard(sample.images, rig, options.board, {}).report;
  sample.wrong_marks = WrongMarks(sample, rig, X_RB);
  const Pose3& got = sample.report.X_RB;
  sample.place_error = (got.p - X_RB.p).norm() / X_CB.p.norm();
  sample.turn_error_rad = Eigen::AngleAxisd(got.R.transpose() * X_RB.R).angle();
  return sample;
}

HeldScore ScoreHeld(const HeldOptions& options, int count, int in_view) {
  HeldScore score;
  for (std::uint64_t i = 0; score.pairs < count; ++i) {
    const std::clock_t begin = std::clock();
    const HeldSample sample = TakeHeld(options, i);
    if (sample.in_view < in_view) continue;
    score.cpu_s += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    ++score.pairs;
    if (!sample.report.accepted) continue;
    ++score.accepted;
    score.marks += static_cast<int>(sample.report.marks.size());
    score.wrong_marks += sample.wrong_marks;
    const bool wrong = sample.place_error > 0.1 || sample.turn_error_rad > Radians(10.0);
    score.wrong_poses += wrong;
    score.worst_place = std::max(score.worst_place, sample.place_error);
    score.worst_turn_rad = std::max(score.worst_turn_rad, sample.turn_error_rad);
  }
  return score;
}

}  // namespace dockyard
