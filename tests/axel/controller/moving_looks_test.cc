// Pictures under way: placed where they were exposed, asked for only where they can be sharp.
#include "controller/axel/moving_looks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/sighting.h"

namespace dockyard::axel {
namespace {

class UnderWay : public testing::Test {
 protected:
  UnderWay() {
    const Pose2 X_DR = FromDockingCoords({4.0, Radians(10.0), 0.0});
    Step(0.0, 0.0);
    SightingJudge(options_.look, nominal_.X_DB).Judge({Seen(X_DR), 1.0, 14, true}, &senses_);
  }
  Pose3 Seen(const Pose2& X_DR) const {
    return Inverse(FromGround(X_DR, nominal_.wheel_radius_m)) * nominal_.X_DB;
  }
  // Wheels that run free: odometry takes all that they roll.
  void Step(double way_m, double turn_rad) {
    rolled_m_ += way_m;
    frame_.imu.yaw_rad += turn_rad;
    for (const Motor wheel : {Motor::kLeftWheel, Motor::kRightWheel}) {
      const auto i = static_cast<std::size_t>(wheel);
      frame_.motors[i].encoder_counts =
          std::llround(rolled_m_ / nominal_.wheel_radius_m / nominal_.motors[i].rad_per_count);
    }
    frame_.tick += kControlPeriod;
    frame_.images.clear();
    senses_.Update(frame_);
    looks_.Remember(senses_);
  }
  void Drive(int steps) {
    for (int i = 0; i < steps; ++i) Step(1e-3, Radians(0.1));
  }
  bool Asks() { return looks_.Asks(senses_, false, true, 4.0); }
  std::optional<SinceExposure> AnswerOf(Tick exposed) {
    frame_.images = {{kLeftCamera, GrayImage{}, exposed}};
    return looks_.Answered(frame_, senses_);
  }

  static Nominal WithShutter() {
    Nominal nominal = TestNominal();
    nominal.shutter_s = 0.005;
    return nominal;
  }

  const Nominal nominal_ = WithShutter();
  const AxelOptions options_{};
  Senses senses_{nominal_, options_};
  MovingLooks looks_{options_, nominal_};
  SensorFrame frame_ = StillFrame();
  double rolled_m_ = 0.0;
};

TEST_F(UnderWay, ALatePictureIsCarriedFromItsExposureToNow) {
  Drive(250);
  ASSERT_TRUE(Asks());
  Step(1e-3, Radians(0.1));
  const Tick exposed = senses_.now();
  const Pose2 then = senses_.pose();
  const LocateHints there = HintsFrom(senses_);
  Drive(50);
  const std::optional<SinceExposure> since = AnswerOf(exposed);
  ASSERT_TRUE(since);
  EXPECT_NEAR(since->way_m, 0.05, 2e-3);
  const LocateHints hints = HintsThen(senses_, *since);
  EXPECT_TRUE(hints.X_RB_expected->p.isApprox(there.X_RB_expected->p, 1e-9));
  EXPECT_TRUE(hints.X_RB_expected->R.isApprox(there.X_RB_expected->R, 1e-9));
  LocateOutput seen{DockSighting{Seen(then), 1.0, 14, true}, {}};
  seen.sighting->covariance.diagonal().setConstant(1e-6);
  CarryToNow(*since, options_.noise, &seen);
  EXPECT_TRUE(seen.sighting->X_RB.p.isApprox(Seen(senses_.pose()).p, 1e-9));
  // The way since is known to 5 % of its square root.
  EXPECT_NEAR(seen.sighting->covariance(0, 0), 1e-6 + 0.0025 * since->way_m, 2e-5);
}

// A correction of the belief in between moves no place of the ring.
TEST_F(UnderWay, ACorrectionMeanwhileDoesNotMoveTheExposure) {
  Drive(250);
  ASSERT_TRUE(Asks());
  Step(1e-3, 0.0);
  const Tick exposed = senses_.now();
  Drive(25);
  const Pose2 here = senses_.pose();
  senses_.filter().Restart({3.0, 0.1, here.heading + 0.2, Eigen::Vector3d::Constant(1e-6)});
  Drive(25);
  const std::optional<SinceExposure> since = AnswerOf(exposed);
  ASSERT_TRUE(since);
  EXPECT_NEAR(since->way_m, 0.05, 2e-3);
}

TEST_F(UnderWay, AnswersOfEarlierQuestionsAreNotTaken) {
  EXPECT_FALSE(AnswerOf(senses_.now()));  // none was asked for
  Drive(250);
  ASSERT_TRUE(Asks());
  EXPECT_FALSE(AnswerOf(senses_.now() - kMostStampError - kControlPeriod));
  Step(1e-3, 0.0);
  looks_.Begin(senses_.now());
  EXPECT_FALSE(AnswerOf(senses_.now()));  // of the leg before
}

TEST_F(UnderWay, ATurningCameraIsNotAsked) {
  Drive(250);
  frame_.imu.rate_R.z() = 0.5;
  Step(1e-3, 0.0);
  EXPECT_GT(ExpectedBlur_px(nominal_, senses_.imu(), 0.05, 4.0), options_.moving.blur_px);
  EXPECT_FALSE(Asks());
  frame_.imu.rate_R.z() = 0.0;
  Step(1e-3, 0.0);
  EXPECT_TRUE(Asks());
}

TEST_F(UnderWay, CamerasThatDoNotAnswerAreNotAskedForEver) {
  int asks = 0;
  for (int i = 0; i < 5000; ++i) {
    Step(1e-4, 0.0);
    asks += Asks() ? 1 : 0;
  }
  EXPECT_EQ(asks, options_.moving.unanswered + 1);
}

KinematicRun DriveLooking(KinematicWorld world) {
  world.while_driving = true;
  return RunKinematic(world, {5.0, Radians(15.0), 0.0});
}

int Stops(const KinematicRun& run) {
  return static_cast<int>(std::count(run.phases.begin(), run.phases.end(), "look"));
}

TEST(LooksUnderWay, SaveStops) {
  const KinematicRun with = DriveLooking({}), without = RunKinematic({}, {5.0, Radians(15.0), 0.0});
  EXPECT_EQ(with.verdict, Verdict::kDone);
  EXPECT_LT(Stops(with), Stops(without));
  EXPECT_GT(with.sightings, without.sightings);
  EXPECT_LT(with.time_s, without.time_s);
}

TEST(LooksUnderWay, ASecondLateTheyAreWorthAsMuch) {
  KinematicWorld world;
  world.images_late = 1'000;
  const KinematicRun run = DriveLooking(world);
  EXPECT_EQ(run.verdict, Verdict::kDone);
  EXPECT_EQ(Stops(run), Stops(DriveLooking({})));
  ASSERT_TRUE(run.entry);
  EXPECT_LT(std::abs(run.entry->offset_m), 0.02);
}

// As if there were none: it stops at each leg's end and looks there.
TEST(LooksUnderWay, CamerasThatAreBlindUnderWayChangeNothingElse) {
  KinematicWorld world;
  world.images_lost = true;
  const KinematicRun run = DriveLooking(world),
                     without = RunKinematic({}, {5.0, Radians(15.0), 0.0});
  EXPECT_EQ(run.verdict, Verdict::kDone);
  EXPECT_EQ(run.time_s, without.time_s);
  EXPECT_EQ(run.phases, without.phases);
}

}  // namespace
}  // namespace dockyard::axel
