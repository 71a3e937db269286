// How RAPOSA's own controller drives. Its eye has no setting.
#pragma once

#include "controller/geometry/pose.h"

namespace dockyard::raposa {

/// Distances along the pyramid's axis are of the robot's origin, x in D; a docked one stands
/// at the seat's, 0.30 m.
struct DockyardOptions {
  // What the belts may do. 1 sigma; the filter learns the values on the way.
  double gauge_sigma = 0.08;     // share of the told gauge; assumed, 0.05-0.15: floor, grass
  double centre_sigma_m = 0.02;  // of the turning centre along x; assumed, 0.01-0.04
  double centre_m = -0.01;       // it lies there in R; -0.04 to 0.02 by the belts' closed form
  double belt_bias_m_s = 0.003;  // of a driven belt's reading; assumed, 0.002-0.01
  double bias_time_s = 120.0;    // in which it wanders; assumed, 60-300
  double scale_sigma = 0.015;  // of all ranges in pictures: focal length, marks; assumed, 0.01-0.03
  double way_noise = 0.01;     // share of the way; assumed, 0.005-0.03
  double side_noise = 0.02;    // sideways, of the way; assumed, 0.01-0.05
  double turn_noise = 0.03;    // share of a turn; assumed, 0.01-0.05
  // An arm that turns rolls its belts one way and leans the body the other way. The robot goes with
  // either, as the floor holds: share of the belts' way; assumed, 0.1-0.4.
  double arm_noise = 0.25;
  double pressed_gauge_share = 1.96;  // gauge with the arm pressed down, by level: 1.13 / 0.577
  double leaning_rad = Radians(1.0);  // arm's angle from which its tip bears; assumed, 0.5-2 deg

  // The way to the axis.
  double gate_m = 0.85;               // it turns onto the axis here ...
  double far_gate_m = 1.05;           // ... to here, whichever is sooner; assumed, 0.6-1.2
  double keep_out_m = 0.46;           // of a straight way from the guide: half the robot's width
                                      // 0.25, half the pyramid's 0.08, margin; assumed, 0.40-0.55
  double round_m = 0.80;              // of waypoints round the pyramid; assumed, 0.7-1.0
  double turn_room_m = 0.52;          // of a turn in place: the rear corners reach 0.41 m
  double travel_m_s = 0.25;           // assumed, 0.1-0.4
  double turn_rad_s = Radians(40.0);  // with the guide out of view; assumed, 20-60
  double seen_turn_rad_s = Radians(12.0);    // in view, for 1.6 px of blur; assumed, 8-20
  double least_turn_rad_s = Radians(4.5);    // belts at 0.023 m/s: above any dead band of 0.02
  double turn_gain_per_s = 2.5;              // of a turn's last part; assumed, 1-4
  double turn_tolerance_rad = Radians(1.5);  // assumed, 1-3
  double way_tolerance_m = 0.015;            // assumed, 0.01-0.03

  // From where it drives straight in: within a cone about the axis. The guide must stay in view on
  // the way, so it can move aside by 4 cm at most. Assumed: 0.40-0.45 m, 8-20 mm, 0.06-0.15,
  // 0.05-0.15 m, 8-11 deg.
  double cone_from_m = 0.42, cone_half_m = 0.012, cone_slope = 0.07, cone_turn_m = 0.1;
  double cone_heading_rad = Radians(11.0);  // less than half the view of 12.5
  double settle_m = 0.08;             // an offset dies out over three of it; assumed, 0.06-0.12
  double blind_settle_m = 0.05;       // where no view needs to be kept any more; assumed, 0.04-0.08
  double approach_m_s = 0.25;         // far from the seat; assumed, 0.1-0.4 ...
  double approach_gain_per_s = 0.45;  // ... in proportion to the way left; assumed, 0.3-0.7 ...
  // ... down to this: belts are off by 0.003 m/s, so slower is farther off; 0.04-0.12. At the end
  // it is slower: a control period's way is what it cannot stop within; assumed, 10-30 mm,
  // 0.03-0.06.
  double least_approach_m_s = 0.09;
  double end_m = 0.02, end_m_s = 0.045;
  double blind_m = 0.18;  // in camera range; nearer the hole's rim cuts the guide in half, and it
                          // drives in by its belts; assumed, 0.14-0.2
  double press_m = 0.68;  // the arm is pressed down from here; assumed, 0.6-0.75
  // Leans the body back by 2.5 deg. The seat then lets in guides from 14 mm lower to 5 mm higher
  // than told; of 14 deg, to 2 mm higher alone (docs/raposa.md, Socket). 6-12 deg.
  double press_rad = Radians(8.0);
  double press_other_rad = Radians(4.0);  // less, then more, at each further try: the seat's height
                                          // changes by 2 mm; assumed, 2-5 deg
  double low_within_m = 0.75;  // from there a guide may be below the view; assumed, 0.4-0.8
  double look_low_rad = Radians(14.0);  // to see a guide that is low in the view; assumed, 10-18
  double short_m = 0.003;  // it stops before the seat: doors pull the guide in from 8 mm; 0-6 mm
  double lamps_m = 0.6;    // they are on nearer, in camera range; assumed, 0.4-1
  double phase_s = 100.0;  // of any phase; the longest, a search, takes 96; assumed, 98-120
  int passes = 12;         // ways to the axis, then it gives up; assumed, 6-20
  double lost_s = 1.0;     // without the guide it stops; assumed, 0.5-2

  // Looking and searching.
  int agreeing_images = 3;  // that agree on one pose, or on none, before it decides; assumed, 2-6
  double sure_heading_rad = Radians(9.0);  // 1 sigma to decide on; assumed, 5-12
  double patience_s = 0.9;  // standing, for a picture with what it needs; assumed, 0.5-2
  // Of that, until it presses the arm to see a guide that is low in its view; assumed, 0.3-0.6.
  double glance_s = 0.4;
  // The eye's prior is wider than the filter's: models of belts and paint are not exact.
  double prior_share = 2.0;         // of the sigmas; assumed, 1.5-4
  double prior_m = 0.03;            // added; assumed, 0.02-0.06
  double prior_rad = Radians(5.0);  // assumed, 3-8
  double first_patience_s = 2.5;    // the same, before it has seen the guide at all; assumed, 1-4
  double creep_m_s = 0.15;          // towards a guide without marks; assumed, 0.05-0.2
  double creep_to_m = 0.62;  // in camera range: strips show to 110 deg from there; assumed, 0.5-0.8
  double far_m = 2.0;        // beyond it a guide shows in some pictures alone; assumed, 1.5-2.5
  double unseen_way_m = 1.0;         // towards such a guide without seeing it; assumed, 0.5-1.5
  double glance_rad = Radians(8.0);  // so far aside it puts a guide whose square may be out of
                                     // view; less than the view's 12.5 and the guide's radius; 6-9
  double glance_most_s = 2.5;        // for each side; assumed, 2-4
  double back_m = 0.25;              // away from a guide too near for its marks; assumed, 0.15-0.4
  double back_share = 0.6;  // backwards at this share of the forward speeds; assumed, 0.4-0.8
  int straight_backs = 1;   // from one guide; then it goes round it; assumed, 1-3 ...
  double round_rad = Radians(60.0);  // ... by this at a time, seen from the guide; 45-75 ...
  int backs = 7;                     // ... until it has been all round: 360 / 60, and one back
  double across_m = 0.15;  // across the line of sight while two poses are likely; assumed, 0.1-0.25
  int acrosses = 2;        // such moves; then it decides on the likelier; assumed, 1-3
  double believed_from_m = 0.35;  // in camera range a believed guide must show; assumed, 0.3-0.5
  double refuted_m = 0.12;        // about a thing that is no guide; assumed, 0.08-0.2 ...
  double refuted_share = 0.08;    // ... and so much of its range; assumed, 0.05-0.15
  double most_search_rad = 7.0 * kPi;   // from the last place; assumed, 3-4 turns
  double search_rad_s = Radians(15.0);  // assumed, 8-25
  // Doubled at each switch: 26, 52, 104, 208, 416 deg. The last one goes all round with belts that
  // make 0.8 of their turns; assumed, 24-40.
  double first_search_rad = Radians(26.0);

  // Doors. Openings are of each door from closed.
  double brake_s = 0.3;        // assumed, 0.2-0.6
  double shut_m = 0.0010;      // nothing lies between doors this near; assumed, 0.5-2 mm
  double held_share = 0.5;     // of the guide's radius: doors that stall nearer hold the rear cone;
                               // wider, the guide's widest part is between them; assumed, 0.45-0.7
  double stall_m = 0.0004;     // a door that goes no farther, assumed 0.2-1 mm ...
  double stall_s = 0.5;        // ... in this time rests; assumed, 0.3-1
  double stall_a = 0.35;       // of a door's motor that presses; free it takes 0.2, at most 1.3
  double close_s = 7.0;        // in which doors have closed or never will: they take 5
  double ajar_past_m = 0.003;  // beyond the guide's radius, for it to pass; assumed, 1-7 mm
  double nudge_m = 0.008;      // on, where doors pinch the guide's widest part; assumed, 5-12 mm
  // On, where they close on nothing: they push a guide that is not between them yet to 28 mm before
  // its seat; 20-27.
  double blind_nudge_m = 0.024;
  double prove_m = 0.03;        // it pulls that far before it claims; assumed, 20-50 mm
  double prove_m_s = 0.04;      // assumed, 0.02-0.08
  int nudges = 3;               // before it backs off; assumed, 2-4
  double retreat_m = 0.85;      // to there on the axis; assumed, 0.7-1.1
  double most_retreat_m = 0.7;  // or so far, where the axis is not known; assumed, 0.5-1
  int attempts = 8;             // then it gives up; assumed, 4-12
};

}  // namespace dockyard::raposa
