#include "sim/axel/outcome.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dockyard::axel {
namespace {

StationModel Station() {
  StationModel station;
  station.cone.mouth_radius_m = 0.12;
  station.cone.face_outer_radius_m = 0.16;
  station.cone.stop_depth_m = 0.27;
  return station;
}

/// A rover that stands upright and still with its tip at this depth, off the axis by this much.
Truth At(double time_s, double depth_m, double lateral_m, double tension_n) {
  Truth truth;
  truth.time_s = time_s;
  truth.p_MT = {-depth_m, lateral_m, 0.0};
  truth.tether_tension_n = tension_n;
  return truth;
}

/// Feeds the same truth for a while, every control period.
void Hold(OutcomeJudge& judge, Truth truth, double seconds) {
  const double end = truth.time_s + seconds;
  for (; truth.time_s <= end; truth.time_s += 0.02) judge.Observe(truth);
}

const ShakeResult kFirm{true, Radians(1.0), 0.005, 0.268};

TEST(Outcome, DockedNeedsDepthRestTensionAndAFirmShake) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(100.0, 0.2704, 0.005, 50.0), 2.0);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, kFirm).outcome, Outcome::kDocked);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, {true, Radians(5.0), 0.005, 0.268}).outcome,
            Outcome::kFalseDocked);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, {true, Radians(1.0), 0.02, 0.268}).outcome,
            Outcome::kFalseDocked);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, {}).outcome, Outcome::kFalseDocked);
}

TEST(Outcome, DockedAfterAnExcursionNeedsNineTenthsOfTheToldWay) {
  OutcomeLimits limits;
  limits.excursion_m = 10.0;
  const auto WentOut = [&](double way_m) {
    OutcomeJudge judge(Station(), limits);
    judge.Observe(At(0.0, 0.2704, 0.005, 50.0));
    Truth away = At(50.0, -way_m, 0.0, 50.0);
    away.X_WR.p = {0.6 * way_m, 0.8 * way_m, 0.0};
    judge.Observe(away);
    Hold(judge, At(100.0, 0.2704, 0.005, 50.0), 2.0);
    EXPECT_NEAR(judge.farthest_m(), way_m, 1e-9);
    return judge.Conclude(Verdict::kDone, 0, kFirm).outcome;
  };
  EXPECT_EQ(WentOut(0.0), Outcome::kNotGone);
  EXPECT_EQ(WentOut(8.9), Outcome::kNotGone);
  EXPECT_EQ(WentOut(9.1), Outcome::kDocked);
  EXPECT_FALSE(OutcomeNames()[static_cast<std::size_t>(Outcome::kNotGone)].success);
}

TEST(Outcome, SeatedIsNoSuccessWhenTheStationWasPushedOrOverloaded) {
  StationModel station = Station();
  station.cone.rated_force_n = 1000.0;
  Truth truth = At(100.0, 0.2704, 0.005, 50.0);
  const auto Judged = [&] {
    OutcomeJudge judge(station, {});
    Hold(judge, truth, 2.0);
    return judge.Conclude(Verdict::kDone, 0, kFirm).outcome;
  };
  truth.station_shift_m = 0.049;
  truth.cone_force_peak_n = 999.0;
  EXPECT_EQ(Judged(), Outcome::kDocked);
  truth.cone_force_peak_n = 1001.0;
  EXPECT_EQ(Judged(), Outcome::kStationOverload);
  truth.station_shift_m = 0.051;
  EXPECT_EQ(Judged(), Outcome::kStationPushed);
  for (Outcome outcome : {Outcome::kStationPushed, Outcome::kStationOverload}) {
    EXPECT_FALSE(OutcomeNames()[static_cast<std::size_t>(outcome)].success);
  }
}

TEST(Outcome, HeldBeforeTheFloorIsPartlySeatedAndNoSuccess) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(100.0, 0.264, 0.005, 50.0), 2.0);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, kFirm).outcome, Outcome::kPartlySeated);
  EXPECT_FALSE(OutcomeNames()[static_cast<std::size_t>(Outcome::kPartlySeated)].success);
}

TEST(Outcome, ArmThatTheShakePullsOffTheFloorIsPartlySeated) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(100.0, 0.2704, 0.005, 50.0), 2.0);
  const ShakeResult pulled{true, Radians(1.0), 0.0074, 0.263};
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, pulled).outcome, Outcome::kPartlySeated);
}

TEST(Outcome, WithoutAFloorSeatedIsWhatIsReeledIn) {
  StationModel station = Station();
  station.cone.stop_depth_m = 0.0;
  OutcomeJudge judge(station, {});
  Hold(judge, At(100.0, 0.246, 0.005, 50.0), 2.0);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, {true, 0.0, 0.0, 0.246}).outcome, Outcome::kDocked);
}

TEST(Outcome, SlackShallowOrMovingHasNotEntered) {
  for (const Truth& truth : {At(10.0, 0.24, 0.0, 0.0), At(10.0, 0.19, 0.0, 50.0)}) {
    OutcomeJudge judge(Station(), {});
    Hold(judge, truth, 2.0);
    EXPECT_FALSE(judge.entered_at_rest());
  }
  OutcomeJudge judge(Station(), {});
  for (double s = 0.0; s < 2.0; s += 0.02) judge.Observe(At(10.0 + s, 0.24 + 2e-3 * s, 0.0, 50.0));
  EXPECT_FALSE(judge.entered_at_rest());
}

TEST(Outcome, TipThatTremblesByMicrometresIsAtRest) {
  OutcomeJudge judge(Station(), {});
  for (int i = 0; i < 100; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    Truth truth = At(10.0 + 0.02 * i, 0.24 + side * 1e-5, 0.0, 50.0);
    truth.v_MT.x() = side * 0.02;  // 10 um in half a millisecond
    judge.Observe(truth);
  }
  EXPECT_TRUE(judge.entered_at_rest());
}

TEST(Outcome, RestTakesAWholeSecond) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(10.0, 0.24, 0.0, 50.0), 0.9);
  EXPECT_FALSE(judge.entered_at_rest());
  Hold(judge, At(10.92, 0.24, 0.0, 50.0), 0.2);
  EXPECT_TRUE(judge.entered_at_rest());
}

TEST(Outcome, TruthIsNotDockedUnlessTheControllerSaysSo) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(100.0, 0.24, 0.005, 50.0), 2.0);
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, 0, {}).outcome, Outcome::kTimeout);
}

TEST(Outcome, TimeoutTellsHowLongTheRoverHasStoodAndThatARockBearsIt) {
  const auto note = [&](double stood_s, double rock_n) {
    OutcomeJudge judge(Station(), {});
    Hold(judge, At(0.0, -3.0, 0.0, 50.0), 100.0);
    Truth stuck = At(100.02, -1.0, 0.0, 50.0);
    stuck.X_WR.p.x() = 2.0;
    stuck.rock_force_n = rock_n;
    Hold(judge, stuck, stood_s);
    return judge.Conclude(Verdict::kUnderWay, 0, {}).note;
  };
  EXPECT_EQ(note(30.0, 290.0), "time ran out, tip 1000 mm before the mouth");
  EXPECT_EQ(note(500.0, 0.0), "time ran out, tip 1000 mm before the mouth; stood there for 500 s");
  EXPECT_EQ(
      note(500.0, 290.0),
      "time ran out, tip 1000 mm before the mouth; stood there for 500 s with 290 N on a rock");
}

TEST(Outcome, AJamIsStillnessUnderPullInsideTheCone) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(50.0, 0.15, 0.02, 200.0), 10.0);
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, 2, {}).outcome, Outcome::kJammed);
}

TEST(Outcome, AFaceCatchIsTheTipPressedOnTheFace) {
  Truth truth = At(50.0, 0.0, 0.13, 90.0);
  truth.face_force_n = 60.0;
  OutcomeJudge judge(Station(), {});
  Hold(judge, truth, 5.0);
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, 0, {}).outcome, Outcome::kFaceCatch);
}

TEST(Outcome, AJamThatTheControllerTakesForADockingIsAJam) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(50.0, 0.15, 0.02, 200.0), 10.0);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, {}).outcome, Outcome::kJammed);
}

TEST(Outcome, PassingTheMouthOutsideTheFaceMissesTheCone) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(50.0, 0.05, 0.3, 20.0), 1.0);
  EXPECT_EQ(judge.Conclude(Verdict::kDone, 0, {}).outcome, Outcome::kMissedCone);
}

TEST(Outcome, TheConditionInForceThatBeganFirstNamesTheRun) {
  OutcomeJudge judge(Station(), {});
  judge.ObserveSighting(20.0, SightingQuality::kUndetected);
  Hold(judge, At(50.0, 0.05, 0.3, 20.0), 1.0);
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, 0, {}).outcome, Outcome::kNoDetection);
  // With a good sighting in between, the blindness decided nothing.
  judge.ObserveSighting(30.0, SightingQuality::kGood);
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, 0, {}).outcome, Outcome::kMissedCone);
}

TEST(Outcome, TippingAndOverloadEndTheRun) {
  OutcomeJudge tipped(Station(), {});
  Truth truth = At(5.0, -2.0, 0.0, 0.0);
  truth.X_WR.R = RotX(Radians(70));
  tipped.Observe(truth);
  EXPECT_TRUE(tipped.fatal());
  EXPECT_EQ(tipped.Conclude(Verdict::kUnderWay, 0, {}).outcome, Outcome::kTippedOver);

  OutcomeJudge overload(Station(), {});
  Hold(overload, At(5.0, -2.0, 0.0, 1200.0), 0.3);
  EXPECT_TRUE(overload.fatal());
  EXPECT_EQ(overload.Conclude(Verdict::kUnderWay, 0, {}).outcome, Outcome::kTetherOverload);
}

TEST(Outcome, ArmThatWentOverTheTopNamesTheRunOnlyIfItIsNotBroughtBack) {
  const auto Observe = [](OutcomeJudge& judge, double time_s, double arm_pitch_deg) {
    Truth truth = At(time_s, -2.0, 0.0, 0.0);
    truth.X_WA.R = RotY(Radians(arm_pitch_deg));
    judge.Observe(truth);
  };
  OutcomeJudge judge(Station(), {});
  Observe(judge, 5.0, 15.0);
  Observe(judge, 6.0, -100.0);
  EXPECT_FALSE(judge.fatal());
  EXPECT_EQ(judge.flips(), 1);
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, 0, {}).outcome, Outcome::kTippedOver);
  Observe(judge, 30.0, 15.0);
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, 0, {}).outcome, Outcome::kTimeout);
  Observe(judge, 40.0, 170.0);  // from below it does not come, but round and round it does
  EXPECT_EQ(judge.flips(), 2);

  // An arm that was behind at the start did not go over.
  OutcomeJudge trailing(Station(), {});
  Observe(trailing, 0.0, 165.0);
  Observe(trailing, 1.0, 165.0);
  EXPECT_EQ(trailing.flips(), 0);
  EXPECT_EQ(trailing.Conclude(Verdict::kGivenUp, 2, {}).outcome, Outcome::kRecoveryLimit);
}

TEST(Outcome, GivingUpAtOnceIsNoRecoveryLimit) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(1.0, -1.5, 0.1, 20.0), 1.0);
  const auto gave_up = judge.Conclude(Verdict::kGivenUp, 0, {});
  EXPECT_EQ(gave_up.outcome, Outcome::kGaveUp);
  EXPECT_EQ(gave_up.note, "gave up without a recovery, tip 1500 mm before the mouth");
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, 1, {}).note,
            "gave up after 1 recovery, tip 1500 mm before the mouth");
}

TEST(Outcome, TipInTheConeIsSaidToBeBehindTheMouth) {
  OutcomeJudge judge(Station(), {});
  Hold(judge, At(50.0, 0.05, 0.02, 20.0), 1.0);
  EXPECT_EQ(judge.Conclude(Verdict::kUnderWay, 0, {}).note,
            "time ran out, tip 50 mm behind the mouth");
}

TEST(Outcome, AFalseClaimNamesTheLimitsThatItMissed) {
  const auto note = [](const Truth& truth, double seconds, const ShakeResult& shake) {
    Truth turned = truth;
    turned.X_DR.R = RotZ(kPi + Radians(5.3));
    OutcomeJudge judge(Station(), {});
    Hold(judge, turned, seconds);
    return judge.Conclude(Verdict::kDone, 0, shake).note;
  };
  const std::string yaw = ", heading 5.3 deg against the axis";
  EXPECT_EQ(note(At(50.0, 0.189, 0.01, 50.0), 2.0, {}),
            "claimed docked; entered depth 189 mm (at least 200 mm), seat depth 189 mm (at least "
            "265 mm)" +
                yaw);
  EXPECT_EQ(note(At(50.0, 0.27, 0.01, 3.0), 2.0, {}),
            "claimed docked; tension 3 N (at least 5 N)" + yaw);
  EXPECT_EQ(note(At(50.0, 0.27, 0.01, 50.0), 0.5, {}),
            "claimed docked; rest 0.5 s (at least 1 s)" + yaw);
  EXPECT_EQ(note(At(50.0, 0.27, 0.01, 50.0), 2.0, {true, Radians(6.0), 0.02, 0.27}),
            "claimed docked; shake turn 6 deg (at most 4.5 deg), shake travel 20 mm (at most 10 "
            "mm)" +
                yaw);
}

/// Those that are judged, by name.
std::map<std::string, double> MarginsOf(const OutcomeJudge& judge, const ShakeResult& shake) {
  std::map<std::string, double> margins;
  for (const JudgedLimit& limit : judge.Limits(shake)) {
    if (!std::isnan(limit.value)) margins[limit.name] = limit.margin();
  }
  return margins;
}

TEST(Outcome, AClaimSucceedsExactlyWhereAllMarginsArePositive) {
  StationModel station = Station();
  station.cone.rated_force_n = 1000.0;
  int successes = 0, failures = 0;
  for (const double depth_m : {0.26, 0.2704}) {
    for (const double tension_n : {3.0, 50.0}) {
      for (const double shift_m : {0.04, 0.06}) {
        for (const double force_n : {900.0, 1100.0}) {
          for (const double travel_m : {0.005, 0.02}) {
            OutcomeJudge judge(station, {});
            Truth truth = At(100.0, depth_m, 0.005, tension_n);
            truth.station_shift_m = shift_m;
            truth.cone_force_peak_n = force_n;
            Hold(judge, truth, 2.0);
            const ShakeResult shake{true, Radians(1.0), travel_m, depth_m};
            const auto margins = MarginsOf(judge, shake);
            const bool all = std::all_of(margins.begin(), margins.end(),
                                         [](const auto& each) { return each.second >= 0.0; });
            const Outcome outcome = judge.Conclude(Verdict::kDone, 0, shake).outcome;
            EXPECT_EQ(outcome == Outcome::kDocked, all) << Name(outcome);
            ++(all ? successes : failures);
          }
        }
      }
    }
  }
  EXPECT_EQ(successes, 1);
  EXPECT_EQ(failures, 31);
}

TEST(Outcome, TheLimitThatNamesAFailureIsBroken) {
  OutcomeJudge jammed(Station(), {});
  Hold(jammed, At(50.0, 0.15, 0.02, 200.0), 10.0);
  EXPECT_LT(MarginsOf(jammed, {}).at("jam_s"), 0.0);
  OutcomeJudge caught(Station(), {});
  Truth pressed = At(50.0, 0.0, 0.13, 90.0);
  pressed.face_force_n = 60.0;
  Hold(caught, pressed, 5.0);
  EXPECT_LT(MarginsOf(caught, {}).at("face_s"), 0.0);
  OutcomeJudge overload(Station(), {});
  Hold(overload, At(5.0, -2.0, 0.0, 1200.0), 0.3);
  EXPECT_LT(MarginsOf(overload, {}).at("overload_s"), 0.0);
  OutcomeJudge tipped(Station(), {});
  Truth on_end = At(5.0, -2.0, 0.0, 0.0);
  on_end.X_WR.R = RotX(Radians(70));
  tipped.Observe(on_end);
  EXPECT_NEAR(MarginsOf(tipped, {}).at("axle_tilt_deg"), -10.0, 1e-9);
  EXPECT_EQ(MarginsOf(tipped, {}).count("excursion_m"), 0u);  // none was asked for
}

TEST(Outcome, GivingUpInSightOfTheBoardIsTheRecoveryLimit) {
  OutcomeJudge judge(Station(), {});
  judge.ObserveSighting(20.0, SightingQuality::kGood);
  Hold(judge, At(50.0, -0.5, 0.1, 20.0), 1.0);
  EXPECT_EQ(judge.Conclude(Verdict::kGivenUp, 4, {}).outcome, Outcome::kRecoveryLimit);
}

TEST(Outcome, EveryOneHasANameOfItsOwnAndOneIsASuccess) {
  std::set<std::string> names;
  int successes = 0;
  for (const OutcomeName& outcome : OutcomeNames()) {
    EXPECT_TRUE(names.insert(outcome.name).second) << outcome.name;
    EXPECT_FALSE(outcome.meaning.empty());
    successes += outcome.success;
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(Outcome::kTimeout) + 1);
  EXPECT_EQ(successes, 1);
  EXPECT_STREQ(Name(Outcome::kDocked), "docked");
  EXPECT_STREQ(Name(Outcome::kFalseDocked), "false_docked");
  EXPECT_STREQ(Name(Outcome::kTimeout), "timeout");
}

class Sighting : public testing::Test {
 protected:
  Sighting() {
    rig_.left = rig_.right = EquidistantCamera(1024, 768, Radians(90.0));
    rig_.X_RL.R.col(0) = -Eigen::Vector3d::UnitY();
    rig_.X_RL.R.col(1) = -Eigen::Vector3d::UnitZ();
    rig_.X_RL.R.col(2) = Eigen::Vector3d::UnitX();
    rig_.X_RQ = rig_.X_RL;
    rig_.X_RQ.p.y() = -0.35;
    X_RB_.R = rig_.X_RL.R;
    X_RB_.p = {4.0, 0.0, 0.0};
    for (int i = 0; i < 8; ++i) {
      board_.fiducials.push_back({.p_BF = {0.1 * (i - 4), i % 2 ? 0.15 : -0.15}});
    }
  }

  /// A report in which mark i of the left camera lies on fiducial (i + shift) mod 8.
  SightingReport Report(int count, int shift, bool accepted) const {
    SightingReport report;
    report.accepted = accepted;
    report.detected = {count, 0};
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector2d p = board_.fiducials[(i + shift) % 8].p_BF;
      const auto pixel =
          rig_.left.Project(Inverse(rig_.X_RL) * X_RB_ * Eigen::Vector3d(p.x(), p.y(), 0.0));
      report.marks.push_back({i, false, pixel->x() + 0.5, pixel->y()});
    }
    return report;
  }

  SightingQuality Judge(const SightingReport& report) const {
    return JudgeSighting(report, X_RB_, rig_, board_, {});
  }

  StereoRig rig_;
  FiducialBoard board_;
  Pose3 X_RB_;
};

TEST_F(Sighting, IsGoodWhenAcceptedOnTheRightFiducials) {
  EXPECT_EQ(Judge(Report(6, 0, true)), SightingQuality::kGood);
}
TEST_F(Sighting, IsWrongWhenPixelsCarryOtherIds) {
  EXPECT_EQ(Judge(Report(6, 1, true)), SightingQuality::kWrongCorrespondence);
  EXPECT_EQ(Judge(Report(6, 1, false)), SightingQuality::kWrongCorrespondence);
}
TEST_F(Sighting, IsBlindBelowFourFiducials) {
  EXPECT_EQ(Judge(Report(3, 0, false)), SightingQuality::kUndetected);
}
TEST_F(Sighting, IsARejectionWhenEnoughWereFound) {
  EXPECT_EQ(Judge(Report(5, 0, false)), SightingQuality::kRejected);
}

}  // namespace
}  // namespace dockyard::axel
