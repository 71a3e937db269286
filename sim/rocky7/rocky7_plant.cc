#include "sim/rocky7/rocky7_plant.h"

#include <map>

#include "controller/base/check.h"
#include "render/rolling_shutter.h"
#include "render/video_fields.h"
#include "sim/plant/built_cameras.h"
#include "sim/rocky7/user_click.h"

namespace dockyard::rocky7 {
namespace {

std::vector<MotorModel> MotorModels(const RoverModel& rover) {
  std::vector<MotorModel> motors(rover.plan.wheels.size(), rover.drive);
  for (const WheelPlan& wheel : rover.plan.wheels) {
    if (wheel.steer_limit_rad > 0.0) motors.push_back(rover.steer);
  }
  motors.insert(motors.end(), {rover.arm->roll, rover.arm->pitch, rover.arm->scoop_motor,
                               rover.arm->scoop_motor});
  motors.insert(motors.end(), rover.mast->motors.begin(), rover.mast->motors.end());
  return motors;
}

// The nearest ground in the pictures, by which their blur is judged [m].
constexpr double kNearest_m = 0.3;

// The mast's second link as it will be.
Pose3 MastMovedOn(const Truth& truth, double seconds) {
  return MovedOn(truth.X_WK, truth.v_WK_W, truth.w_WK_W, seconds);
}

Truth MovedOn(const Truth& truth, double seconds) {
  Truth moved = truth;
  moved.X_WR = MovedOn(truth.X_WR, truth.v_WR_W, truth.w_WR_W, seconds);
  const Pose3 moving = moved.X_WR * Inverse(truth.X_WR);
  for (Pose3& X_WL : moved.X_WL) X_WL = moving * X_WL;
  return moved;
}

}  // namespace

Rocky7Plant::Rocky7Plant(const Scenario& scenario, BuiltRun built,
                         std::shared_ptr<KeptRenderer> renderer)
    : WorldPlant(scenario, std::move(built), std::move(renderer)),
      sensors_(built_.world.robot.imu, MotorModels(built_.world.robot.rover), kControlPeriod,
               seed_),
      scene_(built_, world_.rover(), seed_) {
  const UserClick click = ClickOn(scenario, built_, truth_);
  built_.nominal.target_px = click.pixel;
  target_G_ = click.target_G;
}

SensorFrame Rocky7Plant::Sense() {
  RefreshTruth();
  SensorFrame frame = sensors_.Read(world_.tick(), truth_.motors, world_.TakeTrueImu());
  frame.values.assign(truth_.closed.begin(), truth_.closed.end());
  return frame;
}

Rocky7Plant::PairView Rocky7Plant::PairOf(int camera) const {
  const RobotModel& robot = built_.world.robot;
  if (camera == kMastLeft || camera == kMastRight) {
    return {robot.mast_pair, built_.mast_pair, built_.mast_ripples,
            kMastLeft,       truth_.w_WK_W,    truth_.v_WK_W};
  }
  const bool back = camera == kBackLeft || camera == kBackRight;
  return {back ? robot.back : robot.front,
          back ? built_.back : built_.front,
          back ? built_.back_ripples : built_.front_ripples,
          back ? kBackLeft : kFrontLeft,
          truth_.w_WR_W,
          truth_.v_WR_W};
}

std::vector<CameraImage> Rocky7Plant::TakeImages(const std::vector<int>& cameras,
                                                 double exposure_stops) {
  DOCKYARD_CHECK(std::abs(exposure_stops) <= kMostExposure_stops);
  std::vector<CameraImage> images;
  std::map<int, StereoImages> pairs;  // by left camera: a pair is exposed together
  for (const int camera : cameras) {
    DOCKYARD_CHECK(camera >= 0 && camera < kCameraCount);
    const PairView pair = PairOf(camera);
    if (pairs.count(pair.left) == 0) pairs[pair.left] = TakePair(pair, exposure_stops);
    StereoImages& both = pairs[pair.left];
    images.push_back(
        {camera, camera == pair.left ? both.left : both.right, {}, pair.model.sensor.shutter_s});
  }
  return images;
}

StereoImages Rocky7Plant::TakePair(const PairView& pair, double exposure_stops) {
  SensorOptions sensor = CameraSensor(pair.model, seed_, pairs_taken_++);
  sensor.exposure_stops += exposure_stops;
  StereoRenderer& renderer = renderer_->Get();
  const double shutter_s = pair.model.sensor.shutter_s, readout_s = pair.model.sensor.readout_s;
  const auto motion_px = [&](double over_s) {
    return MotionInExposure_px(pair.built.left, pair.turning_rad_s.norm(), pair.speed_m_s.norm(),
                               kNearest_m, over_s);
  };
  const bool needs_depth = sensor.focus.distance_m > 0.0 || RowsDiffer(motion_px(readout_s));
  const auto view = [&](double seconds, bool with_depth) {
    const Truth then = seconds == 0.0 ? truth_ : MovedOn(truth_, seconds);
    const Pose3 X_WC = pair.left == kMastLeft ? MastMovedOn(truth_, seconds) : then.X_WR;
    return renderer.RenderRadiance(scene_.Make(then, world_.ground()), pair.built, X_WC,
                                   with_depth || needs_depth, pair.ripples);
  };
  const Pose3 X_WB = pair.left == kMastLeft ? MastMovedOn(truth_, 0.0) : truth_.X_WR;
  const auto motion_in = [&](double seconds) {
    return MotionOverExposure(X_WB.R, pair.speed_m_s, pair.turning_rad_s, seconds);
  };
  const auto light = [&](double middle_s) {
    return OverExposure(
        motion_px(shutter_s), pair.built, motion_in(shutter_s),
        [&](double share, bool depth) { return view(middle_s + share * shutter_s, depth); });
  };
  const auto rows = [&](double middle_s) {
    return OverReadout(
        motion_px(readout_s), pair.built, motion_in(readout_s),
        PairInReadout([&](double share) { return light(middle_s + share * readout_s); }));
  };
  return ExposeVideo(rows, motion_px(kFieldApart_s), pair.built, sensor,
                     ExposureBefore(pair.model.sensor, exposures_[pair.left]));
}

void Rocky7Plant::Advance(const Commands& commands) {
  for (long i = StepsIn(kControlPeriod); i > 0; --i) world_.Step(commands.motors);
}

Stage Rocky7Plant::Look() const {
  const StageShapes shapes = scene_.Shapes();
  Stage stage = StageOn(world_.X_WG(), world_.X_WG(), shapes.ground_rgb);
  std::size_t loose = 0;
  for (std::size_t i = 0; i < shapes.bodies.size(); ++i) {
    // Beyond the rover's links there are stones, in G, and surroundings, in the world.
    const std::string& name = shapes.bodies[i].name;
    Pose3 fixed = name == "shade" || name == "scenery" ? Pose3{} : world_.X_WG();
    if (name == "target" && built_.world.loose_target) fixed = world_.X_WG() * truth_.X_GT;
    if (name == LooseStoneName(loose)) fixed = world_.X_WG() * truth_.X_GS.at(loose++);
    stage.bodies.push_back({name, i < truth_.X_WL.size() ? truth_.X_WL[i] : fixed});
  }
  return stage;
}

RobotPose Rocky7Plant::MeasuredPose(const SightingReport& report) const {
  const double heading = truth_.X_GR.heading;
  const Eigen::Vector2d p_D =
      -(Eigen::Rotation2Dd(heading) * Eigen::Vector2d(report.X_RB.p.head<2>()));
  return {p_D.x(), p_D.y(), heading};
}

}  // namespace dockyard::rocky7
