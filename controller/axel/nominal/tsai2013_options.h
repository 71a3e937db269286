// Every number of the controller of Tsai, Nesnas and Zarzhitsky (2013) in one place. The paper
// gives few: those are cited. The others were chosen from its parts, none from a rate of success.
// most_turn_rad, and the second image pair at contact, were chosen after drives and dockings that
// had gone wrong; docs/reference/axel2013.md says how. Keys of a scenario under axel.tsai2013.
#pragma once

#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

struct Tsai2013Options {
  // Regions by the axle's distance r from the mouth (Tsai et al., Fig. 7, without numbers). Beyond
  // align_r_m is the approach, whose S ends on the axis at this border: at 2 m the pose errs by 4
  // cm (V-E), and from 4 m at 15 deg, the typical start (Fig. 10), an S of wide arcs leads there.
  // Assumed, range 1.8-3.0 m.
  double align_r_m = 2.0;
  // Arm's tip before the mouth at the end of the S of the alignment: as much as an S of the
  // sharpest arcs needs to take out the 6 cm by which the one before it lands aside. Within
  // mate_r_m, a landing error of 0.3 m (V-B) beyond that end, is the mating. Assumed, ranges
  // 0.3-0.6 and 1.4-2.0.
  double mate_gap_m = 0.50, mate_r_m = 1.8;
  double recover_r_m = 2.4;  // axle on the axis at the recovery goal (V-B); assumed, 2.0-3.0

  // The last sighting must agree with this before the wheels are freed.
  double heading_rad = Radians(5.0);  // V-B
  // Of the tip at the mouth: mouth of 0.12 m less the tip's 3 cm less what vision errs by at 1 m.
  // Assumed, 0.05-0.09.
  double tip_offset_m = 0.07;
  // Contact "based on a depth estimate" (II): a tip tip_offset_m beside the axis meets the funnel
  // this deep (funnel of 0.12 m from 0.12 to 0.032 m of radius). The drive of the mating ends
  // there; a sighting within contact_within_m of it counts as contact, as the estimate errs by 2.6
  // cm at 1 m (V-E). Assumed, ranges 0-0.06 and 0.01-0.05.
  double contact_depth_m = 0.026, contact_within_m = 0.03;
  double reel_in_m = 0.25;  // II

  // Two arcs by least way and turning (IV-A): what a radian costs in metres, and the sharpest arc.
  double turn_cost_m = 0.6;     // assumed, 0.3-1.5
  double least_radius_m = 1.0;  // assumed, 0.7-2
  // No arc turns further, "to keep the docking station within the camera's FOV" of 90 deg (IV-A): a
  // goal beside the rover has only pairs of whole circles. Assumed, 60-120.
  double most_turn_rad = Radians(90.0);
  int splits = 96;  // of the family of pairs that are compared

  // Speeds of the axle's middle. A docking from 4 m at 15 deg takes 200 s (Fig. 10): set by that
  // run alone. Assumed, ranges 0.02-0.10 and 0.01-0.05.
  double drive_m_s = 0.046, mate_m_s = 0.02;
  double reel_m_s = 0.03;           // assumed, 0.02-0.05
  double wheel_accel_rad_s2 = 0.1;  // of the trapezoids (V-F); assumed, 0.05-0.5
  // Standing, the spool takes up slack until its current tells this tension: "we relied on the
  // noisier motor current measurements to infer tether tension" (IV-A). Assumed, 30-60.
  double taut_n = 45.0, tighten_m_s = 0.05;
  Tick settle = 1'000;     // the body swings about its axle; assumed, 0.5-2 s
  Tick still_after = 500;  // nothing taken up for so long is taut
  Tick tighten_limit = 60'000;
  // A drive that is held back ends its arc this late at most, then the next thing is done.
  double patience = 1.5;
  Tick lag = 1'000;
  // Images in a row without a pose before it gives up: the paper's rover had no search. Assumed,
  // 1-10.
  int blind_looks = 3;
  double look_pitch_rad = Radians(8.0);  // the body is levelled before a look; assumed, 5-15
  Tick level_limit = 5'000;

  bool operator==(const Tsai2013Options&) const = default;
};

}  // namespace dockyard::axel
