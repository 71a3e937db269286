#include "vision/survey.h"

#include <algorithm>

#include "sim/base/random.h"

namespace dockyard {
namespace {

/// Halton's sequence (Numerische Mathematik 2, 1960), 0..1.
double Halton(int index, int base) {
  double value = 0.0, share = 1.0 / base;
  for (int i = index; i > 0; i /= base, share /= base) value += share * (i % base);
  return value;
}

bool AllInView(const SyntheticScene& scene, const Camera& camera, const Pose3& X_RC) {
  const Pose3 X_CB = Inverse(scene.X_DR * X_RC) * scene.X_DB;
  return std::all_of(
      scene.board.fiducials.begin(), scene.board.fiducials.end(), [&](const Fiducial& fiducial) {
        const auto pixel =
            camera.Project(X_CB * Eigen::Vector3d(fiducial.p_BF.x(), fiducial.p_BF.y(), 0.0));
        return pixel && camera.Sees(*pixel, 10.0);
      });
}

/// Marks further than 3 px, or 4 % of the disc, from the fiducial that they are said to be.
int WrongMarks(const SyntheticScene& scene, const StereoRig& rig, const SightingReport& report) {
  int wrong = 0;
  for (const SightingReport::Mark& mark : report.marks) {
    const Camera& camera = mark.camera == 1 ? rig.right : rig.left;
    const Pose3 X_CB = Inverse(scene.X_DR * (mark.camera == 1 ? rig.X_RQ : rig.X_RL)) * scene.X_DB;
    const Eigen::Vector2d& p = scene.board.fiducials[static_cast<std::size_t>(mark.id)].p_BF;
    const auto pixel = camera.Project(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0));
    const double allowed = 3.0 + 0.004 * camera.focal_px().x() / X_CB.p.norm();
    if (!pixel || (*pixel - Eigen::Vector2d(mark.u_px, mark.v_px)).norm() > allowed) ++wrong;
  }
  return wrong;
}

}  // namespace

Look TakeLook(const SurveyOptions& options, int i) {
  const auto spread = [&](int base, double half) {
    return half * (2.0 * Halton(i + 1, base) - 1.0);
  };
  Look look{.at = {}, .out = {PoseFailure::kTooFewFiducials, {}}};
  look.at.r = options.r_min_m + (options.r_max_m - options.r_min_m) * Halton(i + 1, 2);
  look.at.alpha = spread(3, options.alpha_rad);
  look.at.h = spread(5, options.h_rad);
  look.pitch_rad = spread(7, options.pitch_rad);
  SyntheticScene scene;
  scene.X_DR = RoverAt(look.at, look.pitch_rad);
  scene.seed = static_cast<std::uint64_t>(1000 + i);
  if (options.arrange) options.arrange(scene, i);
  const StereoRig rig = TestRig(options.width, options.height);
  const StereoRig built =
      options.miscalibrated ? Miscalibrated(rig, StreamKey(scene.seed, "rig")) : rig;
  look.in_view =
      AllInView(scene, built.left, built.X_RL) || AllInView(scene, built.right, built.X_RQ);
  if (!look.in_view) return look;
  LocateHints hints;
  hints.up_R = scene.X_DR.R.transpose() * Eigen::Vector3d::UnitZ();
  look.out = LocateBoard(SyntheticPair(scene, built), rig, scene.board, hints);
  look.wrong_marks = WrongMarks(scene, built, look.out.report);
  if (!look.out.sighting) return look;
  const Pose3 X_DR = scene.X_DB * Inverse(look.out.sighting->X_RB);
  const DockingCoords seen = ToDockingCoords(ToGround(X_DR));
  look.range_error_m = seen.r - look.at.r;
  look.heading_error_rad = WrapPi(seen.h - look.at.h);
  look.place_error_m = (X_DR.p - scene.X_DR.p).head<2>().norm();
  return look;
}

std::vector<Look> Survey(const SurveyOptions& options, int count) {
  std::vector<Look> looks;
  for (int i = 0; static_cast<int>(looks.size()) < count && i < 20 * count; ++i) {
    Look look = TakeLook(options, i);
    if (look.in_view) looks.push_back(std::move(look));
  }
  return looks;
}

}  // namespace dockyard
