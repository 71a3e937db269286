#include "controller/rocky7/placement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rocky7/controller/nominal_rover.h"

namespace dockyard::rocky7 {
namespace {

using testing::ElementsAre;

constexpr double kSpring_n_m = 500.0, kSwitch_n = 1.0;

// Drives that turn as fast as they may towards their targets, with ramps, and a plane with three
// switches on springs before it.
struct IdealMast {
  Nominal nominal = NominalRover();
  FaceAt face;  // as it is
  double roll_off_rad = 0.0;
  MastAngles angles = nominal.mast.watch_rad;
  std::array<double, 3> speed{};
  Tick tick = 0;
  double most_n = 0.0, deepest_m = 0.0;
  double lowest_m = 1.0;  // of the face's middle before the surface
  std::vector<std::uint8_t> contacts = {0, 0, 0};
  double current_a = 0.2;
  Phase phase = Phase::kUnfold;

  void Turn(const std::vector<MotorCommand>& commands) {
    constexpr double dt = 1e-3;
    for (int ms = 0; ms < kControlPeriod; ++ms) {
      for (std::size_t i = 0; i < 3; ++i) {
        const MotorCommand& command = commands[i];
        if (command.mode != MotorMode::kPosition) continue;
        const double left = command.target - angles[i];
        const double fast = std::min(command.speed_limit_rad_s,
                                     std::sqrt(2.0 * command.accel_rad_s2 * std::abs(left)));
        const double wanted = std::copysign(std::min(fast, std::abs(left) / dt), left);
        speed[i] +=
            std::clamp(wanted - speed[i], -command.accel_rad_s2 * dt, command.accel_rad_s2 * dt);
        angles[i] += dt * speed[i];
      }
      Press();
    }
    tick += kControlPeriod;
  }

  void Press() {
    const Pose3 X_RK = SecondLink(nominal.mast, angles);
    double force_n = 0.0;
    for (int i = 0; i < 3; ++i) {
      const double turn = 2.0 * kPi / 3.0 * i;
      const double r = nominal.mast.switch_radius_m;
      const Eigen::Vector3d p =
          X_RK * Eigen::Vector3d(nominal.mast.link2_m, r * std::sin(turn), r * std::cos(turn));
      const double in_m = -face.normal_R.dot(p - face.p_RT);
      const double one_n = kSpring_n_m * std::max(0.0, in_m);
      contacts[static_cast<std::size_t>(i)] = one_n > kSwitch_n;
      force_n += one_n;
      deepest_m = std::max(deepest_m, in_m);
    }
    most_n = std::max(most_n, force_n);
    const Eigen::Vector3d middle = FaceCentre(nominal.mast, angles);
    lowest_m = std::min(lowest_m, face.normal_R.dot(middle - face.p_RT));
  }

  SensorFrame Frame() const {
    SensorFrame frame;
    frame.tick = tick;
    frame.motors.resize(15);
    for (std::size_t i = 0; i < 3; ++i) {
      frame.motors[12 + i].encoder_counts = std::llround(angles[i] / 1e-4);
      frame.motors[12 + i].current_a = current_a;
    }
    frame.contacts = contacts;
    return frame;
  }

  void Start(Placement& placement, const FaceAt& face_R) {
    phase = Phase::kUnfold;
    placement.Start(face_R, Frame());
  }
  /// One period. After its end the mast holds.
  void Step(Placement& placement) {
    if (Places(phase)) Follow(Task::kPlace, placement.Step(phase, Frame()), phase);
    Turn(placement.commands());
  }
  /// Runs until it ends, at most two minutes; phases in their order.
  std::vector<Phase> Run(Placement& placement, const FaceAt& face_R) {
    Start(placement, face_R);
    std::vector<Phase> phases;
    while (Places(phase) && tick < 120000) {
      if (phases.empty() || phases.back() != phase) phases.push_back(phase);
      Step(placement);
    }
    return phases;
  }
};

FaceAt Face(double up_deg) {
  return {{0.85, 0.05, 0.33},
          Eigen::Vector3d(-std::cos(Radians(up_deg)), 0.0, std::sin(Radians(up_deg)))};
}

TEST(Placement, TouchesHoldsDrawsBackAndStows) {
  IdealMast mast;
  mast.face = Face(30.0);
  Placement placement(mast.nominal);
  const auto phases = mast.Run(placement, mast.face);
  EXPECT_EQ(mast.phase, Phase::kBackOff) << placement.note();
  EXPECT_THAT(phases, ElementsAre(Phase::kUnfold, Phase::kAdvance, Phase::kPress, Phase::kHold,
                                  Phase::kRetract, Phase::kStow));
  EXPECT_GE(placement.closed(), 2);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(mast.angles[i], mast.nominal.mast.watch_rad[i], 0.01);
  }
}

TEST(Placement, PressesWithLessThanTenNewtonsWhereverTheSurfaceIs) {
  for (const double further_m : {-0.03, -0.01, 0.0, 0.01, 0.03, 0.05}) {
    IdealMast mast;
    mast.face = Face(30.0);
    FaceAt seen = mast.face;
    seen.p_RT += further_m * seen.normal_R;
    Placement placement(mast.nominal);
    mast.Run(placement, seen);
    EXPECT_EQ(mast.phase, Phase::kBackOff) << further_m;
    EXPECT_LT(mast.most_n, 10.0) << further_m;
    EXPECT_NEAR(placement.beyond_m(), further_m, 0.006);
  }
}

// What closes a switch, v t + v^2 / 2 a of 1 cm/s in two periods, and the 3 mm of pressing.
TEST(Placement, GoesNoFurtherThanItsClosedFormAllows) {
  IdealMast mast;
  mast.face = Face(40.0);
  Placement placement(mast.nominal);
  mast.Run(placement, mast.face);
  const double closes_m = kSwitch_n / kSpring_n_m;
  EXPECT_LT(mast.deepest_m, closes_m + 0.01 * 0.1 + 0.01 * 0.01 / (2.0 * 0.25) + 0.003 + 5e-4);
}

TEST(Placement, DrawsBackAndSaysSoWhenNothingIsThere) {
  IdealMast mast;
  mast.face = Face(30.0);
  FaceAt seen = mast.face;
  seen.p_RT += 0.12 * seen.normal_R;
  Placement placement(mast.nominal);
  const auto phases = mast.Run(placement, seen);
  EXPECT_EQ(mast.phase, Phase::kAim);
  EXPECT_THAT(phases, ElementsAre(Phase::kUnfold, Phase::kAdvance, Phase::kRetract, Phase::kStow));
  EXPECT_GT(mast.lowest_m, 0.04);
}

TEST(Placement, ComesDownAlongTheNormal) {
  IdealMast mast;
  mast.face = Face(45.0);
  Placement placement(mast.nominal);
  mast.Start(placement, mast.face);
  double off_m = 0.0;
  while (Places(mast.phase) && mast.phase != Phase::kHold) {
    mast.Step(placement);
    if (mast.phase != Phase::kAdvance) continue;
    const Eigen::Vector3d from = FaceCentre(mast.nominal.mast, mast.angles) - mast.face.p_RT;
    off_m = std::max(off_m, (from - mast.face.normal_R * mast.face.normal_R.dot(from)).norm());
  }
  EXPECT_LT(off_m, 0.002);
}

TEST(Placement, StopsWhereACurrentRisesOnItsWay) {
  IdealMast mast;
  mast.face = Face(30.0);
  Placement placement(mast.nominal);
  mast.Start(placement, mast.face);
  for (int i = 0; i < 20; ++i) mast.Step(placement);
  EXPECT_EQ(mast.phase, Phase::kUnfold);
  mast.current_a = 1.5;
  for (int i = 0; i < 6; ++i) mast.Step(placement);
  EXPECT_EQ(mast.phase, Phase::kGivenUp);
  const MastAngles stopped = mast.angles;
  for (int i = 0; i < 40; ++i) mast.Step(placement);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(mast.angles[i], stopped[i], 0.05);
}

TEST(Placement, RefusesAPlaceOutOfReach) {
  IdealMast mast;
  mast.face = Face(10.0);
  FaceAt far = mast.face;
  far.p_RT.x() = 1.6;
  Placement placement(mast.nominal);
  mast.Run(placement, far);
  EXPECT_EQ(mast.phase, Phase::kGivenUp);
}

}  // namespace
}  // namespace dockyard::rocky7
