// The numbers of RAPOSA's runs: each stands here once, with its name, unit, meaning and value.
#pragma once

#include <cmath>
#include <vector>

#include "sim/log/visited_columns.h"
#include "sim/raposa/world.h"

namespace dockyard::raposa {

/// Calls visit(name, unit, meaning, value) for each channel of the history.
template <class Visit>
void VisitChannels(const Truth& t, Visit&& visit) {
  const auto motor = [&](Motor m) { return t.motors[static_cast<std::size_t>(m)]; };
  visit("range_m", "m", "camera to guide, in plan", t.range_m);
  visit("alpha_deg", "deg", "the camera's place about the pyramid's axis", Degrees(t.alpha_rad));
  visit("seat_x_m", "m", "guide's middle from its seat, out of the socket positive", -t.p_SP_R.x());
  visit("seat_y_m", "m", "the same, to the robot's left", t.p_SP_R.y());
  visit("seat_z_m", "m", "the same, up", t.p_SP_R.z());
  visit("pitch_deg", "deg", "of the body, front down positive",
        -Degrees(std::asin(t.X_WR.R(2, 0))));
  visit("arm_deg", "deg", "arm against body, tip down positive", Degrees(t.arm_rad));
  visit("left_door_m", "m", "left door from closed", t.left_door_m);
  visit("right_door_m", "m", "right door from closed", t.right_door_m);
  visit("contact_n", "N", "sum of the forces between robot and pyramid", t.contact_n);
  visit("pyramid_shift_m", "m", "the guide from where it stood at the start", t.pyramid_shift_m);
  visit("pyramid_turn_deg", "deg", "the pyramid's heading from that at the start",
        Degrees(t.pyramid_turn_rad));
  visit("pyramid_tilt_deg", "deg", "the pyramid from upright", Degrees(t.pyramid_tilt_rad));
  visit("cable_n", "N", "pull of the cable on the pyramid", t.cable_pull_n);
  visit("left_belt_rad_s", "rad/s", "of the left sprocket", motor(Motor::kLeftBelt).speed_rad_s);
  visit("right_belt_rad_s", "rad/s", "of the right sprocket", motor(Motor::kRightBelt).speed_rad_s);
  visit("left_current_a", "A", "of the left belt's motor", motor(Motor::kLeftBelt).current_a);
  visit("right_current_a", "A", "of the right belt's motor", motor(Motor::kRightBelt).current_a);
  visit("door_current_a", "A", "of both doors' motors together",
        motor(Motor::kLeftDoor).current_a + motor(Motor::kRightDoor).current_a);
  visit("yaw_deg", "deg", "heading against the pyramid's axis as at the start, 0: as it docks",
        Degrees(ToGround(t.X_DR_start).heading));
}

struct RaposaMeasures {
  double passes = 0.0;
  double range_m = 0.0, alpha_deg = 0.0, seat_m = 0.0;
  double shift_before_doors_m = 0.0, turn_before_doors_deg = 0.0;
  double contact_peak_n = 0.0, belt_current_peak_a = 0.0;
};

/// Calls visit(name, unit, meaning, headline, value) for each measure of the result row.
template <class Visit>
void VisitMeasures(const RaposaMeasures& m, Visit&& visit) {
  visit("passes", "", "times that the controller manoeuvred to the pyramid's axis", true, m.passes);
  visit("range_m", "m", "camera to guide in plan, at the end", false, m.range_m);
  visit("alpha_deg", "deg", "the camera's place about the pyramid's axis, at the end", false,
        m.alpha_deg);
  visit("seat_m", "m", "guide's middle from its seat, at the end", true, m.seat_m);
  visit("shift_before_doors_m", "m", "furthest that the pyramid was moved before the doors closed",
        false, m.shift_before_doors_m);
  visit("turn_before_doors_deg", "deg",
        "furthest that the pyramid was turned before the doors closed", false,
        m.turn_before_doors_deg);
  visit("contact_peak_n", "N", "largest sum of the forces between robot and pyramid", false,
        m.contact_peak_n);
  visit("belt_current_peak_a", "A", "largest current of a belt's motor", false,
        m.belt_current_peak_a);
}

std::vector<Column> Measures();  // and the limits' margins
/// Names of the values that the controllers' beliefs may hold.
std::vector<Column> Beliefs();

}  // namespace dockyard::raposa
