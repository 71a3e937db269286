#include "sim/rocky7/user_click.h"

#include <cmath>
#include <optional>
#include <string>

#include "models/read/config_error.h"
#include "sim/base/random.h"
#include "sim/rigid/slope.h"
#include "sim/rocky7/visible_stone.h"
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

struct StartCamera {
  const StereoRig& rig;
  const LensRipple& ripple;  // of the left camera
  Pose3 X_GC;                // the left camera
};

StartCamera StartCameraOf(const BuiltRun& run, const Truth& truth) {
  const bool by_mast = run.world.boulder.has_value();
  const StereoRig& rig = by_mast ? run.mast_pair : run.front;
  const Pose3 X_GW = Inverse(SiteInWorld(run.world.X_WG, run.world.slope));
  const LensRipple& ripple = (by_mast ? run.mast_ripples : run.front_ripples)[0];
  return {rig, ripple, X_GW * (by_mast ? truth.X_WK : truth.X_WR) * rig.X_RL};
}

Eigen::Vector2d PixelOf(const StartCamera& from, const Eigen::Vector3d& p_G,
                        const std::string& otherwise) {
  const auto pixel = ProjectWith(from.ripple, from.rig.left, Inverse(from.X_GC) * p_G);
  if (!pixel || !from.rig.left.Sees(*pixel, kMargin * from.rig.left.width)) {
    throw ConfigError(otherwise);
  }
  return *pixel;
}

/// The first of some clicks about a pixel that the function takes; it gets the ray in G.
template <typename Accepts>
std::optional<Eigen::Vector2d> ClickAbout(const Scenario& scenario, const StartCamera& from,
                                          const Eigen::Vector2d& aim, double sigma_px,
                                          const Accepts& accepts) {
  RandomStream hand(StreamKey(scenario.seed, "click"));
  for (int click = 0; click < kMostClicks; ++click) {
    const double u = hand.Normal(), v = hand.Normal();
    const Eigen::Vector2d pixel = aim + sigma_px * Eigen::Vector2d(u, v);
    const Eigen::Vector3d ray_C = RayWith(from.ripple, from.rig.left, pixel).direction;
    if (accepts(from.X_GC.R * ray_C)) return pixel;
  }
  return std::nullopt;
}

UserClick ClickOnStone(const Scenario& scenario, const BuiltRun& run, const Truth& truth) {
  const StartCamera from = StartCameraOf(run, truth);
  const std::string otherwise =
      scenario.start_place + ": expected a start from where the front cameras see the target";
  const StonesInView stones = StonesAtStart(run.world, truth);
  const auto shows_another = [&](const Eigen::Vector3d& along_G) {
    return ShowsAnother(stones, from.X_GC.p, along_G);
  };
  Eigen::Vector3d aim_G = truth.X_GT.p;
  if (shows_another(aim_G - from.X_GC.p)) {
    const auto visible_G = VisibleMiddle(stones, run.world.ground, from.X_GC.p);
    if (!visible_G) throw ConfigError(otherwise + ": another stone hides it");
    aim_G = *visible_G;
  }
  const Eigen::Vector2d aim = PixelOf(from, aim_G, otherwise);
  const auto pixel =
      ClickAbout(scenario, from, aim, run.keys.click_px,
                 [&](const Eigen::Vector3d& along_G) { return !shows_another(along_G); });
  // Who misses that often takes care.
  return {pixel.value_or(aim), truth.X_GT.p};
}

UserClick ClickOnBoulder(const Scenario& scenario, const BuiltRun& run, const Truth& truth) {
  const StartCamera from = StartCameraOf(run, truth);
  const std::string otherwise =
      scenario.start_place + ": expected a start from where the mast's cameras see the target";
  std::optional<Eigen::Vector3d> shown_G;
  const auto pixel = ClickAbout(scenario, from, PixelOf(from, truth.X_GT.p, otherwise),
                                run.keys.click_px, [&](const Eigen::Vector3d& along_G) {
                                  shown_G = FirstOnRay(*run.world.boulder, from.X_GC.p, along_G);
                                  return shown_G && IsOnTarget(run.keys, *shown_G - truth.X_GT.p);
                                });
  if (!pixel) throw ConfigError(otherwise + " on the boulder");
  return {*pixel, *shown_G};
}

}  // namespace

UserClick ClickOn(const Scenario& scenario, const BuiltRun& run, const Truth& truth) {
  return run.world.boulder ? ClickOnBoulder(scenario, run, truth)
                           : ClickOnStone(scenario, run, truth);
}

}  // namespace dockyard::rocky7
