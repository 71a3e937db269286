// Every branch of the choice among the seven states (F, C.3).
#include "controller/raposa/state_choice.h"

#include <gtest/gtest.h>

#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard::raposa {
namespace {

constexpr FerreiraMotion kRegions;

StateCues PairAt(double alpha_deg, double r_m) {
  return {.pair = StateCues::Pair{Radians(alpha_deg), r_m}, .orange_m = r_m, .blue = true};
}
StateCues OrangeCue(double r_m, bool blue = false) {
  return {.pair = {}, .orange_m = r_m, .blue = blue};
}

TEST(StateChoice, EveryBranch) {
  struct Row {
    const char* what;
    StateCues cues;
    State state;
  };
  const std::vector<Row> rows{
      {"on the axis", PairAt(0, 2.0), State::kApproach},
      {"within 15 deg", PairAt(14.9, 2.0), State::kApproach},
      {"beyond 15 deg", PairAt(15.1, 2.0), State::kAlign},
      {"beyond 15 deg, other side", PairAt(-15.1, 2.0), State::kAlign},
      {"the tolerance's distances", PairAt(19.9, 0.8), State::kApproach},
      {"the tolerance's own end", PairAt(20.1, 0.8), State::kAlign},
      {"just nearer than the tolerance", PairAt(17.0, 0.49), State::kAlign},
      {"just farther than the tolerance", PairAt(17.0, 1.21), State::kAlign},
      {"dead zone at any angle", PairAt(60, 0.33), State::kApproach},
      {"beyond the dead zone", PairAt(60, 0.35), State::kAlign},
      {"point 14 does not manoeuvre", PairAt(0, 2.0), State::kApproach},
      {"pair at the end", PairAt(0, 0.29), State::kFinal},
      {"pair aside, at the end", PairAt(60, 0.29), State::kFinal},
      {"pair far away", PairAt(0, 2.5), State::kApproach},
      {"orange at middle distance", OrangeCue(1.0), State::kApproach},
      {"orange and a blue thing that fits not", OrangeCue(1.0, true), State::kApproach},
      {"orange far", OrangeCue(2.01), State::kOrangeFar},
      {"orange not far", OrangeCue(1.99), State::kApproach},
      {"orange near", OrangeCue(0.29), State::kFinal},
      {"blue alone", {.pair = {}, .orange_m = {}, .blue = true}, State::kBlueOnly},
      {"nothing", {}, State::kNothing},
  };
  for (const Row& row : rows) EXPECT_EQ(ChooseState(row.cues, kRegions), row.state) << row.what;
}

// Both distances are the camera's, so both move with the marks' sizes.
TEST(StateChoice, TheDeadZoneIsADistanceOfTheMarks) {
  MarksSeen seen;
  seen.pair = MarkPair{};
  seen.pair->alpha_rad = Radians(60.0);
  seen.pair->angle.r_m = 0.33;
  seen.orange = OrangeMark{.ellipse = {}, .area_px2 = 900.0, .distance_m = 0.33};
  EXPECT_EQ(ChooseState(CuesOf(seen), kRegions), State::kApproach);
  seen.pair->angle.r_m = 0.50;
  EXPECT_EQ(ChooseState(CuesOf(seen), kRegions), State::kAlign);
}

}  // namespace
}  // namespace dockyard::raposa
