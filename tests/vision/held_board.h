// Image pairs of a board held before two cameras, scored against the truth.
#pragma once

#include <cstdint>

#include "controller/vision/board/locate.h"
#include "vision/synthetic_view.h"

namespace dockyard {

/// A grid of plain discs about its middle, row by row; half a turn maps it onto itself.
FiducialBoard PlainGrid(int columns, int rows, double pitch_m, double diameter_m,
                        double upright_within_rad);
/// The first `count` of eight discs with bars, laid out without symmetry.
FiducialBoard BarBoard(int count, double diameter_m);
/// A pinhole with the barrel distortion of a wide lens.
Camera PinholeCamera(int width, int height, double horizontal_fov_rad, double k1);

struct HeldOptions {
  FiducialBoard board;
  Camera camera;  // both
  double baseline_m = 0.1;
  double r_min_m = 0.5, r_max_m = 2.0;
  double tilt_rad = 40.0 * kPi / 180.0;  // of the board's normal against the line of sight, most
  double roll_rad = 10.0 * kPi / 180.0;  // either way
  double off_axis_rad = 10.0 * kPi / 180.0;  // of the line of sight, most
  double noise_dn = 2.0;
  int clutter = 0;           // discs like the board's on white ground, anywhere else
  double covered_share = 0;  // of the board's width, from its left edge
  bool has_board = true;
  bool left_only = false;  // the left image alone
  int samples = 3;
};

struct HeldSample {
  SyntheticScene scene;
  StereoImages images;
  int in_view = 0;  // marks whole in the left image and not covered
  SightingReport report;
  int wrong_marks = 0;  // further from the image of their true place than half a radius
  double place_error = 0.0, turn_error_rad = 0.0;  // place: over the range; of an accepted pose
};

StereoRig HeldRig(const HeldOptions& options);
/// Image pair i: its range, tilt, roll and place are drawn by i alone.
HeldSample TakeHeld(const HeldOptions& options, std::uint64_t i);

struct HeldScore {
  int pairs = 0, accepted = 0;
  int wrong_poses = 0;  // accepted and off by a tenth of the range or 10 deg
  int marks = 0, wrong_marks = 0;
  double worst_place = 0.0, worst_turn_rad = 0.0, cpu_s = 0.0;
};
/// Image pairs 0 to count - 1 that have at least `in_view` marks in view.
HeldScore ScoreHeld(const HeldOptions& options, int count, int in_view);

}  // namespace dockyard
