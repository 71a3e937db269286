// The numbers of Rocky 7's runs: each stands here once, with its name, unit, meaning and value.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/log/visited_columns.h"
#include "sim/rocky7/world.h"

namespace dockyard::rocky7 {

/// Calls visit(name, unit, meaning, value) for each channel of the history.
template <class Visit>
void VisitChannels(const Truth& t, Visit&& visit) {
  double wheel_current_a = 0.0;
  for (const MotorTruth& motor : t.motors) {
    wheel_current_a = std::max(wheel_current_a, motor.current_a);
  }
  visit("point_x_m", "m",
        "the point to be brought to the target, in its frame; of a placement the instrument's face",
        t.p_GP.x());
  visit("point_y_m", "m", "the same, to the left", t.p_GP.y());
  visit("point_off_m", "m", "the point from the target's middle, in plan", t.p_GP.head<2>().norm());
  visit("target_rise_m", "m", "the target over where it was at the start", t.target_rise_m);
  visit("pitch_deg", "deg", "of the body, front down positive",
        -Degrees(std::asin(t.X_WR.R(2, 0))));
  visit("roll_deg", "deg", "of the body, right side down positive",
        Degrees(std::atan2(t.X_WR.R(2, 1), t.X_WR.R(2, 2))));
  visit("speed_m_s", "m/s", "of the body", t.v_WR_W.norm());
  visit("sinkage_m", "m", "mean of the wheels, below the ground as it was", t.sinkage_m);
  visit("stone_force_n", "N", "on stones in the ground, normal forces summed", t.stone_force_n);
  visit("face_force_n", "N", "on the instrument's face, normal forces summed", t.face_n);
  visit("most_current_a", "A", "largest of all motors", wheel_current_a);
  visit("yaw_deg", "deg", "heading against the axis of the target's frame, 0: towards it",
        Degrees(WrapPi(t.X_GR.heading - kPi)));
}

struct Rocky7Measures {
  double point_off_m = 0.0;  // at the end
  // Of the last sighting, and the largest of all; NaN without one.
  double estimate_off_m = std::nan(""), worst_estimate_m = std::nan("");
  double wrong_sightings = 0.0;
  double loss = std::nan("");  // as Loss; NaN without an image pair
  double looks = 0.0, driven_m = 0.0, grasps = 0.0, rise_m = 0.0;
  // Of a placement; NaN for other tasks, tilt and force without a contact, too.
  double touched = std::nan(""), tilt_deg = std::nan(""), face_force_n = std::nan("");
};

/// Calls visit(name, unit, meaning, headline, value) for each measure of the result row.
template <class Visit>
void VisitMeasures(const Rocky7Measures& m, Visit&& visit) {
  visit("point_off_m", "m",
        "the point from the target's middle, at the end; the instrument's face at its contact",
        true, m.point_off_m);
  visit("estimate_off_m", "m", "the target as detected last, from its middle", true,
        m.estimate_off_m);
  visit("worst_estimate_m", "m", "largest distance of an estimate from the target's middle", false,
        m.worst_estimate_m);
  visit("wrong_sightings", "", "estimates further from the target's middle than its width", false,
        m.wrong_sightings);
  visit("loss", "",
        "cause of a target that was lost and not found again: 1 field of view, 2 range data, 3 "
        "several targets, 4 odometry, 5 colour; 0 none",
        false, m.loss);
  visit("looks", "", "pairs of pictures", true, m.looks);
  visit("grasps", "", "times that the scoops were closed", false, m.grasps);
  visit("rise_m", "m", "the target over where it was, at the end", false, m.rise_m);
  visit("touched", "", "1: the instrument touched the boulder, wherever", false, m.touched);
  visit("tilt_deg", "deg", "at its contact, the instrument off the rock's normal", true,
        m.tilt_deg);
  visit("face_force_n", "N", "most that pressed on the instrument's face", false, m.face_force_n);
  visit("driven_m", "m", "way of the body", false, m.driven_m);
}

std::vector<Column> Measures();  // and the limits' margins
/// Names of the values that the controllers' beliefs may hold.
std::vector<Column> Beliefs();

}  // namespace dockyard::rocky7
