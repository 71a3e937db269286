// Reports of the command pose on a frame: JSON, a row of a table, a line of text.
#pragma once

#include <string>

#include "controller/vision/points/point_pose.h"
#include "sim/app/point_files.h"
#include "sim/base/json.h"

namespace dockyard {

struct FrameAnswer {
  Result<PointPose, PoseFailure> pose = PoseFailure::kTooFewFiducials;
  double survey_m = 0.0;  // survey error of points whose row states none
  // Refused, but with this changed the points agree; part of a sentence.
  std::string agree_when{};
  double chi_square = 0.0;  // of a pose that was refused as a poor fit
  int freedom = 0;
  std::string pipeline;
  std::vector<std::string> warnings{};
};

/// The rover in the body's frame, with the covariance in the order of Matrix6d: place, then a small
/// turn about the body's axes.
struct InversePose {
  Pose3 X_BR;
  Matrix6d covariance = Matrix6d::Zero();
};
InversePose Inverted(const Pose3& X_RB, const Matrix6d& covariance);

/// Why there is no pose, as part of a sentence.
std::string Detail(const FrameAnswer& answer);

Json FrameJson(const PointFrame& frame, const FrameAnswer& answer);

/// Header and rows of --csv.
std::string PoseTableHeader();
std::string PoseTableRow(const PointFrame& frame, const FrameAnswer& answer);

/// One line; with `rows`, further lines name the rows that were left out.
std::string FrameText(const PointFrame& frame, const FrameAnswer& answer, bool rows);

}  // namespace dockyard
