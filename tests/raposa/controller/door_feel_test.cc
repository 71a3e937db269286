#include "controller/raposa/door_feel.h"

#include <gtest/gtest.h>

#include "controller/raposa/lean.h"
#include "raposa/controller/drawn_marks.h"

namespace dockyard::raposa {
namespace {

/// Doors that close at 6 mm/s from 20 mm until they stop, drawing one current on the way and one at
/// the end.
DoorState AfterClosing(double left_stop_m, double right_stop_m, double end_a) {
  const Nominal nominal = TestNominal();
  DoorFeel doors(nominal, {});
  doors.Begin();
  for (int i = 0; i < 70; ++i) {
    SensorFrame frame;
    frame.tick = 100 * i;
    frame.motors.resize(kMotorCount);
    const double stops[2] = {left_stop_m, right_stop_m};
    for (std::size_t side = 0; side < 2; ++side) {
      const double opening_m = std::max(stops[side], 0.02 - 0.006 * 0.1 * i);
      const std::size_t motor = 3 + side;
      frame.motors[motor].encoder_counts =
          std::llround((nominal.door_travel_m - opening_m) / nominal.door_pinion_radius_m /
                       nominal.motors[motor].rad_per_count);
      frame.motors[motor].current_a = opening_m > stops[side] ? 0.2 : end_a;
    }
    doors.Read(frame);
  }
  return doors.state();
}

TEST(DoorFeel, TellsAGuideFromNoneAndFromOneThatIsNotIn) {
  EXPECT_EQ(AfterClosing(0.0039, 0.0039, 0.86), DoorState::kHeld);
  EXPECT_EQ(AfterClosing(0.0, 0.0, 0.1), DoorState::kEmpty);
  EXPECT_EQ(AfterClosing(0.012, 0.012, 0.86), DoorState::kPinched);
  EXPECT_EQ(AfterClosing(0.004, 0.012, 0.86), DoorState::kPinched);
  // Nearly shut, pressing on each other; or stuck without pressing.
  EXPECT_EQ(AfterClosing(0.0003, 0.0003, 0.86), DoorState::kEmpty);
  EXPECT_EQ(AfterClosing(0.0039, 0.0039, 0.1), DoorState::kEmpty);
}

// The reference's table: arm pressed by 10, 15, 20 deg.
TEST(Lean, FollowsFromTheRollersThatTouch) {
  const Nominal nominal = TestNominal();
  for (const auto& [arm_deg, lean_deg] :
       {std::pair{10.0, 3.2}, std::pair{15.0, 4.8}, std::pair{20.0, 6.3}}) {
    const double arm = Radians(arm_deg), lean = LeanOf(nominal, arm);
    EXPECT_NEAR(Degrees(lean), lean_deg, 0.05);
    EXPECT_NEAR(0.386 * std::sin(lean), 0.18 * std::sin(arm - lean), 1e-12);
  }
  EXPECT_EQ(LeanOf(nominal, -0.3), 0.0);
}

}  // namespace
}  // namespace dockyard::raposa
