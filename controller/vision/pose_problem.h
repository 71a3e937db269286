// Internal to the vision room. The equations of RefinePoints: errors of points in one image or two,
// over their sigmas, with their derivatives.
#pragma once

#include <array>
#include <vector>

#include "controller/vision/pose_refine.h"

namespace dockyard {

/// The unknowns: the body's pose and the cameras' relative turn.
struct PoseEstimate {
  Pose3 X_RB;
  Eigen::Vector3d turn_rad = Eigen::Vector3d::Zero();
};

/// A step away from an estimate: turn about B's axes, shift in R, relative turn. The last three
/// stay zero when the turn is not sought.
using PoseStep = Eigen::Matrix<double, 9, 1>;
PoseEstimate Moved(const PoseEstimate& at, const PoseStep& step);

/// Normal equations of the step, Huber's weights applied.
struct NormalEquations {
  Eigen::Matrix<double, 9, 9> A;
  PoseStep b;  // A step = -b
};

class PoseProblem {
 public:
  /// All three must outlive it.
  PoseProblem(const std::vector<PointPixel>& points, const std::vector<CameraView>& views,
              const RefineOptions& options);

  bool joint() const { return joint_; }  // whether the relative turn is sought
  std::size_t size() const { return points_.size(); }

  /// Sets, for this pose, by how much the centre of a disc's image is off the image of its centre.
  /// @returns the largest change [px]
  double UpdateOffsets(const PoseEstimate& at);

  /// Huber's loss on each point's error in sigmas, the turn's prior added.
  double Cost(const PoseEstimate& at) const;
  double Cost(const PoseEstimate& at, NormalEquations* normal) const;

  /// Error of each point [px].
  std::vector<Eigen::Vector2d> Errors(const PoseEstimate& at) const;

  /// One point: its error over sigma, the derivative by the step, and the derivative by the errors
  /// of its camera's calibration in sigmas: focal length, centre along u and v, radial term.
  struct PointRows {
    Eigen::Vector2d error;
    Eigen::Matrix<double, 2, 9> by_step;
    Eigen::Matrix<double, 2, 4> by_calibration;
    double weight = 1.0;  // Huber's
  };
  PointRows Rows(const PoseEstimate& at, std::size_t point) const;
  /// Root of the information of the turn's prior, and the prior's error in sigmas.
  const Eigen::Matrix3d& prior_root() const { return prior_root_; }
  Eigen::Vector3d PriorError(const PoseEstimate& at) const;

 private:
  struct PosedCamera {
    Eigen::Matrix3d R_CR, R_CB;
    Eigen::Vector3d p_CR, p_CB;
    Eigen::Matrix3d turn_by_step;  // of d p_C = [p_C]x turn_by_step d turn
  };
  std::array<PosedCamera, 2> PosedCameras(const PoseEstimate& at) const;
  double Sigma(std::size_t point) const;
  Eigen::Vector2d Error(const PosedCamera& posed, std::size_t point, PixelJacobian* J) const;
  void Steps(const PosedCamera& posed, std::size_t point, const PixelJacobian& J,
             Eigen::Matrix<double, 2, 9>* by_step) const;

  const std::vector<PointPixel>& points_;
  const std::vector<CameraView>& views_;
  const RefineOptions& options_;
  bool joint_ = false;
  Eigen::Matrix3d prior_root_ = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Vector2d> offsets_;
};

}  // namespace dockyard
