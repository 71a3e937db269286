#include "sim/axel/axel_plant.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "render/shutter.h"
#include "sim/axel/axel_columns.h"
#include "sim/axel/build_rocks.h"
#include "sim/axel/exposure.h"
#include "sim/base/hash.h"
#include "sim/plant/built_cameras.h"
#include "sim/run/camera_faults.h"

namespace dockyard::axel {
namespace {

std::vector<MotorTruth> Motors(const Truth& truth) {
  std::vector<MotorTruth> motors(kMotorCount);
  for (std::size_t i = 0; i < motors.size(); ++i) {
    motors[i] = {truth.motor_angle_rad[i], truth.motor_speed_rad_s[i], truth.motor_torque_nm[i],
                 truth.motor_current_a[i]};
  }
  return motors;
}

std::vector<MotorModel> MotorModels(const RoverModel& rover) {
  return {rover.motors.begin(), rover.motors.end()};
}

}  // namespace

AxelPlant::AxelPlant(const Scenario& scenario, BuiltRun built,
                     std::shared_ptr<KeptRenderer> renderer)
    : seed_(scenario.seed),
      step_s_(scenario.physics_step_s),
      camera_faults_(scenario.camera_faults),
      built_(std::move(built)),
      world_(built_.world),
      sensors_(built_.world.rover.imu, MotorModels(built_.world.rover), kControlPeriod, seed_),
      scene_(built_.world.rover, built_.world.station, built_.world.soil, built_.lighting,
             SiteInWorld(built_.world.X_WG, built_.world.slope), seed_),
      renderer_(std::move(renderer)),
      truth_(world_.truth()) {
  scene_.AddRocks(built_.world.rocks);
  const Pose3 X_WG = SiteInWorld(built_.world.X_WG, built_.world.slope);
  for (const Eigen::Vector3f& p : RockMesh(built_.world.rocks).vertices) {
    rock_corners_W_.emplace_back(X_WG * p.cast<double>());
  }
  CheckStart(built_, truth_);
}

SensorFrame AxelPlant::Sense() {
  RefreshTruth();
  return sensors_.Read(world_.tick(), Motors(truth_), world_.TakeTrueImu());
}

std::vector<CameraImage> AxelPlant::TakeImages(const std::vector<int>& cameras,
                                               double exposure_stops) {
  DOCKYARD_CHECK(std::abs(exposure_stops) <= kMostExposureStops);
  SensorOptions sensor = WithFaults(CameraSensor(built_.world.rover.stereo, seed_, pairs_taken_++),
                                    camera_faults_, seed_);
  sensor.exposure_stops += exposure_stops;
  exposed_truth_ = truth_;
  const double shutter_s = built_.world.rover.stereo.shutter_s;
  StereoImages pair = Picture(sensor);
  std::vector<CameraImage> images;
  for (const int camera : cameras) {
    DOCKYARD_CHECK(camera == kLeftCamera || camera == kRightCamera);
    GrayImage& image = camera == kLeftCamera ? pair.left : pair.right;
    if (!image.pixels.empty()) images.push_back({camera, std::move(image), {}, shutter_s});
  }
  return images;
}

// The middle of the exposure is now.
StereoImages AxelPlant::Picture(const SensorOptions& sensor) {
  StereoRenderer& renderer = renderer_->Get();
  const double shutter_s = built_.world.rover.stereo.shutter_s;
  const StereoRig& rig = built_.built_rig;
  const auto view = [&](double share, bool with_depth) {
    const Truth then = share == 0.0 ? truth_ : MovedOn(truth_, share * shutter_s);
    return renderer.RenderRadiance(scene_.Make(then, world_.ground()), rig, then.X_WR,
                                   with_depth || sensor.focus.distance_m > 0.0);
  };
  const ExposureMotion motion =
      MotionOverExposure(truth_.X_WR.R, truth_.v_WR_W, truth_.w_WR_W, shutter_s);
  return ExposeStereo(OverExposure(BoardMotion_px(truth_, built_), rig, motion, view), rig, sensor);
}

void AxelPlant::Advance(const Commands& commands) {
  DOCKYARD_CHECK(commands.motors.size() == kMotorCount);
  std::array<MotorCommand, kMotorCount> motors;
  std::copy(commands.motors.begin(), commands.motors.end(), motors.begin());
  const int steps = static_cast<int>(std::llround(kControlPeriod * kTickSeconds / step_s_));
  for (int i = 0; i < steps; ++i) world_.Step(motors);
}

void AxelPlant::AppendChannels(std::vector<double>& values) const {
  VisitChannels(truth_, [&](const char*, const char*, const char*, double value) {
    values.push_back(value);
  });
}

Stage AxelPlant::Look() const {
  const HeightGrid& ground = world_.ground();
  Stage stage;
  stage.bodies = {{"robot", truth_.X_WR},
                  {"left_wheel", truth_.X_W_left_wheel},
                  {"right_wheel", truth_.X_W_right_wheel},
                  {"arm", truth_.X_WA},
                  {"station", truth_.X_WS}};
  const Pose3 X_WG = SiteInWorld(built_.world.X_WG, built_.world.slope);
  if (!built_.world.rocks.rocks.empty()) stage.bodies.push_back({"rocks", X_WG});
  // What throws a shadow stands where the scene's objects say.
  if (!built_.lighting.occluders.empty()) stage.bodies.push_back({"shade", Pose3{}});
  stage.lines = {{.name = "tether",
                  .diameter_m = built_.world.rover.tether.diameter_m,
                  .points_W = truth_.tether_W}};
  if (!rock_corners_W_.empty()) {
    stage.solids = {
        {.name = "rocks", .rgb = RockAlbedo(built_.world.soil), .corners_W = &rock_corners_W_}};
  }
  stage.ground = {.X_WG = X_WG,
                  .x0_m = ground.x0_m,
                  .y0_m = ground.y0_m,
                  .cell_m = ground.cell_m,
                  .nx = ground.nx,
                  .ny = ground.ny,
                  .heights_m = ground.heights_m.data(),
                  .revision = ground.revision,
                  .rgb = built_.world.soil.rgb};
  stage.X_WD = truth_.X_WR * Inverse(truth_.X_DR);
  return stage;
}

RobotPose AxelPlant::MeasuredPose(const SightingReport& report) const {
  return RobotPose(built_.nominal.X_DB * Inverse(report.X_RB));
}

// The ruts sum up all that the wheels did: once, at the end, is enough.
std::uint64_t AxelPlant::FinalHash(std::uint64_t seed) const {
  for (const double height : world_.ground().heights_m) seed = HashDouble(seed, height);
  return world_.StateHash(seed);
}

}  // namespace dockyard::axel
