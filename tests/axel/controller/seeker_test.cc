// The search along the tether, on a plane: the tip goes where the tether pulls it, and the arm with
// the freely rolling axle behind it.
#include "controller/axel/seeker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard::axel {
namespace {

const SearchOptions kOptions{};
constexpr double kArm_m = 1.0;
// A pull that turns it by less than still_turn_rad leaves the tether this far aside at the most,
// less the sweep: the tip goes 0.6 m along the tether, 1 m before the axle.
constexpr double kStillMost_rad = Radians(5.0);

/// Station at the origin.
class Plane {
 public:
  Plane(double r_m, double off_rad) : x_(-r_m), heading_(off_rad) {}

  double off_rad() const { return WrapPi(std::atan2(-y_, -x_) - heading_); }  // of the station
  double tether_rad() const {
    const double tip_x = x_ + kArm_m * std::cos(heading_);
    const double tip_y = y_ + kArm_m * std::sin(heading_);
    return WrapPi(std::atan2(-tip_y, -tip_x) - heading_);
  }
  double tip_m() const {
    return std::hypot(x_ + kArm_m * std::cos(heading_), y_ + kArm_m * std::sin(heading_));
  }
  double range_m() const { return std::hypot(x_, y_); }
  SeekerPlace here() const { return {WrapPi(heading_ + 1.0), reeled_m_, rolled_m_}; }

  void Pull() {
    const double before = heading_, rolled_before = rolled_m_;
    for (double way = 0.0; way < kOptions.reel_m; way += kStep_m) {
      if (rolled_m_ - rolled_before <= -kOptions.backwards_m) return;
      if (tip_m() < 0.05) return;  // in the cone
      const double tether = tether_rad();
      Roll(std::cos(tether) * kStep_m);
      heading_ += std::sin(tether) * kStep_m / kArm_m;
      reeled_m_ += kStep_m;
      if (std::abs(heading_ - before) >= kOptions.pull_turn_rad) return;
    }
  }
  void Turn(double amount_rad) { heading_ += amount_rad; }
  void Roll(double way_m) {
    x_ += way_m * std::cos(heading_);
    y_ += way_m * std::sin(heading_);
    rolled_m_ += way_m;
  }
  void PayOut(double way_m) { reeled_m_ -= way_m; }

 private:
  static constexpr double kStep_m = 0.01;
  double x_ = 0.0, y_ = 0.0, heading_ = 0.0, reeled_m_ = 0.0, rolled_m_ = 0.0;
};

struct Found {
  bool found = false;
  std::vector<SearchAction> moves;
  // Of the tether to the arm, its sine, while the wheels turn the rover with the tip 1.5 m or more
  // before the mouth.
  double abeam = 0.0;
  double nearest_m = 1e9;
};

// Half the lens's view less its margin and half the board.
Found Seek(Plane plane, double sees_rad = Radians(38.0), double sees_m = 7.0) {
  Seeker seeker(kOptions);
  Found run;
  const auto abeam = [&] {
    if (plane.tip_m() > 1.5)
      run.abeam = std::max(run.abeam, std::abs(std::sin(plane.tether_rad())));
  };
  for (int i = 0; i < 200; ++i) {
    run.found = std::abs(plane.off_rad()) < sees_rad && plane.range_m() < sees_m;
    run.nearest_m = std::min(run.nearest_m, plane.range_m());
    if (run.found) return run;
    const auto action = seeker.Next(plane.here());
    if (!action) return run;
    run.moves.push_back(*action);
    if (action->move == SearchMove::kReel) plane.Pull();
    if (action->move == SearchMove::kReverse) plane.Roll(-action->amount);
    if (action->move == SearchMove::kReverse) plane.PayOut(action->amount);
    if (action->move != SearchMove::kTurn) continue;
    abeam();
    plane.Turn(action->amount);
    abeam();
  }
  ADD_FAILURE() << "no end";
  return run;
}

class Anywhere : public testing::TestWithParam<std::tuple<double, int>> {};

TEST_P(Anywhere, FacesTheStationWithoutTurningByItsWheels) {
  const auto [r_m, off_deg] = GetParam();
  const Found run = Seek(Plane(r_m, Radians(off_deg)));
  EXPECT_TRUE(run.found);
  EXPECT_LE(run.abeam, std::sin(kOptions.tether_rad + kStillMost_rad));
  EXPECT_LE(run.moves.size(), 16u);
}

INSTANTIATE_TEST_SUITE_P(Starts, Anywhere,
                         testing::Combine(testing::Values(1.5, 2.5, 4.0, 6.0, 8.0),
                                          testing::Range(-180, 181, 12)));

TEST(Seeker, LooksAgainFirst) { EXPECT_EQ(Seeker(kOptions).Next({})->move, SearchMove::kAgain); }

// From each place to all sides of the tether, and never where it has just looked.
TEST(Seeker, EndsAtTheStationWithoutABoard) {
  for (const int off_deg : {-150, -40, 0, 40, 150}) {
    const Found run = Seek(Plane(8.0, Radians(off_deg)), -1.0);
    EXPECT_FALSE(run.found);
    EXPECT_LT(run.nearest_m, kArm_m + 0.1);
    EXPECT_LE(run.moves.size(), 60u);
    EXPECT_LE(run.abeam, std::sin(kOptions.tether_rad + kStillMost_rad));
  }
}

TEST(Seeker, ComesNearerToABoardThatIsTooFarToBeSeen) {
  const Found run = Seek(Plane(8.0, 0.0), Radians(38.0), 5.0);
  EXPECT_TRUE(run.found);
  EXPECT_GT(run.nearest_m, 4.3);
}

TEST(Seeker, MirroredStartsGiveMirroredMoves) {
  for (const double off_deg : {20.0, 95.0, 160.0}) {
    const Found a = Seek(Plane(7.0, Radians(off_deg)), Radians(38.0), 3.0);
    const Found b = Seek(Plane(7.0, Radians(-off_deg)), Radians(38.0), 3.0);
    ASSERT_EQ(a.moves.size(), b.moves.size());
    for (std::size_t i = 0; i < a.moves.size(); ++i) {
      ASSERT_EQ(a.moves[i].move, b.moves[i].move);
      const bool turn = a.moves[i].move == SearchMove::kTurn;
      ASSERT_NEAR(a.moves[i].amount, turn ? -b.moves[i].amount : b.moves[i].amount, 1e-9);
    }
  }
}

TEST(Seeker, ReversesFromTheStationBeforeItGivesUp) {
  const Found run = Seek(Plane(1.5, 0.0), -1.0);
  const auto reversals = std::count_if(run.moves.begin(), run.moves.end(), [](const auto& action) {
    return action.move == SearchMove::kReverse;
  });
  EXPECT_EQ(reversals, kOptions.stuck_pulls);
}

// The tip may just have come into the cone, where a turn would push the station.
TEST(Seeker, BacksOffBeforeItTurnsWithItsArmRaised) {
  for (const double elevation_deg : {-12.0, 3.5}) {
    Seeker seeker(kOptions);
    seeker.Next({});
    ASSERT_EQ(seeker.Next({})->move, SearchMove::kReel);
    const SeekerPlace nearer{0.0, 0.6, 0.6, Radians(elevation_deg)};
    const bool raised = elevation_deg > 0.0;
    EXPECT_EQ(seeker.Next(nearer)->move, raised ? SearchMove::kReverse : SearchMove::kTilt);
  }
}

TEST(JudgePull, TellsWhichWayTheTetherLeads) {
  const SeekerPlace before{.yaw_rad = 3.1, .reeled_m = 1.0, .rolled_m = -2.0};
  const auto after = [&](double turn, double reel, double roll) {
    return JudgePull(
        before, {WrapPi(before.yaw_rad + turn), before.reeled_m + reel, before.rolled_m + roll},
        kOptions);
  };
  EXPECT_EQ(after(0.5, 0.6, 0.3), PullResult::kTurned);
  EXPECT_EQ(after(-0.5, 0.6, -0.3), PullResult::kTurned);
  EXPECT_EQ(after(0.02, 0.6, 0.6), PullResult::kAligned);
  EXPECT_EQ(after(0.02, 0.3, -0.3), PullResult::kBackwards);
  EXPECT_EQ(after(0.02, 0.4, 0.4), PullResult::kStuck);
}

}  // namespace
}  // namespace dockyard::axel
