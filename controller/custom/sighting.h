// The seam between images and the docking: poses of the dock's boards as one image shows them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller/base/result.h"
#include "controller/custom/nominal/nominal.h"
#include "controller/custom/refusal.h"
#include "controller/io/belief.h"
#include "controller/io/sensors.h"

namespace dockyard::custom {

/// A pose of a board that explains an image.
struct PoseBranch {
  Pose3 X_CB;
  double rms_px = 0.0;  // of the reprojection
  // Sum of squares of the reprojection errors by their sigmas, for comparing branches.
  double misfit = 0.0;
  int freedom = 0;  // what the misfit is on average, when the sigmas hold; 0: unknown
  // Of p_CB [m], then of a small turn of B about C's axes [rad].
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/// One board in one image.
struct BoardSighting {
  Tick exposed = 0;
  int camera = 0, board = 0;           // indices into the nominal lists
  std::vector<PoseBranch> branches{};  // both of the planar ambiguity, the better one first
  std::string failure{};               // why there are none
  int detected = 0;                    // marks, named or not
  std::vector<SightingReport::Mark> marks{};
};

/// All boards that an image shows. up_R: against gravity, unit, in the robot.
using Perceive = std::function<std::vector<BoardSighting>(const CameraImage& image,
                                                          const Eigen::Vector3d& up_R)>;

/// Boards of discs, with bars or plain (controller/vision/board).
Result<Perceive, Refusal> PerceiveDiscs(const Nominal& nominal);

/// Boards of square tags, each of one family.
Result<Perceive, Refusal> PerceiveTags(const Nominal& nominal);

/// Boards of either kind, each with discs or with tags.
Result<Perceive, Refusal> PerceiveMarks(const Nominal& nominal);

/// The image in grey: luminance of ITU-R BT.601 from colours.
GrayImage GreyOf(const CameraImage& image);

}  // namespace dockyard::custom
