#include "toy_underwater/diver_system.h"

#include <algorithm>
#include <cmath>

#include "sim/base/hash.h"
#include "sim/base/random.h"
#include "sim/plant/scenery.h"
#include "sim/scenario/keys.h"
#include "toy_underwater/diver_body.h"
#include "toy_underwater/swim_in.h"

namespace dockyard::diver {
namespace {

constexpr double kStep_s = 1e-3;
constexpr double kFromEnd_m = 0.05;  // the nose of a caged body

struct DiverKeys {
  double current_m_s = 0.0, current_rad = 0.0;  // towards this side, from D's x
};
void VisitDiver(Keys& keys, DiverKeys& values) {
  keys.Number({"current_m_s", "m/s", "speed of the water"}, values.current_m_s, NonNegative(0.5));
  keys.Degrees({"current_deg", "deg", "its direction, from the cage's axis"}, values.current_rad,
               Between(-180.0, 180.0));
}
DiverKeys ReadDiver(const Scenario& scenario) {
  DiverKeys values;
  ReadKeys(scenario.of_system, "diver", [&](Keys& keys) { VisitDiver(keys, values); });
  return values;
}

Pose3 PoseAtStart(const Start& start) {
  const double range_m = start.Value("range_m"), bearing_rad = start.Value("bearing_deg");
  return {RotZ(WrapPi(start.Value("heading_deg") + kPi)),
          {range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad), start.Value("up_m")}};
}

Start DiverStart() {
  return Start({{"range_m", "m", Between(2.0, 30.0), "from the cage's mouth"},
                {"bearing_deg", "deg", Between(-60.0, 60.0), "about the mouth, from its axis"},
                {"up_m", "m", Between(-10.0, 10.0), "above the cage's axis"},
                {"heading_deg", "deg", Between(-180.0, 180.0), "against the cage's axis"}},
               [](const Start& start) { return RobotPose(PoseAtStart(start)); });
}

class Water final : public Plant {
 public:
  explicit Water(const Scenario& scenario) {
    const DiverKeys keys = ReadDiver(scenario);
    current_D_ = RotZ(keys.current_rad) * Eigen::Vector3d(keys.current_m_s, 0.0, 0.0);
    state_.X_DR = PoseAtStart(scenario.start);
    state_.v_R = -(state_.X_DR.R.transpose() * current_D_);  // let go at rest
    RandomStream random(StreamKey(scenario.seed, "ballast"));
    body_.buoyancy_n += random.Uniform(-1.0, 1.0);  // assumed, up to 0.5-2 N
  }

  Tick tick() const override { return tick_; }
  SensorFrame Sense() override {
    const Pose3& X_DR = state_.X_DR;
    const RollPitchYaw angles = ToRollPitchYaw(X_DR.R);
    const Eigen::Vector3d v_R = GroundSpeed(), p_RD = Inverse(X_DR).p;
    SensorFrame frame;
    frame.tick = tick_;
    frame.imu.roll_rad = angles.roll;
    frame.imu.pitch_rad = angles.pitch;
    frame.imu.yaw_rad = angles.yaw;
    frame.imu.rate_R = state_.w_R;  // it has no accelerometer
    for (const double turned_rad : turned_rad_) {
      frame.motors.push_back({std::llround(turned_rad / kRadPerCount), 0.0});
    }
    frame.values = {kCageDepth_m - X_DR.p.z(),
                    v_R.x(),
                    v_R.y(),
                    v_R.z(),
                    p_RD.norm(),
                    std::atan2(p_RD.y(), p_RD.x()),
                    std::atan2(p_RD.z(), p_RD.head<2>().norm())};
    return frame;
  }
  std::vector<CameraImage> TakeImages(const std::vector<int>&, double) override { return {}; }
  void Advance(const Commands& commands) override {
    std::array<double, kThrusters> speeds{};
    for (std::size_t i = 0; i < speeds.size(); ++i) {
      const MotorCommand& motor = commands.motors[i];
      if (motor.mode != MotorMode::kVelocity) continue;
      speeds[i] = std::clamp(motor.target, -kMostSpeed_rad_s, kMostSpeed_rad_s);
      turned_rad_[i] += speeds[i] * kTickSeconds * static_cast<double>(kPeriod);
    }
    const Wrench thrust = OfThrusters(speeds);
    for (Tick i = 0; i < kPeriod; ++i) {
      const Wrench wall = OfCage(cage_, state_, current_D_);
      Step(body_, {thrust.force_n + wall.force_n, thrust.moment_nm + wall.moment_nm}, current_D_,
           kStep_s, state_);
    }
    tick_ += kPeriod;
  }
  RobotPose X_DR() const override { return RobotPose(state_.X_DR); }
  void AppendChannels(std::vector<double>& values) const override {
    values.insert(values.end(), {nose_depth_m(), off_axis_m(), GroundSpeed().norm()});
  }
  Stage Look() const override {
    Stage stage;
    stage.bodies = {{"robot", state_.X_DR}, {"cage", Pose3{}}};
    return stage;
  }
  RobotPose MeasuredPose(const SightingReport& report) const override {
    return RobotPose(Inverse(report.X_RB));
  }
  std::uint64_t StateHash(std::uint64_t seed) const override {
    for (const double value : state_.X_DR.R.reshaped()) seed = HashDouble(seed, value);
    for (const Eigen::Vector3d& each : {state_.X_DR.p, state_.v_R, state_.w_R}) {
      for (const double value : each) seed = HashDouble(seed, value);
    }
    return seed;
  }

  const Cage& cage() const { return cage_; }
  double nose_depth_m() const { return -(state_.X_DR * cage_.p_RN).x(); }
  double off_axis_m() const { return (state_.X_DR * cage_.p_RN).tail<2>().norm(); }

 private:
  Eigen::Vector3d GroundSpeed() const {
    return state_.v_R + state_.X_DR.R.transpose() * current_D_;
  }

  BodyModel body_;
  Cage cage_;
  BodyState state_;
  Eigen::Vector3d current_D_{0, 0, 0};
  std::array<double, kThrusters> turned_rad_{};
  Tick tick_ = 0;
};

/// A box of the vehicle's size, and a rod along each side of the cage.
StageShapes ShapesOf(const Cage& cage) {
  const auto box = [](const Eigen::Vector3d& size_m) {
    return std::make_shared<const RenderMesh>(SolidMesh(SceneryItem::Kind::kBox, size_m));
  };
  StageShapes shapes;
  shapes.bodies = {{.name = "robot", .robot = true, .parts = {}}, {.name = "cage", .parts = {}}};
  shapes.bodies[0].parts = {{box({0.46, 0.34, 0.25}), Pose3::Translation(0.0, 0.0, -0.125)}};
  for (const Eigen::Vector2d& side : {Eigen::Vector2d{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const Eigen::Vector2d yz = cage.tube_radius_m * side;
    shapes.bodies[1].parts.push_back({box({cage.length_m, 0.02, 0.02}),
                                      Pose3::Translation(-0.5 * cage.length_m, yz.x(), yz.y())});
  }
  return shapes;
}

std::vector<JudgedLimit> Limits(double depth_m, double wanted_m) {
  return {{"nose_depth_m", "m", "of the nose behind the cage's mouth", LimitSense::kAtLeast,
           depth_m, wanted_m}};
}

class InTheCage final : public Judge {
 public:
  explicit InTheCage(const Water& water) : water_(water) {}
  void Observe() override {}
  void ObserveSighting(const SightingReport&) override {}
  bool fatal() const override { return false; }
  Conclusion Conclude(const Commands& last, const Belief&, const TrialWatch&) override {
    const double depth_m = water_.nose_depth_m(), wanted_m = water_.cage().length_m - kFromEnd_m;
    const bool claimed = last.verdict == Verdict::kDone;
    const char* outcome = !claimed ? "timeout" : depth_m >= wanted_m ? "caged" : "outside";
    return {outcome,
            "its nose is " + NumberText(depth_m) + " m in the cage",
            {depth_m, water_.off_axis_m()},
            Limits(depth_m, wanted_m)};
  }

 private:
  const Water& water_;
};

// The noises are assumed: a pressure sensor's 2-10 mm, a Doppler log's 5-20 mm/s, an acoustic
// positioning unit's 20-100 mm and 0.3-1 deg.
std::vector<NamedSensor> Sensors() {
  return {{"depth_m", "m", "below the surface, by pressure", 40, 0, 0.005},
          {"forward_m_s", "m/s", "over the ground, by the Doppler log", 100, 80, 0.01},
          {"left_m_s", "m/s", "over the ground, by the Doppler log", 100, 80, 0.01},
          {"up_m_s", "m/s", "over the ground, by the Doppler log", 100, 80, 0.01},
          {"range_m", "m", "to the cage's mouth, acoustic", 500, 240, 0.05},
          {"bearing_rad", "rad", "of the mouth, left positive, acoustic", 500, 240, 0.01},
          {"elevation_rad", "rad", "of the mouth, up positive, acoustic", 500, 240, 0.01}};
}

ReadyRun MakeReady(const Scenario& scenario) {
  auto water = std::make_unique<Water>(scenario);
  ReadyRun ready;
  ready.judge = std::make_unique<InTheCage>(*water);
  ready.nominal = {{"length_m", water->cage().length_m}, {"nose_m", water->cage().p_RN.x()}};
  ready.plant = std::move(water);
  ready.control_period = kPeriod;
  ready.motor_count = kThrusters;
  ready.sensors = Sensors();
  return ready;
}

}  // namespace

System DiverSystem() {
  System system;
  system.name = "diver";
  system.controllers = {{"swim_in", MakeSwimIn}};
  system.columns.outcomes = {{"caged", true, "its nose within 5 cm of the cage's end"},
                             {"outside", false, "claimed to be there, farther off"},
                             {"timeout", false, "never claimed to be there"}};
  system.columns.channels = {{"nose_depth_m", "m", "of the nose behind the cage's mouth"},
                             {"off_axis_m", "m", "of the nose off the cage's axis"},
                             {"speed_m_s", "m/s", "over the ground"}};
  system.columns.beliefs = {{"believed_up_m", "m", "above the cage's axis"}};
  system.columns.measures =
      WithMargins({{"nose_depth_m", "m", "of the nose behind the cage's mouth", true},
                   {"off_axis_m", "m", "of the nose off the cage's axis", true}},
                  Limits(0.0, 0.0));
  system.scenario.start = DiverStart();
  system.keys = [](Keys& keys) {
    DiverKeys values;
    VisitDiver(keys, values);
  };
  system.check = [](const Scenario& scenario) {
    return "a diver in a current of " + NumberText(ReadDiver(scenario).current_m_s) + " m/s";
  };
  system.make_ready = MakeReady;
  system.shapes = [](const Scenario&) { return ShapesOf(Cage{}); };
  return system;
}

}  // namespace dockyard::diver
