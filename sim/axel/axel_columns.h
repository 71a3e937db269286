// The numbers of Axel's runs: each stands here once, with its name, unit, meaning and value.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "controller/geometry/axle_attitude.h"
#include "sim/axel/outcome.h"
#include "sim/axel/world.h"
#include "sim/log/visited_columns.h"

namespace dockyard::axel {

/// Calls visit(name, unit, meaning, value) for each channel of the history.
template <class Visit>
void VisitChannels(const Truth& truth, Visit&& visit) {
  const AxleAttitude axle = ToAxleAttitude(truth.X_WR.R);
  const auto current = [&](Motor motor) { return truth.motor_current_a[static_cast<int>(motor)]; };
  visit("roll_deg", "deg", "of the axle against the level", Degrees(axle.roll));
  visit("pitch_deg", "deg", "of the body about the axle, nose-down positive, 180: upside down",
        Degrees(axle.pitch));
  visit("arm_deg", "deg", "arm against body, tip-down positive", Degrees(truth.arm_rad));
  visit("tip_depth_m", "m", "arm tip behind the plane of the cone's mouth", -truth.p_MT.x());
  visit("tip_lateral_m", "m", "arm tip off the cone's axis",
        std::hypot(truth.p_MT.y(), truth.p_MT.z()));
  visit("tension_n", "N", "of the tether at the arm's tip", truth.tether_tension_n);
  visit("cone_force_n", "N", "sum of the contact forces of cone and face on the arm",
        truth.cone_force_n);
  visit("station_shift_m", "m",
        "mouth from where it stood at the start, horizontal, up to the judge's shake",
        truth.station_shift_m);
  visit("left_current_a", "A", "of the left wheel's motor", current(Motor::kLeftWheel));
  visit("right_current_a", "A", "of the right wheel's motor", current(Motor::kRightWheel));
  visit("spool_current_a", "A", "of the spool's motor", current(Motor::kSpool));
  visit("rock_force_n", "N", "sum of the rocks' contact forces on the rover", truth.rock_force_n);
  visit("left_sinkage_m", "m", "of the left wheel in the soil", truth.left_sinkage_m);
  visit("right_sinkage_m", "m", "of the right wheel in the soil", truth.right_sinkage_m);
  visit("yaw_deg", "deg", "heading against the dock's axis, 0: as it docks",
        Degrees(WrapPi(AxleOnGround(truth.X_DR).heading - kPi)));
  visit("station_shake_m", "m", "mouth from where it stood before the judge's shake",
        truth.station_shake_m);
}

/// The measures of a result row. NaN: does not apply.
struct AxelMeasures {
  double recoveries = 0.0, rightings = 0.0, flips = 0.0;
  double tip_depth_m = 0.0, lateral_error_m = 0.0, yaw_error_deg = 0.0, station_shift_m = 0.0;
  double station_sunk_m = 0.0;
  double cone_force_peak_n = 0.0, tension_peak_n = 0.0;
  double spool_current_mean_a = 0.0, spool_current_peak_a = 0.0;
  double wheel_current_mean_a = 0.0, wheel_current_peak_a = 0.0;
  double arm_up_peak_deg = 0.0, roll_rms_deg = 0.0;
  double entry_current_mean_a = std::nan(""), entry_current_peak_a = std::nan("");
  double entry_force_peak_n = std::nan("");
  double advance_m = 0.0, turned_deg = 0.0, farthest_m = 0.0;
  double pairs_lost = 0.0;
  double rock_force_peak_n = 0.0;
  double station_shake_m = std::nan("");
};

/// Calls visit(name, unit, meaning, headline, value) for each measure of the result row.
template <class Visit>
void VisitMeasures(const AxelMeasures& m, Visit&& visit) {
  const std::string entry =
      " from the mouth to " + NumberText(OutcomeLimits{}.entered_depth_m) + " m deep";
  visit("recoveries", "", "times that the controller backed up to try again", true, m.recoveries);
  visit("rightings", "", "times that the controller turned body and arm back", false, m.rightings);
  visit("flips", "", "times that the arm went from ahead of the axle to behind it", false, m.flips);
  visit("tip_depth_m", "m", "arm tip behind the plane of the cone's mouth, at the end", true,
        m.tip_depth_m);
  visit("lateral_error_m", "m", "arm tip off the cone's axis, at the end", false,
        m.lateral_error_m);
  visit("yaw_error_deg", "deg", "body's heading against the cone's axis, at the end", false,
        m.yaw_error_deg);
  visit("station_shift_m", "m", "mouth from where it stood at the start, before the shake", false,
        m.station_shift_m);
  visit("station_sunk_m", "m", "deepest foot of the station in the soil, 0 for hard feet", false,
        m.station_sunk_m);
  visit("cone_force_peak_n", "N", "largest contact force of cone and face on the arm", false,
        m.cone_force_peak_n);
  visit("tension_peak_n", "N", "largest tension of the tether at the arm's tip", false,
        m.tension_peak_n);
  visit("spool_current_mean_a", "A", "of the spool's motor while it draws any", false,
        m.spool_current_mean_a);
  visit("spool_current_peak_a", "A", "of the spool's motor", false, m.spool_current_peak_a);
  visit("wheel_current_mean_a", "A", "of both wheels' motors while they draw any", false,
        m.wheel_current_mean_a);
  visit("wheel_current_peak_a", "A", "of both wheels' motors", false, m.wheel_current_peak_a);
  visit("arm_up_peak_deg", "deg", "highest lift of the arm above the level", false,
        m.arm_up_peak_deg);
  visit("roll_rms_deg", "deg", "of the body, over the whole run", false, m.roll_rms_deg);
  visit("entry_current_mean_a", "A", "of the spool's motor" + entry, false, m.entry_current_mean_a);
  visit("entry_current_peak_a", "A", "of the spool's motor" + entry, false, m.entry_current_peak_a);
  visit("entry_force_peak_n", "N", "of the cone on the arm" + entry, false, m.entry_force_peak_n);
  visit("advance_m", "m", "way from start to end along the first heading", false, m.advance_m);
  visit("turned_deg", "deg", "heading at the end against that at the start", false, m.turned_deg);
  visit("farthest_m", "m", "largest distance of the axle from where it started", false,
        m.farthest_m);
  visit("pairs_lost", "", "image pairs asked for and lost on their way", false, m.pairs_lost);
  visit("rock_force_peak_n", "N",
        "largest sum of the rocks' contact forces on the rover, 0 if it touched none", false,
        m.rock_force_peak_n);
  visit("station_shake_m", "m",
        "farthest that the shake drew the mouth from where it stood before; nan without a shake",
        false, m.station_shake_m);
}

std::vector<Column> Measures();  // and the limits' margins
/// Names of the values that the controllers' beliefs may hold.
std::vector<Column> Beliefs();

}  // namespace dockyard::axel
