#include "sim/app/point_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "models/read/yaml_reader.h"
#include "sim/app/vision_files.h"

namespace dockyard {
namespace {

Json Three(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

std::size_t Used(const PointPose& pose) {
  return static_cast<std::size_t>(std::count(pose.inlier.begin(), pose.inlier.end(), true));
}

/// Of the dockyard pipeline; the other has no such numbers.
bool HasCovariance(const PointPose& pose) { return !pose.fit.covariance.isZero(); }

std::string Cells(const Pose3& X, const Matrix6d& covariance) {
  const Eigen::Quaterniond q(X.R);
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  std::string cells;
  for (const double value :
       {X.p.x(), X.p.y(), X.p.z(), sign * q.w(), sign * q.x(), sign * q.y(), sign * q.z()}) {
    cells += "," + NumberText(value);
  }
  for (int i = 0; i < 6; ++i) {
    cells += covariance.isZero() ? "," : "," + NumberText(std::sqrt(covariance(i, i)));
  }
  return cells;
}

}  // namespace

InversePose Inverted(const Pose3& X_RB, const Matrix6d& covariance) {
  // X_RB moved by (d, w) has the inverse X_BR moved by -R_BR (d - w x p) and turned by -R_BR w.
  const Eigen::Matrix3d R_BR = X_RB.R.transpose();
  const Eigen::Vector3d& p = X_RB.p;
  Eigen::Matrix3d cross;
  cross << 0, -p.z(), p.y(), p.z(), 0, -p.x(), -p.y(), p.x(), 0;
  Matrix6d T = Matrix6d::Zero();
  T.topLeftCorner<3, 3>() = -R_BR;
  T.topRightCorner<3, 3>() = -R_BR * cross;
  T.bottomRightCorner<3, 3>() = -R_BR;
  return {.X_BR = Inverse(X_RB), .covariance = T * covariance * T.transpose()};
}

namespace {

std::string WhyNoPose(const FrameAnswer& answer) {
  switch (answer.pose.error()) {
    case PoseFailure::kTooFewFiducials:
      return "fewer than four different points agree; three fix a pose and agree with any";
    case PoseFailure::kNoCorrespondence:
      return "fewer than half of the points agree on a pose, or so few that accident explains it";
    case PoseFailure::kCamerasDisagree:
      return "the points of one camera alone agree on a pose, those of both do not";
    case PoseFailure::kUncertain:
      return "the points do not fix a pose: 1 sigma above 30 deg or half the distance";
    case PoseFailure::kPoorFit:
      return "chi-square " + NumberText(std::round(answer.chi_square)) + " of " +
             std::to_string(answer.freedom);
    default:
      return "";
  }
}

}  // namespace

std::string Detail(const FrameAnswer& answer) {
  if (answer.pipeline != PipelineName(VisionPipeline::kDockyard)) return "";
  const std::string why = WhyNoPose(answer);
  return answer.agree_when.empty() ? why : why + "; " + answer.agree_when;
}

Json FrameJson(const PointFrame& frame, const FrameAnswer& answer) {
  Json json;
  if (!frame.name.empty()) json["frame"] = frame.name;
  json["pipeline"] = answer.pipeline;
  json["accepted"] = static_cast<bool>(answer.pose);
  json["reason"] = answer.pose ? Json() : Json(Name(answer.pose.error()));
  json["not_detected"] = frame.not_detected;
  if (!answer.pose) {
    json["detail"] = Detail(answer);
    json["warnings"] = answer.warnings;
    return json;
  }
  const PointPose& pose = *answer.pose;
  json["method"] = pose.method;
  json["body_in_rover"] = PoseJson(pose.fit.X_RB, pose.fit.covariance);
  const InversePose inverse = Inverted(pose.fit.X_RB, pose.fit.covariance);
  json["rover_in_body"] = PoseJson(inverse.X_BR, inverse.covariance);
  json["reprojection_px"] = pose.fit.rms_px;
  json["points_used"] = Used(pose);
  json["inlier"] = pose.inlier;
  if (HasCovariance(pose)) {
    json["chi_square"] = pose.fit.misfit;
    json["freedom"] = pose.fit.freedom;
    json["pixel_sigma_px"] = pose.sigma_px;
    json["survey_error_m"] = answer.survey_m;
    json["survey_share"] = pose.survey_share;
    const bool both = pose.method == "stereo";
    json["camera_turn_rad"] = both ? Three(pose.fit.turn.mean_rad) : Json();
    json["camera_turn_sigma_rad"] =
        both ? Three(pose.fit.turn.covariance.diagonal().cwiseSqrt()) : Json();
  }
  // Of a plane seen by one camera: the other pose that its image allows, and by how many sigmas
  // squared it fits worse.
  json["other_branch"] = pose.other_RB ? PoseJson(*pose.other_RB, Matrix6d::Zero()) : Json();
  if (pose.other_RB) json["other_branch"]["cost_more"] = pose.other_cost - pose.fit.cost;
  json["warnings"] = answer.warnings;
  return json;
}

std::string PoseTableHeader() {
  std::string header =
      "frame,accepted,reason,method,points,points_used,reprojection_px,chi_square,freedom";
  for (const char* of : {"body_in_rover", "rover_in_body"}) {
    for (const char* what :
         {"x_m", "y_m", "z_m", "qw", "qx", "qy", "qz", "sigma_x_m", "sigma_y_m", "sigma_z_m",
          "sigma_turn_x_rad", "sigma_turn_y_rad", "sigma_turn_z_rad"}) {
      header += std::string(",") + of + "." + what;
    }
  }
  return header + ",camera_turn_x_rad,camera_turn_y_rad,camera_turn_z_rad";
}

std::string PoseTableRow(const PointFrame& frame, const FrameAnswer& answer) {
  std::string row = frame.name + (answer.pose ? ",1,," : ",0,");
  const std::string points = "," + std::to_string(frame.points.size());
  if (!answer.pose) {
    row += std::string(Name(answer.pose.error())) + "," + points;
    return row + std::string(4 + 26 + 3, ',');
  }
  const PointPose& pose = *answer.pose;
  row +=
      pose.method + points + "," + std::to_string(Used(pose)) + "," + NumberText(pose.fit.rms_px);
  row += HasCovariance(pose)
             ? "," + NumberText(pose.fit.misfit) + "," + std::to_string(pose.fit.freedom)
             : ",,";
  const InversePose inverse = Inverted(pose.fit.X_RB, pose.fit.covariance);
  row += Cells(pose.fit.X_RB, pose.fit.covariance) + Cells(inverse.X_BR, inverse.covariance);
  if (!HasCovariance(pose) || pose.method != "stereo") return row + ",,,";
  const Eigen::Vector3d& turn = pose.fit.turn.mean_rad;
  return row + "," + NumberText(turn.x()) + "," + NumberText(turn.y()) + "," + NumberText(turn.z());
}

std::string FrameText(const PointFrame& frame, const FrameAnswer& answer, bool rows) {
  const std::string head = frame.name.empty() ? "" : "frame " + frame.name + ": ";
  if (!answer.pose) {
    const std::string detail = Detail(answer);
    return head + "no pose: " + Name(answer.pose.error()) + (detail.empty() ? "" : ": " + detail);
  }
  const PointPose& pose = *answer.pose;
  char part[200];
  std::snprintf(part, sizeof part, "body (%s, %zu of %zu points, %.3f px rms", pose.method.c_str(),
                Used(pose), frame.points.size(), pose.fit.rms_px);
  std::string text = head + part;
  if (HasCovariance(pose)) {
    std::snprintf(part, sizeof part, ", chi-square %.1f of %d", pose.fit.misfit, pose.fit.freedom);
    text += part;
  }
  text += "): " + PoseText(pose.fit.X_RB, pose.fit.covariance);
  if (!rows) return text;
  const InversePose inverse = Inverted(pose.fit.X_RB, pose.fit.covariance);
  text += "\nrover in the body: " + PoseText(inverse.X_BR, inverse.covariance);
  if (HasCovariance(pose) && pose.method == "stereo") {
    const Eigen::Vector3d& turn = pose.fit.turn.mean_rad;
    std::snprintf(part, sizeof part,
                  "\nright camera against the left: turned %.3f %.3f %.3f deg about its x y z",
                  Degrees(turn.x()), Degrees(turn.y()), Degrees(turn.z()));
    text += part;
  }
  if (pose.other_RB) {
    std::snprintf(part, sizeof part,
                  "\nor, fitting worse by %.1f sigma^2: ", pose.other_cost - pose.fit.cost);
    text += part + PoseText(*pose.other_RB, Matrix6d::Zero());
  }
  for (std::size_t i = 0; i < pose.inlier.size(); ++i) {
    if (!pose.inlier[i]) text += "\nrow " + std::to_string(frame.rows[i]) + " left out";
  }
  return text;
}

}  // namespace dockyard
