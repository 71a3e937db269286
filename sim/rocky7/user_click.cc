#include "sim/rocky7/user_click.h"

#include <cmath>

#include "models/read/config_error.h"
#include "sim/base/random.h"
#include "sim/rigid/slope.h"
#include "sim/vehicles/boulder.h"

namespace dockyard::rocky7 {
namespace {

// Of the image's width, to its border. Assumed, 0.01-0.03.
constexpr double kMargin = 1.0 / 64.0;
// Off the face's plane, beyond its roughness, is another surface. Assumed, 0.5-2 mm and 2-3 sigmas.
constexpr double kOffFace_m = 1e-3, kRoughnessSigmas = 2.0;
// Who misses the face so often does not see it. Assumed, 10-100.
constexpr int kMostClicks = 20;

// On a rounded rock a user clicks no further from the point that is meant. Assumed, 2-6 cm.
constexpr double kOfPoint_m = 0.04;

bool IsOnTarget(const Rocky7Keys& keys, const Eigen::Vector3d& from_middle_G) {
  if (keys.boulder == BoulderKind::kRounded) return from_middle_G.norm() < kOfPoint_m;
  const Eigen::Vector3d normal_G =
      FaceNormal({.face_up_rad = keys.face_up_rad, .face_turn_rad = keys.face_turn_rad});
  return std::abs(normal_G.dot(from_middle_G)) < kOffFace_m + kRoughnessSigmas * keys.roughness_m;
}

}  // namespace

UserClick ClickOn(const Scenario& scenario, const BuiltRun& run, const Truth& truth) {
  const bool by_mast = run.world.boulder.has_value();
  const StereoRig& rig = by_mast ? run.mast_pair : run.front;
  const Pose3 X_GW = Inverse(SiteInWorld(run.world.X_WG, run.world.slope));
  const Pose3 X_GC = X_GW * (by_mast ? truth.X_WK : truth.X_WR) * rig.X_RL;
  const auto middle = rig.left.Project(Inverse(X_GC) * truth.X_GT.p);
  if (!middle || !rig.left.Sees(*middle, kMargin * rig.left.width)) {
    throw ConfigError(scenario.start_place + ": expected a start from where the " +
                      (by_mast ? "mast's" : "front") + " cameras see the target");
  }
  RandomStream hand(StreamKey(scenario.seed, "click"));
  for (int click = 0; click < kMostClicks; ++click) {
    const double u = hand.Normal(), v = hand.Normal();
    const Eigen::Vector2d pixel = *middle + run.keys.click_px * Eigen::Vector2d(u, v);
    if (!by_mast) return {pixel, truth.X_GT.p};
    const auto shown_G = FirstOnRay(*run.world.boulder, X_GC.p, X_GC.R * rig.left.Direction(pixel));
    if (shown_G && IsOnTarget(run.keys, *shown_G - truth.X_GT.p)) return {pixel, *shown_G};
  }
  throw ConfigError(
      scenario.start_place +
      ": expected a start from where the mast's cameras see the target on the boulder");
}

}  // namespace dockyard::rocky7
