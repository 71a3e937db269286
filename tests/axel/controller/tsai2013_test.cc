// The published controller: its plans, and what it does with a sighting.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/axel.h"
#include "controller/axel/tsai2013_plan.h"
#include "sim/base/random.h"

namespace dockyard::axel {
namespace {

const Tsai2013Options kOptions;

Tsai2013Plan PlanFrom(const DockingCoords& at) {
  return PlanTsai2013(PlanGeometryOf(TestNominal()), kOptions, FromDockingCoords(at));
}

TEST(Tsai2013Plan, ApproachesByAForwardSToTheBorderOfTheAlignment) {
  RandomStream random(StreamKey(1, "approach"));
  int planned = 0;
  for (int i = 0; i < 200; ++i) {
    const DockingCoords at{random.Uniform(3.5, 6.0), Radians(random.Uniform(-20, 20)),
                           Radians(random.Uniform(-15, 15))};
    const Tsai2013Plan plan = PlanFrom(at);
    if (plan.step != Tsai2013Step::kApproach) continue;
    ++planned;
    const Pose2 end = Advance(FromDockingCoords(at), plan.arcs);
    EXPECT_NEAR(end.x, kOptions.align_r_m, 1e-9);
    EXPECT_NEAR(end.y, 0.0, 1e-9);
    EXPECT_NEAR(std::abs(end.heading), kPi, 1e-9);
    for (const Arc& arc : plan.arcs) EXPECT_GE(arc.length_m, -1e-9);
  }
  EXPECT_GT(planned, 150);
}

TEST(Tsai2013Plan, MatesWithinFiveDegreesAndRecoversBeyond) {
  EXPECT_EQ(PlanFrom({1.4, 0.0, Radians(1.0)}).step, Tsai2013Step::kMate);
  EXPECT_EQ(PlanFrom({1.4, Radians(3.0), Radians(4.9)}).step, Tsai2013Step::kMate);
  EXPECT_EQ(PlanFrom({1.4, Radians(3.0), Radians(5.1)}).step, Tsai2013Step::kRecover);
}

TEST(Tsai2013Plan, MatesByAnSThatBringsTheTipToTheContact) {
  const Nominal nominal = TestNominal();
  const DockingCoords at{1.5, Radians(1.5), Radians(-1.0)};
  const Tsai2013Plan plan = PlanFrom(at);
  ASSERT_EQ(plan.step, Tsai2013Step::kMate);
  const TipPlace tip = TipOf(PlanGeometryOf(nominal), Advance(FromDockingCoords(at), plan.arcs));
  EXPECT_NEAR(tip.gap_m, -kOptions.contact_depth_m, 1e-9);
  EXPECT_NEAR(tip.offset_m, 0.0, 1e-9);
}

// 0.1 m before the contact no arc of 1 m goes 2 cm aside.
TEST(Tsai2013Plan, DrivesStraightOnWhereNoSLeadsIfTheTipMeetsTheMouth) {
  const double r_m = TestNominal().arm_length_m + 0.1;
  const auto from = [&](double aside_m) {
    return PlanTsai2013(PlanGeometryOf(TestNominal()), kOptions, {r_m, aside_m, kPi});
  };
  const Tsai2013Plan within = from(0.02);
  ASSERT_EQ(within.step, Tsai2013Step::kMate);
  ASSERT_EQ(within.arcs.size(), 1u);
  EXPECT_NEAR(within.arcs[0].length_m, 0.1 + kOptions.contact_depth_m, 1e-9);
  EXPECT_EQ(from(kOptions.tip_offset_m + 0.01).step, Tsai2013Step::kRecover);
}

TEST(Tsai2013Plan, ReelsInAtTheContactUnlessTheTipIsBesideTheMouth) {
  const double r_m = TestNominal().arm_length_m - kOptions.contact_depth_m;
  const auto from = [&](double x_m, double aside_m) {
    return PlanTsai2013(PlanGeometryOf(TestNominal()), kOptions, {x_m, aside_m, kPi}).step;
  };
  EXPECT_EQ(from(r_m, 0.0), Tsai2013Step::kReel);
  EXPECT_EQ(from(r_m + kOptions.contact_within_m - 1e-6, 0.0), Tsai2013Step::kReel);
  EXPECT_EQ(from(r_m + kOptions.contact_within_m + 1e-3, 0.0), Tsai2013Step::kMate);
  EXPECT_EQ(from(r_m, kOptions.tip_offset_m + 0.01), Tsai2013Step::kRecover);
}

TEST(Tsai2013Plan, RecoversBackwardsOntoTheAxis) {
  const DockingCoords at{1.3, Radians(4.0), Radians(-7.0)};
  const Tsai2013Plan plan = PlanFrom(at);
  ASSERT_EQ(plan.step, Tsai2013Step::kRecover);
  const Pose2 end = Advance(FromDockingCoords(at), plan.arcs);
  EXPECT_NEAR(end.x, kOptions.recover_r_m, 1e-9);
  EXPECT_NEAR(end.y, 0.0, 1e-9);
  for (const Arc& arc : plan.arcs) EXPECT_LE(arc.length_m, 1e-9);
}

// From beside the goal the only backward pairs go round in circles.
TEST(Tsai2013Plan, NeverTurnsTheStationFarOutOfView) {
  RandomStream random(StreamKey(2, "turns"));
  for (int i = 0; i < 500; ++i) {
    const DockingCoords at{random.Uniform(1.2, 7.0), Radians(random.Uniform(-45, 45)),
                           Radians(random.Uniform(-30, 30))};
    double way_m = 0.0;
    for (const Arc& arc : PlanFrom(at).arcs) {
      EXPECT_LE(std::abs(arc.turn_rad), kOptions.most_turn_rad);
      way_m += std::abs(arc.length_m);
    }
    EXPECT_LT(way_m, 10.0) << at.r << ' ' << Degrees(at.alpha) << ' ' << Degrees(at.h);
  }
}

/// The controller on a stand whose motors follow each position command at once, whose spool is
/// always taut, and whose camera finds the board from the given poses in turn, then not at all.
struct Stand {
  explicit Stand(std::vector<Pose2> poses) : seen(std::move(poses)) {
    controller =
        MakeTsai2013Controller(nominal, [this](const StereoImages&, const LocateHints& hints) {
          EXPECT_EQ(hints.up_R, LocateHints{}.up_R);  // nothing of the attitude
          EXPECT_FALSE(hints.X_RB_expected);
          if (looks >= seen.size()) {
            ++looks;
            return LocateOutput{PoseFailure::kNoCorrespondence, {}};
          }
          const Pose3 X_DR = FromGround(seen[looks++], nominal.wheel_radius_m);
          LocateOutput out{PoseFailure::kNoCorrespondence, {}};
          out.sighting = DockSighting{.X_RB = Inverse(X_DR) * nominal.X_DB};
          return out;
        });
  }

  void Step() {
    SensorFrame sent = frame;
    if (asked) sent.images = {{kLeftCamera, GrayImage{}}, {kRightCamera, GrayImage{}}};
    commands = controller->Step(sent);
    asked = !commands.take_images.empty();
    for (std::size_t i = 0; i < commands.motors.size(); ++i) {
      if (commands.motors[i].mode != MotorMode::kPosition) continue;
      frame.motors[i].encoder_counts =
          std::lround(commands.motors[i].target / nominal.motors[i].rad_per_count);
    }
    frame.tick += kControlPeriod;
  }
  /// Steps until the phase begins; false after two minutes.
  bool Reaches(const std::string& phase) {
    for (Tick end = frame.tick + 120'000; frame.tick < end;) {
      Step();
      if (controller->belief().phase == phase) return true;
    }
    return false;
  }

  Nominal nominal = TestNominal();
  std::vector<Pose2> seen;
  std::size_t looks = 0;
  std::unique_ptr<Controller> controller;
  SensorFrame frame = StillFrame();
  Commands commands;
  bool asked = false;
};

Pose2 AtContact() { return {TestNominal().arm_length_m - kOptions.contact_depth_m, 0.0, kPi}; }

TEST(Tsai2013, BelievesTheLastSightingAlone) {
  Stand stand({{4.0, 0.5, kPi}, {2.6, -0.4, kPi + 0.1}});
  ASSERT_TRUE(stand.Reaches("approach"));
  EXPECT_NEAR(stand.controller->belief().X_DR.y, 0.5, 1e-9);
  ASSERT_TRUE(stand.Reaches("look"));
  while (stand.looks < 2) stand.Step();
  EXPECT_NEAR(stand.controller->belief().X_DR.x, 2.6, 1e-9);
  EXPECT_NEAR(stand.controller->belief().X_DR.y, -0.4, 1e-9);
}

TEST(Tsai2013, FreesTheWheelsAtContactAndReelsTheLengthInThatEndsIt) {
  Stand stand({AtContact()});
  ASSERT_TRUE(stand.Reaches("reel"));
  const auto spool = static_cast<std::size_t>(Motor::kSpool);
  const double counts = static_cast<double>(stand.frame.motors[spool].encoder_counts);
  stand.Step();
  EXPECT_EQ(stand.commands.motors[0].mode, MotorMode::kFree);
  EXPECT_EQ(stand.commands.motors[1].mode, MotorMode::kFree);
  const double reeled_rad =
      stand.commands.motors[spool].target - counts * stand.nominal.motors[spool].rad_per_count;
  EXPECT_NEAR(reeled_rad * stand.nominal.drum_radius_m, 0.25, 1e-4);
  ASSERT_TRUE(stand.Reaches("docked"));
  EXPECT_EQ(stand.commands.verdict, Verdict::kDone);
}

TEST(Tsai2013, GivesUpWithoutThePoseOfTheBoard) {
  Stand stand({});
  ASSERT_TRUE(stand.Reaches("given_up"));
  EXPECT_EQ(stand.commands.verdict, Verdict::kGivenUp);
  EXPECT_EQ(stand.looks, static_cast<std::size_t>(kOptions.blind_looks));
}

// "In the final phases of this process, the fiducial markers are too close to be identified" (II).
TEST(Tsai2013, ReelsInByThePlanWhereTheBoardIsTooNearToBeSeen) {
  Stand stand({{1.4, 0.0, kPi}});
  ASSERT_TRUE(stand.Reaches("mate"));
  ASSERT_TRUE(stand.Reaches("reel"));
  EXPECT_NEAR(stand.controller->belief().X_DR.x, AtContact().x, 1e-9);
}

TEST(Tsai2013, RecoversWithoutLimit) {
  std::vector<Pose2> poses(40, {1.3, 0.0, kPi + Radians(8.0)});
  poses.push_back(AtContact());
  Stand stand(poses);
  for (int i = 1; i <= 40; ++i) {
    ASSERT_TRUE(stand.Reaches("recover"));
    EXPECT_EQ(stand.controller->belief().values[1].value, i);
    ASSERT_TRUE(stand.Reaches("tighten"));
  }
  EXPECT_TRUE(stand.Reaches("reel"));
}

}  // namespace
}  // namespace dockyard::axel
