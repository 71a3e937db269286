// Every number of the controller of Tsai, Nesnas and Zarzhitsky (2013) in one place. The paper
// gives few: those are cited. The others were chosen from its parts, none from a rate of success.
#pragma once

#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

struct Tsai2013Options {
  // Regions by the axle's distance r from the mouth (Tsai et al., Fig. 7, without numbers). Beyond
  // align_r_m is the approach, within mate_r_m the mating. The S of the approach ends on the axis
  // at the border of the alignment. Assumed, ranges 2.0-3.0 and 1.2-1.6 m.
  double align_r_m = 2.4, mate_r_m = 1.35;
  // Arm's tip before the mouth at the end of the S of the alignment: the board is still within the
  // lens there. Assumed, range 0.2-0.5.
  double mate_gap_m = 0.30;
  double recover_r_m = 2.4;  // axle on the axis at the recovery goal (V-B); assumed, 2.0-3.0

  // The last sighting must agree with this before the wheels are freed.
  double heading_rad = Radians(5.0);  // V-B
  // Of the tip at the mouth: the mouth's radius less the tip's. Assumed, 0.06-0.09.
  double tip_offset_m = 0.07;
  double contact_depth_m = 0.0;  // contact with the cone, by depth estimate; assumed, -0.02 to 0.05
  double reel_in_m = 0.25;       // II

  // Two arcs by least way and turning (IV-A): what a radian costs in metres, and the sharpest arc.
  double turn_cost_m = 0.6;     // assumed, 0.3-1.5
  double least_radius_m = 1.0;  // assumed, 0.7-2
  int splits = 96;              // of the family of pairs that are compared

  // Speeds of the axle's middle. A docking from 4 m at 15 deg takes 200 s (Fig. 10): set by that
  // run alone. Assumed, ranges 0.02-0.10 and 0.01-0.05.
  double drive_m_s = 0.03, mate_m_s = 0.02;
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
};

}  // namespace dockyard::axel
