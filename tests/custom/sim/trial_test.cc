// What the judge tries on a docked robot: parts that a contact lasts, and parts that it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "custom/charger_rig.h"
#include "sim/custom/custom_judge.h"
#include "sim/plant/renderer.h"

namespace dockyard::custom {
namespace {

using ::testing::HasSubstr;

Commands Both(const WorldSetup& setup, double m_s) {
  Commands commands;
  commands.motors = DriveAt(setup, m_s, m_s);
  return commands;
}

struct Tried {
  Conclusion end;
  double pressed_m = 0.0;  // the pins, when docked
};

/// A robot at its seat claims to be docked; then the trial.
Tried Try(const std::string& trial) {
  const Scenario scenario =
      ChargerScenario({"start={r_m: 0.3, alpha_deg: 0, heading_deg: 0}", "scenery=[]",
                       "judge.docked.hold_s=0.2", "judge.trial=" + trial});
  CustomPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)),
                    std::make_shared<KeptRenderer>());
  plant.RefreshTruth();
  CustomJudge judge(plant);
  const Commands forward = Both(plant.built().world, 0.05);
  while (plant.truth().X_QP.p.x() < 0.0) {
    plant.Advance(forward);
    plant.RefreshTruth();
    judge.Observe();
  }
  Commands claim;
  claim.motors.resize(forward.motors.size());  // braked
  claim.verdict = Verdict::kDone;
  Tried tried;
  tried.end = judge.Conclude(claim, Belief{}, [&](const char* phase) {
    if (phase == std::string("hold")) tried.pressed_m = 0.002 + plant.truth().X_QP.p.x();
  });
  std::printf("%s: %s\n", tried.end.outcome.c_str(), tried.end.note.c_str());
  return tried;
}

const std::string kClosed = ", contact: {pins: charge, closed: true}}";

// The contact opens once it has gone back by what its pins are pressed in.
TEST(CustomTrial, DriveAwayThatIsShorterThanThePinsStrokeHolds) {
  const Tried tried = Try("{drive_m_s: 0.005, for_s: 0.2" + kClosed);
  EXPECT_EQ(tried.end.outcome, "docked") << tried.end.note;
  EXPECT_GT(tried.pressed_m, 0.0015);
}

TEST(CustomTrial, DriveAwayBeyondThePinsStrokeLosesTheContact) {
  const Tried tried = Try("{drive_m_s: 0.02, for_s: 0.5" + kClosed);
  EXPECT_EQ(tried.end.outcome, "contact_lost");
  EXPECT_THAT(tried.end.note, HasSubstr("did not last the trial's drive; "));
  EXPECT_LT(tried.pressed_m, 0.02 * 0.5);
}

// The robot weighs 43 N: its tyres' friction bears the one, and not the other.
TEST(CustomTrial, ShakeBelowFrictionHolds) {
  EXPECT_EQ(Try("{shake_n: 8, shake_hz: 2, for_s: 1" + kClosed).end.outcome, "docked");
}

TEST(CustomTrial, ShakeBeyondFrictionLosesTheContact) {
  const Tried tried = Try("{shake_n: 60, shake_hz: 2, for_s: 1" + kClosed);
  EXPECT_EQ(tried.end.outcome, "contact_lost");
  EXPECT_THAT(tried.end.note, HasSubstr("did not last the trial's shake; "));
}

// All parts are tried, and the first that fails is named.
TEST(CustomTrial, NamesTheFirstPartThatFails) {
  const std::string both = "drive_m_s: 0.02, for_s: 0.5" + kClosed;
  EXPECT_THAT(Try("{push_n: 2, shake_n: 4, " + both).end.note, HasSubstr("trial's drive; "));
  EXPECT_THAT(Try("{push_n: 60, shake_n: 4, " + both).end.note, HasSubstr("trial's push 1; "));
}

// It goes back by 1 mm, and its contact lasts.
TEST(CustomTrial, KeepsThePoseThatIsAskedOrFails) {
  EXPECT_EQ(Try("{drive_m_s: 0.005, for_s: 0.2, pose: {x_m: 0.004}}").end.outcome, "docked");
  const Tried tried = Try("{drive_m_s: 0.005, for_s: 0.2, pose: {x_m: 0.0005}}");
  EXPECT_EQ(tried.end.outcome, "contact_lost");
  EXPECT_THAT(tried.end.note, HasSubstr("trial's drive; "));
}

}  // namespace
}  // namespace dockyard::custom
