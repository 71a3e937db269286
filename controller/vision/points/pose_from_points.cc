#include "controller/vision/points/point_pose.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/vision/points/point_fit.h"
#include "controller/vision/points/point_search.h"
#include "controller/vision/robust_planar_pose.h"
#include "controller/vision/stereo_pose.h"

namespace dockyard {
namespace {

Result<PointPose, PoseFailure> AsTsai(const std::vector<PointPixel>& points, const StereoRig& rig,
                                      const std::vector<CameraView>& views) {
  PointPose pose{.fit = {},
                 .inlier = std::vector<bool>(points.size(), true),
                 .method = Method(points, std::vector<bool>(points.size(), true)),
                 .other_RB = {}};
  if (pose.method == "stereo") {
    std::vector<Eigen::Vector3d> points_B, points_R;
    for (const PointPixel& left : points) {
      for (const PointPixel& right : points) {
        if (left.view != 0 || right.view != 1 || left.p_B != right.p_B) continue;
        const auto p_R = Triangulate(rig, left.pixel, right.pixel);
        if (!p_R) continue;
        points_B.push_back(left.p_B);
        points_R.push_back(*p_R);
      }
    }
    if (points_B.size() < 3) return PoseFailure::kTooFewFiducials;
    const auto X_RB = FitRigid(points_B, points_R);
    if (!X_RB) return PoseFailure::kNoCorrespondence;
    pose.fit.X_RB = *X_RB;
  } else {
    if (points.size() < 4) return PoseFailure::kTooFewFiducials;
    Eigen::Vector3d centre_B;
    const auto normal_B = PlaneNormal(points, &centre_B);
    if (!normal_B) return PoseFailure::kNoCorrespondence;
    // P: a frame in the plane, z along the normal.
    Pose3 X_BP;
    X_BP.R = RotationBetween(Eigen::Vector3d::UnitZ(), *normal_B);
    X_BP.p = centre_B;
    const CameraView& view = views[pose.method == "left" ? 0 : 1];
    std::vector<Eigen::Vector2d> points_P, sights;
    for (const PointPixel& point : points) {
      points_P.push_back((Inverse(X_BP) * point.p_B).head<2>());
      sights.push_back(LinearSight(view.camera, point.pixel));
    }
    // The plane may face either way: the frame's start assumes z away from the camera.
    auto minima = RobustPlanarPose(points_P, sights);
    const Pose3 X_PF{RotX(kPi), Eigen::Vector3d::Zero()};
    std::vector<Eigen::Vector2d> points_F;
    for (const Eigen::Vector2d& p : points_P) points_F.emplace_back(p.x(), -p.y());
    for (PlanarMinimum minimum : RobustPlanarPose(points_F, sights)) {
      minimum.X_CB = minimum.X_CB * Inverse(X_PF);
      minima.push_back(minimum);
    }
    const auto best = std::min_element(minima.begin(), minima.end(),
                                       [](auto& a, auto& b) { return a.error < b.error; });
    if (best == minima.end()) return PoseFailure::kNoCorrespondence;
    pose.fit.X_RB = view.X_RC * best->X_CB * Inverse(X_BP);
  }
  for (const PixelError& error :
       ErrorsOf(points, views, {.pose = {.X_RB = pose.fit.X_RB}}, false)) {
    pose.fit.mark_error_px.push_back(error.error_px.norm());
  }
  double sum = 0.0;
  for (const double error : pose.fit.mark_error_px) sum += error * error;
  pose.fit.rms_px = std::sqrt(sum / static_cast<double>(points.size()));
  return pose;
}

}  // namespace

Result<PointPose, PoseFailure> PoseFromPoints(const std::vector<PointPixel>& points,
                                              const StereoRig& rig, const VisionSettings& settings,
                                              const PointOptions& options) {
  const std::vector<CameraView> views = Views(rig);
  return settings.pipeline == VisionPipeline::kTsai2013 ? AsTsai(points, rig, views)
                                                        : SearchPose(points, views, options);
}

}  // namespace dockyard
