// What Ferreira and Ventura, Autonomous docking of a tracked wheels robot to its tether cable using
// a vision-based algorithm, leave open or set by hand. "F" with a section is that paper.
#pragma once

#include <array>
#include <vector>

#include "controller/geometry/hsv_band.h"

namespace dockyard::raposa {

using dockyard::HsvBand;

/// The user's hand on the thresholds "in real time" (F, C.3), written down beforehand.
struct BandChange {
  double at_s = 0.0;  // since power-on
  HsvBand orange, blue;

  bool operator==(const BandChange&) const = default;
};

/// Which pairs of an ellipse and a rectangle can be the pyramid's. The paper gives the criteria and
/// no threshold but the ball.
struct FerreiraVision {
  // The medians of what `dockyard tune` writes from images at 1.33 m and 30 deg of ten rooms
  // (docs/raposa.md). A user tunes them to the light (F, C.3).
  HsvBand orange{.hue_from = 8, .hue_to = 18, .saturation_from = 65, .value_from = 60};
  HsvBand blue{.hue_from = 105, .hue_to = 116, .saturation_from = 57, .value_from = 55};
  double least_area_px2 = 53.0;    // of either blob, in its band; calibrated, 2.5 and 3.0 m: 53-60
  double least_axis_ratio = 0.5;   // of the ellipse; assumed, 0.4-0.7
  double most_deviation = 0.35;    // of width and height from the distance's; assumed, 0.25-0.5
  double tight_deviation = 0.20;   // when several pairs are left; assumed, 0.1-0.25
  double most_area_factor = 2.5;   // of the areas' ratio; assumed, 2-4
  double tight_area_factor = 1.7;  // assumed, 1.3-2
  double ball_px = 20.0;           // F, C.3: "20 pixels (configurable)"
  int lost_frames = 10;            // then the ball is open, and a visual turn ends; assumed, 5-20
  // Of the ellipse at 1 m, from the paper's "offline reference image" (F, D); 0: of a disc of the
  // guide's diameter.
  double area_at_one_m_px2 = 0.0;
  std::vector<BandChange> band_changes{};  // in the order of their times

  bool operator==(const FerreiraVision&) const = default;
};

/// Where the bands are looked for in a picture, and how wide they are taken. Hues in half degrees.
/// All assumed; the marks' hues hardly move with the light, their saturation does.
struct FerreiraTuning {
  int orange_from = 2, orange_to = 26;  // middles of hue windows; 0-5, 20-30
  int blue_from = 95, blue_to = 130;    // 90-100, 125-135
  int window_hue = 14;                  // their width; 10-20
  std::array<int, 7> least_saturations{30, 50, 80, 110, 140, 170, 200};
  std::array<int, 3> least_values{20, 40, 80};
  double outside_share = 0.05;     // of a mark's pixels at either end; 0.02-0.1
  int hue_margin = 3;              // added to either end; 2-6
  double saturation_share = 0.85;  // of the mark's least; 0.7-0.95
  double value_share = 0.6;        // of the mark's least, for shade; 0.4-0.8
  int least_pixels = 12;

  bool operator==(const FerreiraTuning&) const = default;
};

/// Speeds, regions and tolerances. Calibrated ones are those that a fit to Table I's points 2, 14,
/// 8 and 10 gives; nothing else of the table was used.
struct FerreiraMotion {
  double region_one_rad = 0.261799;   // 15 deg (F, C.3)
  double tolerance_rad = 0.349066;    // 20 deg in place of it ...
  double tolerance_from_m = 0.5;      // ... from here ...
  double tolerance_to_m = 1.2;        // ... to here; assumed, within 0.4-1.5 m
  double dead_zone_m = 0.34;          // F, C.3
  double orange_far_m = 2.0;          // state 3 beyond; assumed, 1.5-2.3
  double final_m = 0.30;              // state 6 below (F, D)
  double slow_below_m = 1.0;          // the speed falls with the distance below (F, D)
  double k_linear_per_s = 0.082;      // calibrated, points 2 and 14: 0.070-0.087
  double k_angular_rad_s_px = 0.002;  // assumed, 0.001-0.004
  double k_arm_rad_px = 0.002;        // assumed, 0.001-0.004
  double final_speed_m_s = 0.0235;    // state 6, what state 1 has at 0.30 m
  // From 0.30 m to the claim Table I leaves 18.1 s (points 2 and 14: 16.3-19.9): state 6, a stop,
  // and the doors. At its speed 10.6 s lead from 0.30 m onto the seat. Belts that both run slow by
  // two sigma of what the robot's file says of their readings, 14 %, take 12.3 s.
  double final_s = 12.3;  // of state 6; calibrated with the rest, 7.7-12.5
  double settle_s = 0.6;  // stop before the doors; assumed, 0.3-2
  double doors_s = 5.2;   // until the doors are taken for closed; they take 5.1; calibrated, 5.2-8
  double close_s = 5.0;   // in which the doors are to close; assumed, 3-8
  bool steer_final = true;   // state 6 turns to the ellipse; F, D has one turning rate for region I
  double standoff_m = 0.6;   // delta of Fig. 3; assumed, 0.5-0.8
  double travel_m_s = 0.09;  // state 2; calibrated, points 8 and 10: 0.065-0.12
  // 24 deg/s, by odometry; calibrated, points 8 and 10: with the visual turn before, the slowing
  // down and the stop after it, the mean is their 9.6 deg/s. 12-26
  double turn_rad_s = 0.418879;
  double visual_turn_rad_s = 0.0698;   // 4 deg/s, state 7; assumed, 2-5
  double search_turn_rad_s = 0.0698;   // assumed, 2-5 deg/s
  double first_search_rad = 0.349066;  // 20 deg, doubled at each switch; assumed, 10-45
  double most_search_rad = 6.108652;   // 350 deg: "lower than 360" (F, D)
  double turn_tolerance_rad = 0.0349;  // 2 deg; assumed, 1-4
  double way_tolerance_m = 0.02;       // assumed, 0.01-0.05
  double turn_gain_per_s = 2.0;        // of the last part of a turn by odometry; assumed, 1-4
  double way_gain_per_s = 1.0;         // of the inverse controller; assumed, 0.5-2
  double lead_m = 0.2;                 // of the point that it controls; assumed, 0.1-0.4
  double look_s = 0.5;                 // stop after state 2; assumed, 0.3-1
  double creep_m_s = 0.04;             // state 3; assumed, 0.02-0.08
  double blue_sweep = 0.6;             // of the half view, state 4; assumed, 0.4-0.8
  double doubt_s = 10.0;               // of state 4 in a row, then it is left; assumed, 5-30
  double arm_below_m = 0.45;           // "the end of state 1" (F, D); assumed, 0.35-0.6
  double level_arm_rad = 0.0;          // arm "at a constant position" otherwise; assumed, +-0.1
  double least_arm_rad = 0.0;          // assumed, -0.576-0: raising it lifts the back
  double most_arm_rad = 0.349066;      // 20 deg, the successor's; assumed, 15-30 deg

  bool operator==(const FerreiraMotion&) const = default;
};

}  // namespace dockyard::raposa
