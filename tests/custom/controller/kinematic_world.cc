#include "custom/controller/kinematic_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "controller/custom/graceful.h"
#include "controller/motion/arcs.h"
#include "custom/controller/test_robot.h"
#include "sim/base/random.h"

namespace dockyard::custom {
namespace {

constexpr Tick kPeriod = 20;
constexpr double kPeriod_s = 0.02;

/// The truth, and what the sensors make of it.
class World {
 public:
  World(const Nominal& nominal, const KinematicWorld& world)
      : nominal_(nominal),
        world_(world),
        X_DR_(world.X_DR_start),
        yaw_noise_(StreamKey(world.seed, "yaw")),
        sightings_(StreamKey(world.seed, "sightings")),
        angles_(nominal.motors.size(), 0.0),
        speeds_(nominal.motors.size(), 0.0) {}

  SensorFrame Sense() {
    SensorFrame frame;
    frame.tick = now_;
    if (nominal_.has_imu) frame.imu.yaw_rad = WrapPi(yaw_rad_);
    for (const double angle : angles_) {
      const double counts = angle / nominal_.motors[0].motor.rad_per_count;
      frame.motors.push_back({.encoder_counts = std::llround(counts)});
    }
    if (!nominal_.contact.empty()) frame.values = {closed_ ? nominal_.contact_voltage_v : 0.0};
    for (const auto& [due, exposed] : images_) {
      if (due <= now_) frame.images.push_back({0, GrayImage{}, exposed, 0.0});
    }
    std::erase_if(images_, [&](const auto& image) { return image.first <= now_; });
    truth_[now_] = X_DR_;
    return frame;
  }

  void Advance(const Commands& commands) {
    if (!commands.take_images.empty() && world_.camera_answers)
      images_.push_back(
          {now_ + std::max<Tick>(kPeriod, std::llround(1000.0 * world_.latency_s)), now_});
    double sides[2] = {0.0, 0.0}, count[2] = {0.0, 0.0}, y_m[2] = {0.0, 0.0};
    const std::vector<double> before = angles_;
    for (const RobotWheel& wheel : nominal_.wheels) {
      if (wheel.drive < 0) continue;
      const auto i = static_cast<std::size_t>(wheel.drive);
      const std::size_t side = wheel.p_RK.y() > 0.0 ? 0 : 1;
      const MotorCommand& command = commands.motors[i];
      const double target = command.mode == MotorMode::kVelocity ? command.target : 0.0;
      const double step = 40.0 * kPeriod_s;
      speeds_[i] += std::clamp(target - speeds_[i], -step, step);
      angles_[i] += kPeriod_s * speeds_[i];
      sides[side] += speeds_[i] * nominal_.motors[i].travel_per_rad * wheel.radius_m *
                     (wheel.axle_R.y() > 0.0 ? 1.0 : -1.0);
      count[side] += 1.0;
      y_m[side] = wheel.p_RK.y();
    }
    const double left = world_.left_scale * sides[0] / count[0];
    const double right = world_.right_scale * sides[1] / count[1];
    twist_ = {0.5 * (left + right), world_.turn_share * (right - left) / (y_m[0] - y_m[1])};
    if (Move() && world_.stalls) angles_ = before;
    now_ += kPeriod;
    yaw_rad_ += kPeriod_s * twist_.turn_rad_s +
                world_.yaw_rad_per_sqrt_s * std::sqrt(kPeriod_s) * yaw_noise_.Normal();
  }

  std::vector<BoardSighting> Perceive(const CameraImage& image) {
    BoardSighting sighting{.exposed = image.exposed};
    const Pose3 X_DR = FromGround(truth_.at(image.exposed), nominal_.height_m);
    const Pose3 X_CB = Inverse(X_DR * nominal_.cameras[0].X_RC) *
                       Pose3::Translation(0.0, world_.board_aside_m, 0.0) * nominal_.boards[0].X_DB;
    const double r = X_CB.p.norm();
    const auto pixel = nominal_.cameras[0].camera.Project(X_CB.p);
    const double half_px =
        0.5 * nominal_.boards[0].board.width_m / r * nominal_.cameras[0].camera.focal_px().x();
    const double time_s = kTickSeconds * static_cast<double>(now_);
    const bool shows = pixel && nominal_.cameras[0].camera.Sees(*pixel, half_px) &&
                       r < world_.farthest_m && X_CB.R.col(2).dot(X_CB.p) > 0.35 * r &&
                       sightings_.Uniform() >= world_.dropout &&
                       (!world_.marks_show || world_.marks_show(time_s, r));
    if (!shows) {
      sighting.failure = "no marks";
      return {sighting};
    }
    const double along = world_.range_m(r), aside = world_.aside_m(r), turn = world_.turn_rad(r);
    Eigen::Matrix<double, 6, 1> sigma;
    sigma << aside, aside, along, turn, turn, 0.3 * turn;
    Eigen::Matrix<double, 6, 1> error;
    for (int i = 0; i < 6; ++i) error(i) = sigma(i) * sightings_.Normal();
    PoseBranch branch;
    branch.X_CB = {TurnAbout(error.tail<3>()) * X_CB.R, X_CB.p + error.head<3>()};
    branch.covariance.diagonal() = sigma.cwiseAbs2();
    branch.rms_px = 0.2;
    branch.misfit = 2.0 * sightings_.Uniform();
    sighting.branches = {branch};
    if (world_.mirrored) {
      branch.X_CB = Mirrored(branch.X_CB);
      branch.misfit = 2.0 * sightings_.Uniform();
      sighting.branches.push_back(branch);
      if (branch.misfit < sighting.branches[0].misfit)
        std::swap(sighting.branches[0], sighting.branches[1]);
    }
    return {sighting};
  }

  /// The robot's R in the docked R.
  Pose2 Off() const { return Inverse(ToGround(nominal_.X_DR_docked())) * X_DR_; }
  bool closed() const { return closed_; }
  const Twist& twist() const { return twist_; }
  Tick now() const { return now_; }

 private:
  /// Whether the dock stops it.
  bool Move() {
    double axle_x_m = 0.0, driven = 0.0;
    for (const RobotWheel& wheel : nominal_.wheels) {
      if (wheel.drive < 0) continue;
      axle_x_m += wheel.p_RK.x();
      driven += 1.0;
    }
    const Pose2 X_RA{axle_x_m / driven, 0.0, 0.0};
    const Arc step{kPeriod_s * twist_.speed_m_s, kPeriod_s * twist_.turn_rad_s};
    X_DR_ = dockyard::Advance(X_DR_ * X_RA, step) * Inverse(X_RA);
    const double docked_x = ToGround(nominal_.X_DR_docked()).x;
    const bool touches = X_DR_.x < docked_x - world_.stop_m;
    if (touches) {
      X_DR_.x = docked_x - world_.stop_m;
      turned_touching_ += std::abs(step.turn_rad);
    }
    closed_ = std::hypot(Off().x, Off().y) < world_.contact_m &&
              (world_.wiggle_rad == 0.0 || turned_touching_ > world_.wiggle_rad);
    return touches;
  }

  Nominal nominal_;
  KinematicWorld world_;
  Pose2 X_DR_;
  RandomStream yaw_noise_, sightings_;
  Tick now_ = 0;
  double yaw_rad_ = 0.0, turned_touching_ = 0.0;
  std::vector<double> angles_, speeds_;
  Twist twist_;
  bool closed_ = false;
  std::map<Tick, Pose2> truth_;
  std::vector<std::pair<Tick, Tick>> images_;  // due, exposed
};

}  // namespace

KinematicRun RunKinematic(const Nominal& nominal, const KinematicWorld& world, double limit_s) {
  World truth(nominal, world);
  auto made = MakeGracefulController(
      nominal,
      [&](const CameraImage& image, const Eigen::Vector3d&) { return truth.Perceive(image); });
  KinematicRun run;
  if (!made) {
    ADD_FAILURE() << made.error().reason;
    return run;
  }
  Controller& controller = **made;
  while (run.verdict == Verdict{} && run.time_s < limit_s) {
    const Commands commands = controller.Step(truth.Sense());
    truth.Advance(commands);
    run.verdict = commands.verdict;
    run.time_s = kTickSeconds * static_cast<double>(truth.now());
    run.twists.push_back(truth.twist());
    const Belief& belief = controller.belief();
    if (run.phases.empty() || run.phases.back() != belief.phase) run.phases.push_back(belief.phase);
    if (ValueOf(belief, "tag_branches_open", 0.0) > 0.5) run.branch_open_s += kPeriod_s;
  }
  const Pose2 off = truth.Off();
  run.along_m = off.x;
  run.aside_m = off.y;
  run.off_rad = off.heading;
  run.closed = truth.closed();
  run.belief = controller.belief();
  return run;
}

}  // namespace dockyard::custom
