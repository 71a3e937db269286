#include "sim/axel/axel_plant.h"

#include <cmath>

#include "controller/base/check.h"
#include "render/rolling_shutter.h"
#include "render/video_fields.h"
#include "sim/axel/build_rocks.h"
#include "sim/axel/exposure.h"
#include "sim/plant/built_cameras.h"
#include "sim/run/camera_faults.h"

namespace dockyard::axel {
namespace {

std::vector<MotorTruth> Motors(const Truth& truth) {
  std::vector<MotorTruth> motors(kMotorCount);
  for (std::size_t i = 0; i < motors.size(); ++i) {
    motors[i] = {truth.motor_angle_rad[i], truth.motor_speed_rad_s[i], truth.motor_torque_nm[i],
                 truth.motor_current_a[i], truth.motor_lead_rad[i]};
  }
  return motors;
}

std::vector<MotorModel> MotorModels(const RoverModel& rover) {
  return {rover.motors.begin(), rover.motors.end()};
}

}  // namespace

AxelPlant::AxelPlant(const Scenario& scenario, BuiltRun built,
                     std::shared_ptr<KeptRenderer> renderer)
    : WorldPlant(scenario, std::move(built), std::move(renderer)),
      camera_faults_(scenario.camera_faults),
      sensors_(built_.world.rover.imu, MotorModels(built_.world.rover), kControlPeriod, seed_),
      scene_(built_.world.rover, built_.world.station, built_.world.soil, built_.lighting,
             SiteInWorld(built_.world.X_WG, built_.world.slope), seed_) {
  if (built_.world.rover.tether_sensor) {
    tether_sensing_.emplace(*built_.world.rover.tether_sensor, seed_);
  }
  scene_.AddRocks(built_.world.rocks);
  const Pose3 X_WG = SiteInWorld(built_.world.X_WG, built_.world.slope);
  for (const Eigen::Vector3f& p : RockMesh(built_.world.rocks).vertices) {
    rock_corners_W_.emplace_back(X_WG * p.cast<double>());
  }
  CheckStart(built_, truth_);
}

SensorFrame AxelPlant::Sense() {
  RefreshTruth();
  SensorFrame frame = sensors_.Read(world_.tick(), Motors(truth_), world_.TakeTrueImu());
  if (tether_sensing_) frame.values = tether_sensing_->Read(truth_);
  return frame;
}

std::vector<CameraImage> AxelPlant::TakeImages(const std::vector<int>& cameras,
                                               double exposure_stops) {
  DOCKYARD_CHECK(std::abs(exposure_stops) <= kMostExposure_stops);
  SensorOptions sensor = WithFaults(CameraSensor(built_.world.rover.stereo, seed_, pairs_taken_++),
                                    camera_faults_, seed_);
  sensor.exposure_stops += exposure_stops;
  exposed_truth_ = truth_;
  const double shutter_s = built_.world.rover.stereo.sensor.shutter_s;
  StereoImages pair = Picture(sensor);
  std::vector<CameraImage> images;
  for (const int camera : cameras) {
    DOCKYARD_CHECK(camera == kLeftCamera || camera == kRightCamera);
    GrayImage& image = camera == kLeftCamera ? pair.left : pair.right;
    if (!image.pixels.empty()) images.push_back({camera, std::move(image), {}, shutter_s});
  }
  return images;
}

// The middle of the middle row's exposure is now.
StereoImages AxelPlant::Picture(const SensorOptions& sensor) {
  StereoRenderer& renderer = renderer_->Get();
  const SensorModel& model = built_.world.rover.stereo.sensor;
  const double shutter_s = model.shutter_s, readout_s = model.readout_s;
  const StereoRig& rig = built_.built_rig;
  const double rows_px = BoardMotion_px(truth_, built_, readout_s);
  const bool needs_depth = sensor.focus.distance_m > 0.0 || RowsDiffer(rows_px);
  const auto view = [&](double seconds, bool with_depth) {
    const Truth then = seconds == 0.0 ? truth_ : MovedOn(truth_, seconds);
    return renderer.RenderRadiance(scene_.Make(then, world_.ground()), rig, then.X_WR,
                                   with_depth || needs_depth, built_.ripples);
  };
  const auto motion_in = [&](double seconds) {
    return MotionOverExposure(truth_.X_WR.R, truth_.v_WR_W, truth_.w_WR_W, seconds);
  };
  const double motion_px = BoardMotion_px(truth_, built_, shutter_s);
  const auto light = [&](double middle_s) {
    return OverExposure(motion_px, rig, motion_in(shutter_s), [&](double share, bool depth) {
      return view(middle_s + share * shutter_s, depth);
    });
  };
  const auto rows = [&](double middle_s) {
    return OverReadout(rows_px, rig, motion_in(readout_s), PairInReadout([&](double share) {
                         return light(middle_s + share * readout_s);
                       }));
  };
  return ExposeVideo(rows, BoardMotion_px(truth_, built_, kFieldApart_s), rig, sensor,
                     ExposureBefore(model, exposure_));
}

void AxelPlant::Advance(const Commands& commands) {
  const auto motors = MotorsOf<kMotorCount>(commands);
  for (long i = StepsIn(kControlPeriod); i > 0; --i) world_.Step(motors);
}

Stage AxelPlant::Look() const {
  const Pose3 X_WG = SiteInWorld(built_.world.X_WG, built_.world.slope);
  Stage stage = StageOn(X_WG, truth_.X_WR * Inverse(truth_.X_DR), built_.world.soil.rgb);
  stage.bodies = {{"robot", truth_.X_WR},
                  {"left_wheel", truth_.X_W_left_wheel},
                  {"right_wheel", truth_.X_W_right_wheel},
                  {"arm", truth_.X_WA}};
  for (std::size_t i = 0; i < truth_.further.size(); ++i) {
    stage.bodies.push_back({built_.world.rover.further.links[i].link.name, truth_.further[i].X_WL});
  }
  stage.bodies.push_back({"station", truth_.X_WS});
  if (!built_.world.rocks.rocks.empty()) stage.bodies.push_back({"rocks", X_WG});
  // Scenery and what throws a shadow are posed in the world.
  if (!built_.lighting.scenery.empty()) stage.bodies.push_back({"scenery", Pose3{}});
  if (!built_.lighting.occluders.empty()) stage.bodies.push_back({"shade", Pose3{}});
  stage.lines = {{.name = "tether",
                  .diameter_m = built_.world.rover.tether.diameter_m,
                  .points_W = truth_.tether_W}};
  if (!rock_corners_W_.empty()) {
    stage.solids = {
        {.name = "rocks", .rgb = RockAlbedo(built_.world.soil), .corners_W = &rock_corners_W_}};
  }
  return stage;
}

RobotPose AxelPlant::MeasuredPose(const SightingReport& report) const {
  return RobotPose(built_.nominal.X_DB * Inverse(report.X_RB));
}

}  // namespace dockyard::axel
