#include "controller/axel/haul.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/machine.h"

namespace dockyard::axel {
namespace {

using testing::Contains;

const HaulOptions kOptions{};
const Nominal kNominal = TestNominal();
const double kCommanded = Radians(11.0);

const double kSeatedElevation = Radians(5.0);  // the cone's axis

// Degrees of 11 that a push turned the rover: simulated in the socket, in the mouth and outside.
TEST(JudgePush, OnlyTheSocketHoldsTheArm) {
  const auto judge = [](double turned_deg) {
    return JudgePush({kCommanded, Radians(turned_deg), 0.0}, kSeatedElevation, kNominal, kOptions);
  };
  for (const double socket : {0.8, 1.4}) EXPECT_EQ(judge(socket), Hold::kHeld);
  for (const double mouth : {3.5, 4.3}) EXPECT_EQ(judge(mouth), Hold::kLoose);
  for (const double outside : {5.5, 7.0}) EXPECT_EQ(judge(outside), Hold::kLoose);
}

TEST(JudgePush, AnArmThatCameInFurtherIsPushedAgain) {
  for (const double turned_deg : {1.0, 6.0}) {
    const Push push{kCommanded, Radians(turned_deg), 0.026};
    EXPECT_EQ(JudgePush(push, kSeatedElevation, kNominal, kOptions), Hold::kDeeper);
  }
}

// Simulated on sand, 6 to 11 deg aside: 2.6 to 2.9 deg too high.
TEST(JudgePush, AnArmThatStandsTooHighMayBeWedgedInTheThroat) {
  const Push push{kCommanded, Radians(0.3), 0.0};
  EXPECT_EQ(JudgePush(push, kSeatedElevation + Radians(2.6), kNominal, kOptions), Hold::kLoose);
}

TEST(JudgePush, ATipOnTheGroundIsNotInTheCone) {
  const Push push{kCommanded, Radians(1.0), 0.0};
  EXPECT_EQ(JudgePush(push, Radians(-15.0), kNominal, kOptions), Hold::kLoose);
}

TEST(SeatedFix, PutsTheTipOnTheFloor) {
  const Pose2 X_DR = PoseOf(SeatedFix(kNominal), kNominal.X_DB);
  EXPECT_NEAR(X_DR.x, std::cos(kSeatedElevation) - 0.23, 1e-9);
  EXPECT_NEAR(X_DR.y, 0.0, 1e-9);
  EXPECT_NEAR(std::abs(X_DR.heading), kPi, 1e-9);
}

TEST(Haul, DocksWithoutSeeingTheBoard) {
  KinematicWorld world;
  world.blind = true;
  for (const double heading_deg : {0.0, 60.0, -150.0}) {
    const KinematicRun run = RunKinematic(world, {4.0, 0.0, Radians(heading_deg)}, {}, 900.0);
    EXPECT_EQ(run.verdict, Verdict::kDone) << run.belief.note << " " << run.depth_m;
    EXPECT_NEAR(run.depth_m, kNominal.seat_depth_m, 0.01);
    EXPECT_THAT(run.phases, Contains("haul"));
  }
}

TEST(Haul, DoesNotClaimToBeDockedWhereTheTetherHoldsTheRoverOnOpenGround) {
  KinematicWorld world;
  world.blind = true;
  world.roll_tension_n = 400.0;  // the wheels are in a hole
  const KinematicRun run = RunKinematic(world, {4.0, 0.0, 0.0}, {}, 900.0);
  EXPECT_EQ(run.verdict, Verdict::kGivenUp);
  EXPECT_EQ(run.belief.note, "board not found, and the tether does not lead into the cone");
}

TEST(Haul, IsNotTriedFromASideThatTheRoverKnows) {
  const Nominal nominal = TestNominal();
  KinematicRover rover(nominal, {}, FromDockingCoords({4.0, Radians(35.0), 0.0}));
  const auto controller = MakeAxelMachine(
      nominal, {}, [&](const StereoImages&, const LocateHints&) { return rover.Locate(); });
  Verdict verdict = Verdict::kUnderWay;
  for (int i = 0; i < 100'000 && verdict == Verdict::kUnderWay; ++i) {
    SensorFrame frame = rover.Sense();
    if (controller->belief().located) frame.images.clear();
    const Commands commands = controller->Step(frame);
    verdict = commands.verdict;
    ASSERT_NE(controller->belief().phase, "haul");
    rover.Step(commands);
  }
  EXPECT_EQ(verdict, Verdict::kGivenUp);
  EXPECT_EQ(controller->belief().note, "cameras do not answer");
}

}  // namespace
}  // namespace dockyard::axel
