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

PoseSample TakeSample(const SurveyOptions& options, int i) {
  const auto spread = [&](int base, double half) {
    return half * (2.0 * Halton(i + 1, base) - 1.0);
  };
  PoseSample sample{.at = {}, .out = {PoseFailure::kTooFewFiducials, {}}};
  sample.at.r = options.r_min_m + (options.r_max_m - options.r_min_m) * Halton(i + 1, 2);
  sample.at.alpha = spread(3, options.alpha_rad);
  sample.at.h = spread(5, options.h_rad);
  sample.pitch_rad = spread(7, options.pitch_rad);
  SyntheticScene scene;
  scene.X_DR = RoverAt(sample.at, sample.pitch_rad);
  scene.seed = static_cast<std::uint64_t>(1000 + i);
  if (options.arrange) options.arrange(scene, i);
  const StereoRig rig = TestRig(options.width, options.height);
  const StereoRig built =
      options.miscalibrated ? Miscalibrated(rig, StreamKey(scene.seed, "rig")) : rig;
  sample.in_view =
      AllInView(scene, built.left, built.X_RL) || AllInView(scene, built.right, built.X_RQ);
  if (!sample.in_view) return sample;
  LocateHints hints;
  hints.up_R = scene.X_DR.R.transpose() * Eigen::Vector3d::UnitZ();
  sample.out = LocateBoard(SyntheticPair(scene, built), rig, scene.board, hints);
  sample.wrong_marks = WrongMarks(scene, built, sample.out.report);
  if (!sample.out.sighting) return sample;
  const Pose3 X_DR = scene.X_DB * Inverse(sample.out.sighting->X_RB);
  const DockingCoords seen = ToDockingCoords(ToGround(X_DR));
  sample.range_error_m = seen.r - sample.at.r;
  sample.heading_error_rad = WrapPi(seen.h - sample.at.h);
  sample.place_error_m = (X_DR.p - scene.X_DR.p).head<2>().norm();
  return sample;
}

std::vector<PoseSample> Survey(const SurveyOptions& options, int count) {
  std::vector<PoseSample> pairs;
  for (int i = 0; static_cast<int>(pairs.size()) < count && i < 20 * count; ++i) {
    PoseSample sample = TakeSample(options, i);
    if (sample.in_view) pairs.push_back(std::move(sample));
  }
  return pairs;
}

}  // namespace dockyard
