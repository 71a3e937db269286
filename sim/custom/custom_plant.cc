#include "sim/custom/custom_plant.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/check.h"
#include "controller/base/number_text.h"
#include "models/read/config_error.h"

namespace dockyard::custom {
namespace {

// Contacts yield by this much where things rest on each other. Assumed, 1-5 mm.
constexpr double kOverlap_m = 2e-3;
// By which a dock may settle: onto a carpet, or from a drawing that leaves a gap below it. Assumed,
// 5-20 mm, 1-3 deg.
constexpr double kSettled_m = 0.01, kSettled_rad = Radians(2.0);
// A camera comes no nearer to a board [m].
constexpr double kNearest_m = 0.1;

std::vector<MotorModel> MotorModels(const RobotModel& robot) {
  std::vector<MotorModel> motors;
  for (const MotorFit& motor : robot.motors) motors.push_back(motor.model);
  return motors;
}

}  // namespace

CustomPlant::CustomPlant(const Scenario& scenario, BuiltRun built,
                         std::shared_ptr<KeptRenderer> renderer)
    : WorldPlant(scenario, std::move(built), std::move(renderer)),
      sensors_(built_.world.robot.imu.value_or(ImuModel{}), MotorModels(built_.world.robot),
               kControlPeriod, seed_),
      scene_(built_, seed_) {
  for (std::size_t i = 0; i < built_.world.robot.cameras.size(); ++i) {
    cameras_.emplace_back(built_.world.robot.cameras[i].model, seed_, static_cast<int>(i));
  }
  if (world_.start_overlap_m() > kOverlap_m) {
    throw ConfigError(scenario.start_place +
                      ": expected a start at which robot and dock are apart, found them " +
                      Fixed(1e3 * world_.start_overlap_m(), 1) + " mm in each other");
  }
  if (world_.dock_settled_m() <= kSettled_m && world_.dock_settled_rad() <= kSettled_rad) return;
  throw ConfigError(built_.world.dock.name +
                    ": expected a dock that is at rest on the floor, its lowest points at z = 0 of "
                    "its root link and its weight between them; it moved by " +
                    Fixed(1e3 * world_.dock_settled_m(), 1) + " mm and turned by " +
                    Fixed(Degrees(world_.dock_settled_rad()), 1) + " deg within a second");
}

// Without an inertial unit its sample stays zero.
SensorFrame CustomPlant::Sense() {
  RefreshTruth();
  SensorFrame frame = sensors_.Read(world_.tick(), truth_.motors, world_.TakeTrueImu());
  for (const bool closed : truth_.switches) frame.values.push_back(closed ? 1.0 : 0.0);
  for (std::size_t i = 0; i < truth_.ranges_m.size(); ++i) {
    const double step_m = built_.world.robot.ranges[i].step_m;
    const double range_m = truth_.ranges_m[i];
    frame.values.push_back(step_m > 0.0 ? step_m * std::round(range_m / step_m) : range_m);
  }
  for (const ContactTruth& contact : truth_.contacts) {
    frame.values.push_back(contact.voltage_v);
    frame.values.push_back(contact.current_a);
  }
  return frame;
}

std::vector<CameraImage> CustomPlant::TakeImages(const std::vector<int>& cameras,
                                                 double exposure_stops) {
  DOCKYARD_CHECK(std::abs(exposure_stops) <= kMostExposure_stops);
  std::vector<CameraImage> images;
  for (const int number : cameras) {
    SimulatedCamera& camera = cameras_.at(static_cast<std::size_t>(number));
    const int link = built_.world.robot.cameras[static_cast<std::size_t>(number)].link;
    const LinkMotion carrier = world_.MotionInWorld(link);
    const CameraMotion motion =
        CameraOnLink(camera.X_LC(), carrier.X_GL, carrier.v_GL_G, carrier.w_GL_G);
    // The robot's own parts move with the camera; what they hide or shade near it does not matter.
    const auto scene = [&](double) { return scene_.Make(truth_, world_.ground(), link); };
    images.push_back(camera.Take(
        renderer_->Get(), scene, scene_.colours(), motion, world_.tick(),
        {.nearest_m = NearestBoard_m(motion.X_WC.p), .exposure_stops = exposure_stops}));
  }
  return images;
}

// By this the blur of a moving camera is divided: the floor before it may smear more coarsely.
double CustomPlant::NearestBoard_m(const Eigen::Vector3d& p_W) const {
  double nearest_m = truth_.X_DR.p.head<2>().norm();
  for (const BoardFit& board : built_.world.dock.boards) {
    const Pose3& X_WL = truth_.X_WK[static_cast<std::size_t>(board.link)];
    nearest_m = std::min(nearest_m, (X_WL * board.X_LB.p - p_W).norm());
  }
  return std::max(nearest_m, kNearest_m);
}

void CustomPlant::Push(const Eigen::Vector3d& force_D, double frequency_hz) {
  push_D_ = force_D;
  push_hz_ = frequency_hz;
  pushed_s_ = 0.0;
}

void CustomPlant::Advance(const Commands& commands) {
  for (long i = StepsIn(kControlPeriod); i > 0; --i) {
    const double swing = push_hz_ > 0.0 ? std::sin(2.0 * kPi * push_hz_ * pushed_s_) : 1.0;
    pushed_s_ += step_s_;
    world_.Step(commands.motors, swing * push_D_);
  }
}

const ContactTruth* CustomPlant::Contact(const std::string& name) const {
  const std::vector<std::string>& names = built_.world.contacts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return &truth_.contacts[i];
  }
  return nullptr;
}

Stage CustomPlant::Look() const {
  const StageShapes shapes = scene_.Shapes();
  Stage stage = StageOn(world_.X_WG(), world_.X_WG(), shapes.ground_rgb);
  const std::size_t robot = truth_.X_WL.size(), dock = truth_.X_WK.size();
  for (std::size_t i = 0; i < shapes.bodies.size(); ++i) {
    const Pose3 at = i < robot          ? truth_.X_WL[i]
                     : i < robot + dock ? truth_.X_WK[i - robot]
                                        : Pose3{};  // surroundings stay where they are
    stage.bodies.push_back({shapes.bodies[i].name, at});
  }
  return stage;
}

// Ruts are in soil alone.
std::uint64_t CustomPlant::FinalHash(std::uint64_t seed) const {
  return built_.world.soils.empty() ? StateHash(seed) : WorldPlant::FinalHash(seed);
}

}  // namespace dockyard::custom
