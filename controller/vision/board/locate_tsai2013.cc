#include <array>
#include <cmath>

#include "controller/vision/board/sighting_report.h"
#include "controller/vision/board/tsai2013.h"
#include "controller/vision/robust_planar_pose.h"
#include "controller/vision/stereo_pose.h"

namespace dockyard {
namespace {

using CorrespondenceResult = Result<TsaiCorrespondence, PoseFailure>;

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

/// Planar pose of the marks of one image under the linear model; the better branch, as the method
/// itself chooses.
std::optional<Pose3> FromOneCamera(const TsaiCorrespondence& named, const Camera& camera,
                                   const FiducialBoard& board) {
  std::vector<Eigen::Vector2d> points_B, sights;
  for (const MarkMatch& match : named.matches) {
    const std::size_t id = static_cast<std::size_t>(match.id);
    points_B.push_back(board.fiducials[id].p_BF);
    sights.push_back(LinearSight(camera, named.centres[id]));
  }
  const auto minima = RobustPlanarPose(points_B, sights);
  if (minima.empty()) return std::nullopt;
  return minima[0].X_CB;
}

void AddMarks(const TsaiCorrespondence& named, int view, const Camera& camera,
              SightingReport* report, std::vector<MarkPixel>* marks) {
  std::vector<bool> measured(named.centres.size(), false);
  for (const MarkMatch& match : named.matches) {
    const std::size_t id = static_cast<std::size_t>(match.id);
    measured[id] = true;
    marks->push_back({.id = match.id, .view = view, .pixel = named.centres[id]});
  }
  for (std::size_t id = 0; id < measured.size(); ++id) {
    if (measured[id] || !camera.Sees(named.centres[id])) continue;
    report->predicted.push_back({.id = static_cast<int>(id),
                                 .camera = view,
                                 .u_px = named.centres[id].x(),
                                 .v_px = named.centres[id].y()});
  }
}

}  // namespace

LocateOutput LocateTsai2013(const StereoImages& images, const StereoRig& rig,
                            const FiducialBoard& board, const LocateHints& hints,
                            const VisionSettings& settings) {
  const std::vector<CameraView> views = Views(rig);
  const std::array<const GrayImage*, 2> by_camera{&images.left, &images.right};
  std::vector<CorrespondenceResult> found;
  SightingReport report;
  for (std::size_t v = 0; v < 2; ++v) {
    const std::vector<DetectedFiducial> detections =
        DetectTsai2013(*by_camera[v], settings.tsai2013);
    report.detected.push_back(static_cast<int>(detections.size()));
    found.push_back(CorrespondTsai2013(detections, board, settings));
  }
  if (!found[0] && !found[1]) {
    const bool left_first = found[0].error() != PoseFailure::kTooFewFiducials;
    return Refused(found[left_first ? 0 : 1].error(), std::move(report));
  }
  Fix fix;
  std::vector<double> residual_px;
  for (int view = 0; view < 2; ++view) {
    const CorrespondenceResult& named = found[static_cast<std::size_t>(view)];
    if (!named) continue;
    AddMarks(*named, view, views[static_cast<std::size_t>(view)].camera, &report, &fix.marks);
    residual_px.insert(residual_px.end(), named->residual_px.begin(), named->residual_px.end());
  }
  fix.fit.rms_px = RootMeanSquare(residual_px);
  std::optional<Pose3> X_RB;
  if (found[0] && found[1]) {
    fix.method = "stereo";
    X_RB = StereoPose(rig, board, found[0]->centres, found[1]->centres);
  } else {
    const std::size_t view = found[0] ? 0 : 1;
    fix.method = view == 0 ? "left" : "right";
    const auto X_CB = FromOneCamera(*found[view], views[view].camera, board);
    if (X_CB) X_RB = views[view].X_RC * *X_CB;
  }
  for (const MarkPixel& mark : fix.marks) {
    report.marks.push_back(
        {.id = mark.id, .camera = mark.view, .u_px = mark.pixel.x(), .v_px = mark.pixel.y()});
  }
  report.method = fix.method;
  report.reprojection_px = fix.fit.rms_px;
  if (!X_RB) return Refused(PoseFailure::kPoorFit, std::move(report));
  fix.fit.X_RB = *X_RB;
  report.X_RB = *X_RB;
  // The paper names no gate on the pose; a board behind the cameras is none.
  if (!(X_RB->p.x() > 0.0)) return Refused(PoseFailure::kBehindCamera, std::move(report));
  return Accepted(fix, hints, std::move(report));
}

}  // namespace dockyard
