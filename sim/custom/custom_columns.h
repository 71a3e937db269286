// The numbers of a run: each is stated once, with its name, unit, meaning and value.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/custom/truth.h"
#include "sim/log/visited_columns.h"

namespace dockyard::custom {

/// Of the first electrical contact, or none.
inline ContactTruth FirstContact(const Truth& t) {
  return t.contacts.empty() ? ContactTruth{} : t.contacts.front();
}

/// Calls visit(name, unit, meaning, value) for each channel of the history.
template <class Visit>
void VisitChannels(const Truth& t, Visit&& visit) {
  const ContactTruth contact = FirstContact(t);
  const RollPitchYaw turn = ToRollPitchYaw(t.X_QP.R);
  double current_a = 0.0, slip = 0.0;
  for (const MotorTruth& motor : t.motors) current_a = std::max(current_a, motor.current_a);
  for (const double each : t.wheel_slip) slip = std::abs(each) > std::abs(slip) ? each : slip;
  visit("off_x_m", "m", "the robot's frame in the dock's, along x of that", t.X_QP.p.x());
  visit("off_y_m", "m", "the same along y", t.X_QP.p.y());
  visit("off_z_m", "m", "the same along z", t.X_QP.p.z());
  visit("off_yaw_deg", "deg", "the same turned about z", Degrees(turn.yaw));
  visit("speed_m_s", "m/s", "of the robot's root", t.speed_m_s);
  visit("touch_n", "N", "between robot and dock, normal forces summed, pins included", t.touch_n);
  visit("contact_n", "N", "of the contact's pins, summed", contact.force_n);
  visit("contact_v", "V", "of the contact, at the robot", contact.voltage_v);
  visit("pin_offset_m", "m", "the worst pin's tip from its pad's middle, along the pad",
        contact.offset_m);
  visit("dock_moved_m", "m", "the dock from where it was at the start", t.dock_moved_m);
  visit("dock_turned_deg", "deg", "the same turned", Degrees(t.dock_turned_rad));
  visit("tilt_deg", "deg", "of the robot from upright", Degrees(t.tilt_rad));
  visit("wheel_slip", "", "of the wheel that slips most, 1 spinning on the spot", slip);
  visit("most_current_a", "A", "largest of all motors", current_a);
}

struct CustomMeasures {
  double pin_offset_m = 0.0, contact_force_n = 0.0, contact_voltage_v = 0.0;
  double off_x_m = 0.0, off_y_m = 0.0, off_yaw_deg = 0.0;
  double peak_touch_n = 0.0, dock_moved_m = 0.0, driven_m = 0.0, retries = 0.0;
};

/// Calls visit(name, unit, meaning, headline, value) for each measure of the result row.
template <class Visit>
void VisitMeasures(const CustomMeasures& m, Visit&& visit) {
  visit("pin_offset_m", "m", "the worst pin's tip from its pad's middle, along the pad, at the end",
        true, m.pin_offset_m);
  visit("contact_force_n", "N", "of the contact's pins, summed, at the end", true,
        m.contact_force_n);
  visit("contact_voltage_v", "V", "of the contact, at the robot, at the end", false,
        m.contact_voltage_v);
  visit("off_x_m", "m", "the robot's frame in the dock's at the end, along x of that", false,
        m.off_x_m);
  visit("off_y_m", "m", "the same along y", true, m.off_y_m);
  visit("off_yaw_deg", "deg", "the same turned about z", true, m.off_yaw_deg);
  visit("peak_touch_n", "N", "most force between robot and dock", false, m.peak_touch_n);
  visit("dock_moved_m", "m", "the dock from where it was at the start", false, m.dock_moved_m);
  visit("driven_m", "m", "path of the robot's root", false, m.driven_m);
  visit("retries", "", "new approaches after a first one", true, m.retries);
}

std::vector<Column> Measures();  // and the limits' margins
/// Names of the values that the controllers' beliefs may hold.
std::vector<Column> Beliefs();

}  // namespace dockyard::custom
