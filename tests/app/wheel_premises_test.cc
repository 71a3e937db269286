#include "sim/app/wheel_premises.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/program.h"
#include "controller/geometry/pose.h"
#include "sim/base/json.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> WarningsOf(double sinkage_m, double slip = 0.2, double side_deg = 0.0,
                                    bool steady = true) {
  SingleWheelSetup setup;
  setup.wheel.rim_radius_m = 0.09;
  setup.wheel.paddle_count = 12;
  setup.wheel.paddle_height_m = 0.01;
  setup.slip = slip;
  setup.side_slip_rad = Radians(side_deg);
  SingleWheelResult result;
  result.sinkage_m = sinkage_m;
  result.steady = steady;
  EXPECT_EQ(IsBuried(setup.wheel, result), sinkage_m >= 0.1);
  return BrokenPremises(setup, result);
}

TEST(BrokenPremises, AreNoneWhereWheelsWereMeasured) {
  EXPECT_THAT(WarningsOf(0.063), IsEmpty());
  EXPECT_THAT(WarningsOf(0.01, -0.8), IsEmpty());
  EXPECT_THAT(WarningsOf(0.01, 0.8, 45.0), IsEmpty());
}

TEST(BrokenPremises, NameTheDepthTheSlipAndTheSideSlip) {
  EXPECT_THAT(WarningsOf(0.07), ElementsAre(HasSubstr("sinks by 0.70 of its radius")));
  EXPECT_THAT(WarningsOf(0.01, 0.9), ElementsAre(HasSubstr("slip 0.9")));
  EXPECT_THAT(WarningsOf(0.01, -1.0), ElementsAre(HasSubstr("slip -1")));
  EXPECT_THAT(WarningsOf(0.01, 0.2, 60.0), ElementsAre(HasSubstr("side slip of 60 deg")));
}

TEST(BrokenPremises, SayThatAWheelIsBuriedAndHowDeep) {
  EXPECT_THAT(WarningsOf(0.3), ElementsAre(HasSubstr("its axle is 0.2 m below the ground")));
}

TEST(BrokenPremises, SayThatAWheelWasStillChanging) {
  EXPECT_THAT(WarningsOf(0.063, 0.2, 0.0, false),
              ElementsAre(HasSubstr("still changing at the end of its path")));
}

TEST(WheelCommand, BelievesNoBuriedWheel) {
  const Ended ended = Dockyard(
      "wheel --wheel models/wheels/pavlov_smooth.yaml --soil models/soils/pavlov_90.yaml "
      "--slip 0.2 --load 24,5000 --sweep --json");
  EXPECT_EQ(ended.code, 10);
  EXPECT_THAT(ended.err, HasSubstr("warning: load 5000 N"));
  const Json rows = Json::parse(ended.out);
  EXPECT_EQ(rows[0]["steady"], true);
  EXPECT_EQ(rows[0]["warnings"].size(), 0u);
  EXPECT_EQ(rows[1]["steady"], false);
  EXPECT_EQ(rows[1]["warnings"].size(), 1u);
}

}  // namespace
}  // namespace dockyard
