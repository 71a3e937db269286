#include "sim/raposa/raposa_plant.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "controller/base/split_mix.h"
#include "render/shutter.h"
#include "sim/base/random.h"
#include "sim/plant/scenery.h"

namespace dockyard::raposa {
namespace {

std::vector<MotorModel> MotorModels(const RobotModel& robot) {
  return {robot.motors.begin(), robot.motors.end()};
}

Lighting LightingOf(const Scenario& scenario, const BuiltRun& built) {
  const Pose3 X_WD =
      SiteInWorld(built.world.X_WG, built.world.slope) * FromGround(built.world.X_GD, 0.0);
  const Eigen::Vector3d p_DP(0.0, 0.0, built.world.pyramid.guide.height_m);
  Lighting lighting = MakeLighting(scenario.light, X_WD, p_DP, scenario.seed, scenario.sun);
  lighting.sun_and_sky.sun_irradiance *= built.keys.light_level;
  lighting.sun_and_sky.sky_irradiance *= built.keys.light_level;
  const Pose3 X_WG = SiteInWorld(built.world.X_WG, built.world.slope);
  AddItems(built.clutter, built.world.ground, X_WG, built.world.X_GD, lighting);
  AddScenery(scenario, built.world.ground, X_WG, built.world.X_GD, lighting);
  return lighting;
}

}  // namespace

RaposaPlant::RaposaPlant(const Scenario& scenario, BuiltRun built,
                         std::shared_ptr<KeptRenderer> renderer)
    : WorldPlant(scenario, std::move(built), std::move(renderer)),
      sensors_(built_.world.robot.imu.value_or(ImuModel{}), MotorModels(built_.world.robot),
               kControlPeriod, seed_),
      scene_(built_, LightingOf(scenario, built_), seed_),
      view_(ViewOf(built_.world.robot.camera)),
      sensor_(SensorOf(built_.world.robot.camera, built_.keys.balance_k, built_.keys.auto_balance)),
      exposed_(truth_) {}

// Without an inertial unit its sample stays zero.
SensorFrame RaposaPlant::Sense() {
  RefreshTruth();
  const TrueImu imu = built_.world.robot.imu ? world_.TakeTrueImu() : TrueImu(ImuSample{});
  return sensors_.Read(world_.tick(), {truth_.motors.begin(), truth_.motors.end()}, imu);
}

std::vector<CameraImage> RaposaPlant::TakeImages(const std::vector<int>& cameras,
                                                 double exposure_stops) {
  DOCKYARD_CHECK(std::abs(exposure_stops) <= kMostExposure_stops);
  if (cameras.empty()) return {};
  const BackCameraModel& camera = built_.world.robot.camera;
  const Pose3 X_WC = exposed_.X_WR * camera.X_RC;
  const Eigen::Vector3d v_W = exposed_.v_WR_W + exposed_.w_WR_W.cross(X_WC.p - exposed_.X_WR.p);
  const double range_m = std::max(0.1, exposed_.range_m);
  const double motion_px = MotionInExposure_px(camera.camera, exposed_.w_WR_W.norm(), v_W.norm(),
                                               range_m, camera.shutter_s);
  const ColourRadiance light = renderer_->Get().RenderThrough(
      scene_.Make(exposed_, world_.ground(), lamps_on_), scene_.colours(), view_,
      PosesInExposure(X_WC, v_W, exposed_.w_WR_W, camera.shutter_s, motion_px,
                      StepsUnderBlur(camera.blur_sigma_px)));
  const Tick now = world_.tick();
  const double since_s =
      last_picture_ ? static_cast<double>(now - *last_picture_) * kTickSeconds : 0.0;
  last_picture_ = now;
  const std::uint64_t key =
      SplitMix(StreamKey(seed_, "camera"), static_cast<std::uint64_t>(pictures_++));
  std::vector<CameraImage> images;
  images.push_back({kBackCamera,
                    ExposeColourView(light, sensor_, since_s, key, sensor_state_),
                    {},
                    camera.shutter_s});
  return images;
}

void RaposaPlant::Advance(const Commands& commands) {
  const auto motors = MotorsOf<kMotorCount>(commands);
  lamps_on_ = commands.switches.size() > kLamps && commands.switches[kLamps] != 0;
  const long steps = StepsIn(kControlPeriod);
  const auto before_end = std::lround(built_.world.robot.camera.delay_s / step_s_);
  if (before_end >= steps) exposed_ = world_.truth();
  for (long i = 0; i < steps; ++i) {
    world_.Step(motors);
    if (i + 1 == steps - before_end) exposed_ = world_.truth();
  }
}

Stage RaposaPlant::Look() const {
  const Pose3 X_WG = SiteInWorld(built_.world.X_WG, built_.world.slope);
  const StageShapes shapes = scene_.Shapes();
  Stage stage = StageOn(X_WG, X_WG * FromGround(built_.world.X_GD, 0.0), shapes.ground_rgb);
  stage.bodies = {{"robot", truth_.X_WR},
                  {"arm", truth_.X_WA},
                  {"left_door", truth_.X_W_left_door},
                  {"right_door", truth_.X_W_right_door},
                  {"pyramid", truth_.X_WP}};
  // Scenery and shade stay where they are.
  for (std::size_t i = stage.bodies.size(); i < shapes.bodies.size(); ++i) {
    stage.bodies.push_back({shapes.bodies[i].name, Pose3{}});
  }
  stage.lines = {{.name = "cable",
                  .diameter_m = built_.world.pyramid.cable.diameter_m,
                  .rgb = {0.06, 0.06, 0.06},
                  .points_W = truth_.cable_W}};
  return stage;
}

}  // namespace dockyard::raposa
