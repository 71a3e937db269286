// Which outcome the truth at a run's end has.
#include "sim/custom/outcome.h"

#include <gtest/gtest.h>

namespace dockyard::custom {
namespace {

JudgeKeys Keys4mm() {
  JudgeKeys keys;
  keys.docked.pose.x_m = 0.004;
  keys.docked.pose.y_m = 0.012;
  keys.docked.pose.yaw_rad = Radians(4.0);
  keys.docked.contact.pins = "charge";
  return keys;
}

EndOfRun Docked() {
  EndOfRun end;
  end.claimed = Verdict::kDone;
  end.contact.closed = true;
  end.contact_asked = true;
  end.was_closed = true;
  end.held = true;
  return end;
}

TEST(CustomOutcome, NamesADockingThatLasts) {
  EXPECT_EQ(JudgeEnd(Docked(), Keys4mm()).outcome, Outcome::kDocked);
  EndOfRun tried = Docked();
  tried.tried = tried.kept = true;
  EXPECT_EQ(JudgeEnd(tried, Keys4mm()).outcome, Outcome::kDocked);
  tried.kept = false;
  tried.lost_in = "push 2";
  EXPECT_EQ(JudgeEnd(tried, Keys4mm()).outcome, Outcome::kContactLost);
  EXPECT_EQ(JudgeEnd(tried, Keys4mm()).note.rfind("did not last the trial's push 2; ", 0), 0u);
}

TEST(CustomOutcome, TellsHalfADockingFromNone) {
  EndOfRun end = Docked();
  end.held = false;
  end.truth.X_QP.p.x() = 0.006;  // closed, off its place
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kPartlySeated);
  end.contact.closed = false;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kContactLost);
  end.was_closed = false;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kFalseDocked);
  end.truth.X_QP.p.x() = 0.002;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kPartlySeated);
}

TEST(CustomOutcome, PutsDamageBeforeAClaim) {
  EndOfRun end = Docked();
  end.truth.dock_moved_m = 0.03;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kDockPushed);
  end.truth.peak_touch_n = 400.0;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kCollided);
  end.truth.dock_tilt_rad = 1.0;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kTippedOver);
}

TEST(CustomOutcome, SaysHowARunWithoutAClaimEnded) {
  EndOfRun end;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kTimeout);
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).note.rfind("ran out of time; ", 0), 0u);
  end.phase = "search";
  end.said = "no dock detected";
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).note.rfind("ran out of time in 'search': no dock", 0), 0u);
  end.claimed = Verdict::kGivenUp;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).outcome, Outcome::kGaveUp);
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).note.rfind("gave up: no dock detected; ", 0), 0u);
  end.truth.dock_tilt_rad = 1.0;
  EXPECT_EQ(JudgeEnd(end, Keys4mm()).note.rfind("the dock by 57.3 deg; ", 0), 0u);
}

TEST(CustomOutcome, StatesMarginsOfWhatIsAskedAlone) {
  EndOfRun end = Docked();
  end.truth.X_QP.p = {0.003, -0.010, 0.0};
  for (const JudgedLimit& limit : LimitsOf(end, Keys4mm())) {
    if (limit.name == "off_x_m") {
      EXPECT_NEAR(limit.margin(), 0.001, 1e-12);
    }
    if (limit.name == "off_y_m") {
      EXPECT_NEAR(limit.margin(), 0.002, 1e-12);
    }
    if (limit.name == "touch_n") {
      EXPECT_TRUE(std::isnan(limit.margin()));
    }
  }
}

TEST(CustomOutcome, StatesTheMarginOfEachNumberOfTheBox) {
  JudgeKeys keys = Keys4mm();
  keys.docked.pose.z_m = 0.005;
  keys.docked.pose.roll_rad = keys.docked.pose.pitch_rad = Radians(3.0);
  EndOfRun end = Docked();
  end.truth.X_QP = {RotY(Radians(2.0)) * RotX(Radians(-1.0)), {0.0, 0.0, -0.007}};
  std::vector<std::pair<std::string, double>> margins;
  for (const JudgedLimit& limit : LimitsOf(end, keys)) {
    if (limit.name == "off_z_m" || limit.name == "off_roll_deg" || limit.name == "off_pitch_deg")
      margins.emplace_back(limit.name, limit.margin());
  }
  ASSERT_EQ(margins.size(), 3u);
  EXPECT_NEAR(margins[0].second, -0.002, 1e-12);
  EXPECT_NEAR(margins[1].second, 2.0, 1e-9);
  EXPECT_NEAR(margins[2].second, 1.0, 1e-9);
}

TEST(CustomOutcome, ANumberThatABoxDoesNotNameMayBeAnything) {
  PoseBox box;
  box.y_m = 0.01;
  Pose3 X_QP = Pose3::Translation(5.0, 0.009, -3.0);
  X_QP.R = RotZ(2.0);
  EXPECT_TRUE(Holds(box, X_QP));
  box.yaw_rad = 0.1;
  EXPECT_FALSE(Holds(box, X_QP));
}

}  // namespace
}  // namespace dockyard::custom
