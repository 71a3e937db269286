#include "sim/app/detect_tags.h"

#include <algorithm>
#include <cmath>

#include "controller/vision/tags/tag_pose.h"

namespace dockyard {
namespace {

struct Sighted {
  bool right = false;
  CameraView view;
  TagSighting sighting;
};

void AddMarks(const Sighted& sighted, const FiducialBoard& board, SightingReport* report) {
  const Pose3 X_CB = Inverse(sighted.view.X_RC) * report->X_RB;
  for (std::size_t i = 0; i < board.tags.size(); ++i) {
    const Eigen::Vector2d& p = board.tags[i].p_BT;
    const auto pixel = sighted.view.camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0));
    if (!pixel) continue;
    const int id = static_cast<int>(i);
    const std::vector<int>& used = sighted.sighting.used;
    const bool found = std::find(used.begin(), used.end(), id) != used.end();
    if (!found && !sighted.view.camera.Sees(*pixel)) continue;
    (found ? report->marks : report->predicted)
        .push_back({.id = id, .camera = sighted.right, .u_px = pixel->x(), .v_px = pixel->y()});
  }
}

}  // namespace

SightingReport LocateTagsIn(const StereoImages& images, const StereoRig& rig,
                            const FiducialBoard& board, const ErrorAllowance& errors) {
  RefineOptions options;
  options.model_px = std::hypot(options.model_px, errors.calibration_px);
  options.off_plane_m = 0.3 * errors.flatness_m;  // of a bow: locate_dockyard.cc
  SightingReport report;
  report.detected = {0, 0};
  Sighted best;
  for (const bool right : {false, true}) {
    const GrayImage& image = right ? images.right : images.left;
    if (image.pixels.empty()) continue;
    const CameraView view{right ? rig.right : rig.left, right ? rig.X_RQ : rig.X_RL};
    const TagSighting sighting = LocateTagBoard(image, view, board, options);
    report.detected[right ? 1 : 0] = static_cast<int>(sighting.used.size());
    if (sighting.branches.empty()) continue;
    if (sighting.used.size() > best.sighting.used.size()) best = {right, view, sighting};
  }
  if (best.sighting.branches.empty()) {
    report.reason = "no tag of the board found";
    return report;
  }
  const TagBranch& branch = best.sighting.branches[0];
  report.accepted = true;
  report.method = best.right ? "right" : "left";
  report.reprojection_px = branch.rms_px;
  report.X_RB = branch.X_RB;
  report.covariance = branch.covariance;
  AddMarks(best, board, &report);
  return report;
}

}  // namespace dockyard
