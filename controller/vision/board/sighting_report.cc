#include "controller/vision/board/sighting_report.h"

#include <algorithm>

namespace dockyard {

Pose3 TurnedView(const std::vector<CameraView>& views, std::size_t view,
                 const Eigen::Vector3d& turn_rad) {
  Pose3 X_RC = views[view].X_RC;
  const Eigen::Vector3d half = (view == 0 ? -0.5 : 0.5) * turn_rad;
  if (half.norm() > 1e-14) {
    X_RC.R = X_RC.R * Eigen::AngleAxisd(half.norm(), half.normalized()).toRotationMatrix();
  }
  return Inverse(X_RC);
}

void Describe(const Fix& fix, const std::vector<CameraView>& views, const FiducialBoard& board,
              SightingReport* report) {
  report->method = fix.method;
  report->reprojection_px = fix.fit.rms_px;
  report->X_RB = fix.fit.X_RB;
  report->covariance = fix.fit.covariance;
  report->camera_turn_rad = fix.fit.turn.mean_rad;
  report->camera_turn_sigma_rad = fix.fit.turn.covariance.diagonal().cwiseSqrt();
  for (const MarkPixel& mark : fix.marks) {
    report->marks.push_back(
        {.id = mark.id, .camera = mark.view, .u_px = mark.pixel.x(), .v_px = mark.pixel.y()});
  }
  for (std::size_t view = 0; view < views.size(); ++view) {
    const Pose3 X_CB = TurnedView(views, view, fix.fit.turn.mean_rad) * fix.fit.X_RB;
    for (int id = 0; id < static_cast<int>(board.fiducials.size()); ++id) {
      const bool measured = std::any_of(fix.marks.begin(), fix.marks.end(), [&](const auto& m) {
        return m.id == id && m.view == static_cast<int>(view);
      });
      if (measured) continue;
      const auto pixel =
          ProjectDisc(views[view].camera, X_CB, board.fiducials[static_cast<std::size_t>(id)],
                      board.disc_diameter_m);
      if (!pixel || !views[view].camera.Sees(*pixel)) continue;
      report->predicted.push_back(
          {.id = id, .camera = static_cast<int>(view), .u_px = pixel->x(), .v_px = pixel->y()});
    }
  }
}

LocateOutput Refused(PoseFailure failure, SightingReport report) {
  report.accepted = false;
  report.reason = Name(failure);
  return {failure, std::move(report)};
}

LocateOutput Accepted(const Fix& fix, const LocateHints& hints, SightingReport report) {
  report.accepted = true;
  const bool stereo = fix.method == "stereo";
  const DockSighting sighting{.X_RB = fix.fit.X_RB,
                              .reprojection_px = fix.fit.rms_px,
                              .fiducials_used = static_cast<int>(fix.marks.size()),
                              .stereo = stereo,
                              .covariance = fix.fit.covariance,
                              .camera_turn = stereo ? fix.fit.turn : hints.camera_turn};
  return {sighting, std::move(report)};
}

}  // namespace dockyard
