// Files of cameras in a scratch folder, and what OpenCV makes of their numbers.
#pragma once

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "models/read/load_cameras.h"
#include "support/bad_files.h"

namespace dockyard {

inline const cv::Matx33d kK(620.5, 0, 322.1, 0, 621.3, 241.7, 0, 0, 1);

/// The pixel of a point by OpenCV, with kK and these coefficients.
inline Eigen::Vector2d ByOpenCv(const std::vector<double>& d, const Eigen::Vector3d& p) {
  std::vector<cv::Point2d> pixels;
  cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(), cv::Vec3d(), kK,
                    d, pixels);
  return {pixels[0].x, pixels[0].y};
}

class Calibration : public testing::Test {
 protected:
  PlacedCamera Load(const std::string& text, const std::string& name = {}) const {
    return LoadCamera(folder_.Write("c.yaml", text), name);
  }
  std::string Message(const std::string& text) const {
    const std::string file = folder_.Write("c.yaml", text);
    return MessageOf([&] { LoadCamera(file); }, folder_);
  }
  std::string RigMessage(const std::string& text) const {
    const std::string file = folder_.Write("r.yaml", text);
    return MessageOf([&] { LoadRig(file); }, folder_);
  }
  StereoRig Rig(const std::string& text) const { return LoadRig(folder_.Write("r.yaml", text)); }

  ScratchFolder folder_;
  const Eigen::Vector3d p_{0.3, -0.2, 1.0};
};

/// Pose of the right camera in the left one.
inline Pose3 RightInLeft(const StereoRig& rig) { return Inverse(rig.X_RL) * rig.X_RQ; }

}  // namespace dockyard
