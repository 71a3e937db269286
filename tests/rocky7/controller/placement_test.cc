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
  FaceAt face;                                      // as it is
  double spring_n_m = kSpring_n_m, mast_n_m = 0.0;  // of a switch, of the mast; 0: rigid
  double ball_radius_m = 0.0;  // of the surface, which the face touches; 0: flat
  double roll_off_rad = 0.0;
  MastAngles angles = nominal.mast.watch_rad;
  std::array<double, 3> speed{};
  Tick tick = 0;
  double most_n = 0.0, deepest_m = 0.0;
  double lowest_m = 1.0;  // of the face's middle before the surface
  std::vector<double> closed = {0, 0, 0};
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

  double DepthOf(const Eigen::Vector3d& p_R) const {
    if (ball_radius_m == 0.0) return -face.normal_R.dot(p_R - face.p_RT);
    return ball_radius_m - (p_R - face.p_RT + ball_radius_m * face.normal_R).norm();
  }
  /// The tool's axis off the ball's normal under the face.
  double Lean() const {
    const Pose3 X_RK = SecondLink(nominal.mast, angles);
    const Eigen::Vector3d out =
        FaceCentre(nominal.mast, angles) - face.p_RT + ball_radius_m * face.normal_R;
    return AngleBetween(-X_RK.R.col(0), out);
  }

  void Press() {
    const Pose3 X_RK = SecondLink(nominal.mast, angles);
    std::array<double, 3> in_m{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double turn = 2.0 * kPi / 3.0 * static_cast<double>(i);
      const double r = nominal.mast.switch_radius_m;
      in_m[i] = DepthOf(
          X_RK * Eigen::Vector3d(nominal.mast.link2_m, r * std::sin(turn), r * std::cos(turn)));
      deepest_m = std::max(deepest_m, in_m[i]);
    }
    const auto force_n = [&](double gives_m) {
      double sum_n = 0.0;
      for (const double in : in_m) sum_n += spring_n_m * std::max(0.0, in - gives_m);
      return sum_n;
    };
    // The can slides on the mast's spring until both press alike.
    double low_m = 0.0, high_m = mast_n_m > 0.0 ? 0.1 : 0.0;
    for (int i = 0; i < 40 && high_m > 0.0; ++i) {
      const double middle_m = 0.5 * (low_m + high_m);
      (force_n(middle_m) > mast_n_m * middle_m ? low_m : high_m) = middle_m;
    }
    for (std::size_t i = 0; i < 3; ++i) closed[i] = spring_n_m * (in_m[i] - low_m) > kSwitch_n;
    most_n = std::max(most_n, force_n(low_m));
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
    frame.values = closed;
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

// A ball of 11 cm that is 9 mm lower, higher or further aside than it was detected: the tool leans
// by 3 to 8 deg, and the switches show to which side. The lean in closed form by the ball's middle.
TEST(Placement, TouchesAgainTowardsTheSwitchesThatClosed) {
  struct Case {
    Eigen::Vector3d off_m{0, 0, 0};
    double better_deg = 0.0;  // at least
  };
  for (const auto& [off_m, better_deg] :
       {Case{{0.0, 0.0, 0.009}, 3.0}, Case{{0.0, 0.0, -0.009}, 2.6}, Case{{0.0, 0.009, 0.0}, 2.6},
        Case{{0.0, -0.009, 0.0}, 1.0}}) {
    double lean_rad[2] = {0.0, 0.0};
    for (const bool bends : {false, true}) {
      IdealMast mast;
      mast.face = Face(30.0);
      mast.ball_radius_m = 0.11;
      mast.spring_n_m = 1000.0;
      mast.mast_n_m = 500.0;
      FaceAt detected = mast.face;
      detected.bend_R.setZero();
      if (bends) {
        detected.bend_R =
            (Eigen::Matrix3d::Identity() - detected.normal_R * detected.normal_R.transpose()) /
            mast.ball_radius_m;
      }
      mast.face.p_RT += off_m;
      Placement placement(mast.nominal);
      mast.Start(placement, detected);
      while (Places(mast.phase) && mast.tick < 120000) {
        mast.Step(placement);
        if (mast.phase == Phase::kHold) lean_rad[bends] = mast.Lean();
      }
      EXPECT_EQ(mast.phase, Phase::kBackOff) << placement.note();
      EXPECT_LT(mast.most_n, 10.0);
    }
    EXPECT_GT(Degrees(lean_rad[0]), 3.0);
    std::printf("%.2f deg, then %.2f\n", Degrees(lean_rad[0]), Degrees(lean_rad[1]));
    EXPECT_GT(Degrees(lean_rad[0] - lean_rad[1]), better_deg) << off_m.transpose();
  }
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
