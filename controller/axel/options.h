// Every number of the docking behaviour in one place, each with its reason. SI and radians.
#pragma once

#include "controller/axel/drive.h"
#include "controller/axel/pose_filter.h"
#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard::axel {

struct TetherOptions {
  // One set point for loose and compact soil: slack lifts the arm below about rho W = 40 N on loose
  // soil, arcs fall short above 60 N (m = 40 kg). Assumed, range 35-60.
  double drive_tension_n = 47.0;
  // Of a tether from the side, and the angles against the arm between which it falls to that: at
  // 60 deg 47 N make the rover slip sideways by a quarter of its way on compact soil and take all
  // of the wheels' turning (simulated). Assumed, 15-35 N, 10-30 deg and 40-60 deg.
  double aside_tension_n = 25.0;
  double ahead_rad = Radians(20.0), aside_rad = Radians(50.0);
  // Reversing drags the tether out; 20-30 N costs a tenth of the way on loose soil. Range 5-30.
  double reverse_tension_n = 22.0;
  // The winch runs this much faster than the cosine law asks, to take up slack: a wheel that rolls
  // off a paddle goes at up to 0.25 m/s, and with a slack tether the arm falls on the cone (700 to
  // 1 000 N with 0.02 m/s, simulated). Assumed, 0.04-0.1.
  double catch_up_m_s = 0.06;
  double tighten_m_s = 0.05;  // reeling slack at rest; assumed, 0.03-0.10
  double reel_m_s = 0.03;     // into the cone: slow, against jamming; assumed, 0.02-0.05
  // Paddles peak at W tan(pi/n) = 105 N. Straightening the arm at its collar's lead-in takes the
  // spool's full pull, which the socket's floor bears. Assumed, 200-300.
  double reel_tension_n = 300.0;
  // Rolls free wheels on either soil: 88 N loose, 105 N over a paddle. The station's feet slip at
  // 137 N, less on a slope. Range 106-130.
  double search_tension_n = 120.0;
  // Where the spool stalls, the wheels help it over the paddle first, with that thrust: 5 deg of
  // slope leave the station 95 N. Assumed, 70-95 N, 40-80 N, 0.2-1 s and 0.5-2 s.
  double first_tension_n = 85.0, nudge_thrust_n = 60.0;
  Tick nudge_after = 400, nudge_time = 1'000;
  double helped_m = 0.02;     // taken up at least, where either helped; assumed, 0.01-0.05
  double accel_rad_s2 = 2.0;  // of the drum; reaches 0.05 m/s in half a second; assumed, 1-5
  // Still: less than this taken up for that long. 2 mm at 0.05 m/s is 0.04 s of running.
  double still_m = 0.002;
  Tick taut_after = 500;
  Tick tighten_limit = 60'000;  // 3 m of slack; more means a torn tether
  // Counts as taut while driving from this share of the set tension, low-passed over 0.3 s.
  double taut_share = 0.5;
  double current_smoothing_s = 0.3;
  Tick tether_fix_period = 400;  // corrections nearer in time repeat the same error
};

/// Of the station on its soles.
struct HoldOptions {
  // Tolerances of station.yaml.
  double friction_share = 0.2, weight_share = 0.05;
  // The built spool pulls more than its set point: its torque per ampere is within 10 %, a wheel
  // that rolls off a paddle adds some, and its no-load current within 30 %, or 10 N. 58 to 66 N
  // were measured at 47 N, 110 N at 85 N. Assumed, 1.1-1.3 and 5-15 N.
  double over_share = 1.15, over_n = 10.0;
  double least_pull_n = 25.0;  // it keeps the tether taut; assumed, 20-40
  // A pull that drags the station is weaker by this factor from then on. Assumed, 0.5-0.8.
  double weaker = 0.6;
};

/// Of a pull that drags the station.
struct SlideOptions {
  // Tether taken up beyond what the tip can have come nearer, and a share of all that was taken up:
  // a drum is built to 5 %. Before the pull has stalled once, what lay loose and what the tether
  // stretches is taken up, too, and the rover is dragged by some centimetres before its wheels
  // roll. Assumed, 1-4 cm, 6-12 cm and 0.05-0.1.
  double beyond_m = 0.02, beyond_at_first_m = 0.10, share = 0.06;
};

/// Of wheels that roll without getting on.
struct DigOptions {
  // The tether's length must change by this much, by the wheels, before it is compared: 5 s at 0.05
  // m/s. Assumed, 0.15-0.4 m.
  double rolled_m = 0.25;
  // By FilterNoise::slip, 5 deg uphill on compact soil against 40 N of tether leave 0.57. Assumed,
  // 0.15-0.4.
  double least_share = 0.25;
  // Out of the hole it drives ahead so far, by the drum, wheels and spool together. Assumed,
  // 0.2-0.5 m and 8-20 s.
  double out_m = 0.35;
  Tick out_limit = 12'000;
};

struct DriveOptions {
  double approach_m_s = 0.05;       // Axel-class test speed; assumed, 0.03-0.10
  double mate_m_s = 0.03;           // "speed is reduced" (Tsai et al., IV); assumed, 0.02-0.05
  double reverse_m_s = 0.05;        // assumed, 0.03-0.10
  double turn_rad_s = 0.08;         // turning in place; assumed, 0.05-0.15
  double wheel_accel_rad_s2 = 0.3;  // 0.05 m/s in 0.6 s; assumed, 0.1-1
  Steering steering{};              // far from the cone
  // Of the tip, on the last 0.4 m: the way over which its offset dies out. Assumed, 0.1-0.3 m and
  // 0.05-0.15 rad/s.
  Steering fine_steering{.settle_m = 0.15, .max_turn_rad_s = 0.10};
  // Of the turning that slip takes, so much is made up for: 45 N from the side take 0.04 rad/s at
  // 0.05 m/s on compact soil (simulated). Assumed, 0.05-0.12.
  double yaw_slip_rad_s = 0.08;
  // More than that for so long is a wheel that spins. Both wheels turn alike then, for 0.3 m of
  // way. Assumed, 1-4 s and 4-12 s.
  Tick spin_after = 2'000, lock_for = 6'000;
  // Arm lifting: slack tether, no progress, at 48-62 deg over the top. Stop early. Range 20-25 deg.
  double arm_guard_rad = Radians(22.0);
  double arm_resume_rad = Radians(10.0);
  Tick guard_limit = 8'000;  // then drive on in any case; assumed, 4-15 s
  double patience = 2.5;     // times the nominal duration before a leg is called short
  Tick stop_time = 600;      // wheels run down before the brake; speed over acceleration
};

struct ArmOptions {
  double level_gain_per_s = 0.5;           // slow against the arm's own swing (1-2 s); 0.2-1
  double level_rate_rad_s = Radians(6.0);  // assumed, 3-10
  double dead_band_rad = Radians(0.5);     // of the inertial pitch's noise; assumed, 0.2-1
  double limit_rad = Radians(60.0);        // arm against body
  // Over a rock the body goes nose-down: its middle is 4 cm behind and 2 cm below the axle, so that
  // its underside rises by 2.4 cm. Assumed, 20-40 deg.
  double over_rock_rad = Radians(30.0);
  double speed_rad_s = Radians(10.0), accel_rad_s2 = 1.0;  // of the drive's profile; assumed
  // At rest, a body pitched by more than this is levelled before an image pair is taken. The lens
  // covers +-37 deg up and down, so only large angles matter. Assumed, range 5-15 deg.
  double look_pitch_rad = Radians(8.0);
  Tick level_limit = 5'000;
  double level_roll_m = 0.15;  // free wheels that roll further roll downhill; assumed, 0.1-0.3
};

struct LookOptions {
  Tick settle = 800;         // body swings about the axle for about a second; assumed
  Tick image_limit = 1'000;  // then a missing image pair is asked for again ...
  // ... with twice the patience, as cameras may be slow: 1, 2, 4, ... s. After this many asks in a
  // row without an answer there is no camera to dock by. Assumed, 5-8 (31 s to 4 min).
  int unanswered_asks = 6;
  int contradictions = 2;  // this many agreeing sightings against dead reckoning drop it
  double max_range_m = 12.0, min_range_m = 0.4;  // discs of 10 cm are 6 px at 12 m, f 700 px
  double view_margin_rad = Radians(3.0);  // edge marks are the first to be lost (V-D); 0-5 deg
  // Share of the board's half width that must be in view: five of eight marks. Assumed, 0.3-1.
  double board_share = 0.6;
};

/// Pictures under way (VisionSettings::while_driving).
struct MovingOptions {
  // A pair is asked for so often, and near a leg's end if the last is not fresh, but never sooner
  // than soonest after another. Assumed, 2-6 s and 0.5-2 s.
  Tick period = 4'000, soonest = 1'000;
  double end_m = 0.15;   // left of the leg near its end: 3 s; assumed, 0.1-0.3
  double blur_px = 0.7;  // expected blur, above which no picture is taken; assumed, 0.5-1
  Tick oldest = 3'000;   // a picture that comes later is dropped; assumed, 2-5 s
  Tick fresh = 4'000;    // a sighting so new saves the stop; assumed, 2-5 s
  int unanswered = 3;    // asks in a row, then none for this leg; assumed, 2-4
};

/// When one exposure does not hold the board: areas without a mark's contrast lie where it may be.
/// How many stops the bracket has, the nominal parameters say (VisionSettings). All assumed.
struct BracketOptions {
  // Areas: squares of this share of the picture's width or, on a board whose place is known, of its
  // width, so that no square lies within one black disc. 1/128-1/32 and 1/8-1/4.
  double square_share = 1.0 / 64.0, board_square_share = 1.0 / 6.0;
  // Too dark: not this share of the square reaches this number. White there is then so dim that
  // black is noise; the locator searches from 10 on. 0.01-0.05 and 12-24.
  double bright_share = 0.02;
  int dim = 16;
  // Too bright: this share of the square is saturated. 0.3-0.7 and 245-254.
  double saturated_share = 0.5;
  int saturated = 250;
  // This share of the squares where the board should be, or of the whole picture if nothing is
  // known of its place. 0.1-0.3, and 0.02-0.1: a board at 5 m takes 0.01 of it.
  double share_at_board = 0.15, share_of_picture = 0.03;
  double margin = 0.25;  // about the board where it should be, in its own sizes; 0.1-0.5
};

struct PlanOptions {
  // Arm tip before the mouth at the alignment goal: board still within the lens with +-27 deg.
  double align_gap_m = 0.45;
  double near_axis_m = 0.4;  // a tip farther aside has not come to the goal yet; assumed, 0.3-0.6
  double align_tolerance_m = 0.12;  // counts as arrived; 3 % of a leg's slip and 2.5 cm of vision
  // The goal of a rest that does not reach it: a hand's breadth nearer, and then with the axle
  // aside, the tip in the middle. The socket takes 7 cm of it; assumed, 0.03-0.06.
  double near_gap_m = 0.20, near_aside_m = 0.05;
  double recover_gap_m = 1.20;  // axle at 2.2 m: room for +-0.3 m of offset; assumed, 1.0-2.0
  double recover_step_m = 0.3;  // each recovery goes farther back than the last; assumed, 0.2-1
  double max_curvature = 0.9;   // [1/m] of a new plan; assumed, 0.5-1
  double hold_curvature = 1.2;  // of its rest; tighter arcs only skid on loose soil; 1-1.5
  double last_curvature = 1.5;  // of a rest that would otherwise have to back off; 1.2-2
  double max_recover_curvature = 1.5;
  // Pairs of arcs that are tried, by even splits of their chords: forwards, and behind each
  // back-off.
  int splits = 48, back_splits = 24;
  double turn_cost_m = 0.6;   // a radian of turning in metres of way; assumed, 0.3-1.5
  double reverse_cost = 1.4;  // a metre backwards in metres; assumed, 1-2
  double unseen_cost = 0.35;  // added to a metre with the board out of view; assumed, 0-1
  // Tether against arm in plan. Above 45 deg on loose soil, the rover turns only at tensions up to
  // 70 N.
  double tether_angle_rad = Radians(45.0);
  double tether_angle_cost = 1.0;  // a metre at one radian more, in metres
  // Nearly never a tether from farther aside: from there its pull takes what the wheels turn on
  // compact soil (simulated). Each back-off of the run asks for less, down to the least, so that
  // the plan which failed is not tried again. Assumed, 60-80, 5-15 and 25-40 deg; 20-100 m.
  double abeam_rad = Radians(65.0), abeam_step_rad = Radians(10.0), least_abeam_rad = Radians(30.0);
  double abeam_cost = 20.0;
  // And so much more from that much farther aside, where rovers tip over. Assumed, 10-20 deg and
  // 100-500 m.
  double far_abeam_rad = Radians(13.0), far_abeam_cost = 200.0;
  // Nearly never a thrust that may lift the arm, over the weight: the arm's weight less the body's
  // behind the axle bears 0.085. Uphill with the tether aside, on 4.5 deg of compact soil, 50 to 90
  // % of the way was driven with the arm up (simulated). Assumed, 0.03-0.08, 50-300 m and
  // 0.03-0.12.
  double lift_share = 0.05, lift_cost = 150.0, rolling_share = 0.05;
  // A rest of a plan that costs this more than its length is compared with back-offs; assumed,
  // 3-10 m.
  double rest_beyond_m = 5.0;
  double back_step_m = 0.5, back_limit_m = 3.5;
  int back_turns = 3;  // curvatures of a back-off, per side
  // Headings about the station's direction into which a back-off may turn first. Assumed, 3-8 to
  // each side and 5-15 deg.
  int back_headings = 5;
  double back_heading_rad = Radians(10.0);
  double max_range_m = 5.5;                 // marks are made for 5 m (Tsai et al., III-A)
  double min_tip_gap_m = 0.15;              // no part of a plan brings the tip nearer than this
  double leg_min_m = 0.7, leg_max_m = 1.4;  // then a new image pair; about a quarter of 4 m
  double leg_turn_rad = Radians(25.0);
  double leg_error_m = 0.05;  // belief off to a side at a leg's end, in one of ten; 0.03-0.1
  double leg_stretch = 1.6;   // a leg whose rest would be lost by that is longer; assumed, 1-2
  // While driving: an offset or a heading that would be left at the plan's end makes a new plan, if
  // it lasts, not sooner than after this way on the old one. Assumed, 0.02-0.05 m, 2-5 deg, 0.3-1
  // m.
  double anew_offset_m = 0.03, anew_heading_rad = Radians(3.0), anew_way_m = 0.4;
  Tick anew_after = 1'000;
  double held_share = 0.25;           // a leg that makes less of its way was held; assumed, 0.1-0.4
  double align_range_m = 2.6;         // alignment region inside, approach region outside
  double facing_rad = Radians(20.0);  // the axle's roll is the dock's cross slope; assumed, 10-30
};

/// Of rocks that the rover was told of.
struct RockLimits {
  // A wheel rolls over lower rocks, as from a start on 8 cm (docs/results). The paddled wheel is
  // said to climb far higher ones, but it turns the rover as it does.
  double wheel_climbs_m = 0.10;  // assumed, 0.06-0.15
  // The body passes over lower rocks: its underside is 0.118 m high, less the 5 cm that wheels sink
  // into loose sand. A body on a rock leaves the wheel beside it without a load, which then spins.
  double body_clears_m = 0.07;  // assumed, 0.06-0.12
  // Half the body's length, and the way in which it goes nose-down. Assumed, 0.2-0.5.
  double half_body_m = 0.35;
  // The arm slides over lower rocks. Its root is on the axle, 0.30 m high.
  double arm_clears_m = 0.15;  // assumed, 0.10-0.22
  // The tether's height at the arm's tip; from there it rises to the mouth.
  double tether_at_tip_m = 0.20;  // assumed, 0.15-0.35
  double half_wheel_m = 0.075;    // half a wheel's width; assumed, 0.05-0.10
  // The rover beside its plan: 2-10 cm of its own place.
  double beside_m = 0.05;    // assumed, 0.03-0.10
  double sigmas = 2.0;       // of the map that are kept clear, too; assumed, 1-3
  double tether_m = 0.03;    // kept clear of the tether; assumed, 0-0.1
  double tether_step = 0.1;  // of an arc between two places at which the tether is looked at, share
};

/// Of rocks that the rover has rolled off.
struct FeltRockOptions {
  // The wheel is off the rock when the axle's tilt has gone back to this share of its largest,
  // within so much of the wheel's way and of turning. A slope's tilt does not go so soon. Assumed,
  // 0.3-0.6, 0.3-0.6 m and 10-20 deg.
  double down_share = 0.4, within_m = 0.45, within_rad = Radians(15.0);
  // Heights are 3/8 to 1/2 of the diameter (Golombek and Rapp, JGR 102, 1997).
  double radius_of_height = 0.5 / 0.375;
};

struct MateOptions {
  double heading_rad = Radians(5.0);  // Tsai et al., V-B
  // Tip at the mouth within its radius of 10-12 cm less the tip's 3 cm. Range 0.06-0.09.
  double tip_offset_m = 0.07;
  // Arm against the socket when seated: psi = asin(y/L) exp(-depth/L) for an axle that rolls
  // without scrubbing behind a tip on the axis. Its play is 1.5 deg; of an arm that comes in with
  // more the cone bends some and the reel-in straightens the rest, which drags the station where it
  // bears little. Of 48 stations on 3.5-5 deg of compact gravel 33 moved by less than 1 cm with 4
  // deg, 39 with 2.5 deg. Range 2-4 deg.
  double socket_rad = Radians(2.5);
  double look_gap_m = 0.06;    // recheck with the tip this far before the mouth
  double enter_gap_m = -0.03;  // contact by depth estimate: tip this far inside, wheels then free
  // The socket's floor ends the reeling, not the length. The tip's place at the start is known to
  // 1-2 cm, to 4 cm after it has pushed at the mouth. So the spool is asked for this much more;
  // assumed, 0.04-0.10.
  double over_reel_m = 0.08;
  // A stop this far before the floor counts as seated: about the middle between it and where arms
  // stop at their lead-in, 2.6 to 3.5 cm before it. Range 0.008-0.02.
  double seat_margin_m = 0.013;
  // An arm that leans more to a side is not seated: its play is 1.5 deg to either side, arm and
  // cone bend by 1.3 deg. One that leans by 1.9 or 2.3 deg may come loose in the judge's shake
  // (simulated). Range 1.5-2.2.
  double lean_limit_rad = Radians(1.8);
  // A look with the tip so deep inside goes on with the reel-in. Assumed, 0.1-0.18.
  double inside_m = 0.12;
  // Of both wheels while the spool reels in. Rolling over a paddle takes 105 N, and the feet of a
  // station of 35 kg slip at 137 N (friction 0.4), less on a slope: the wheels carry the rover
  // over, or the tether would pull the station out. A rover that nothing brings on pushes less, as
  // it may stand on the socket's floor. Assumed, 60-100 N, 20-50 N and 0.1-0.4 s.
  double thrust_n = 80.0, still_thrust_n = 30.0;
  Tick moving_after = 200;
  // Into the mouth, where the tether pulls less: a tip that meets the rim pushes with that.
  double enter_thrust_n = 70.0;  // assumed, 60-100
  // The tip feels the cone: wheels that push with so much of that and do not roll. Before that the
  // way goes on until the axle lies level on its paddles, by the inertial unit, at most half a
  // pitch. Assumed, 0.7-0.95, 0.3-1 s and 0.3-1 deg.
  double contact_share = 0.8;
  Tick contact_after = 500;
  double level_rad = Radians(0.5);
  Tick stuck_after = 2'000;  // spool at its limit without taking up
  Tick free_after = 400;     // and the wheels push no more, before the brake; assumed, 0.2-1 s
  // Two thirds of what slips the nominal station; less where it bears less for sure
  // (station_hold.h). It ends when nothing came in for gentle_after: at the lead-in, on the floor,
  // or before a paddle uphill.
  double gentle_tension_n = 90.0;  // assumed, 60-110
  Tick gentle_after = 1'000;       // assumed, 0.5-2 s
  // An arm that stopped short is turned to and fro under the spool's pull, the k-th time at k times
  // this rate. Within the funnel's play: 0.06 rad/s for 1.2 s is 4 deg. Assumed, 0.03-0.1 rad/s.
  double wiggle_rad_s = 0.06, wiggle_accel_rad_s2 = 0.5;
  Tick wiggle_quarter = 1'200;
  int wiggles = 3;  // then out, and again; assumed, 2-5
  // As many for an arm on the floor that leans: its axle stands aside, and more turning to and fro
  // only digs the wheels in (simulated: 10 cm deep after nine). Assumed, 0-2.
  int lean_wiggles = 0;
  // An arm that stopped short and leans backs out, for the first recoveries of a run. Then
  // it is turned to and fro, which drags the station by 1-2 cm across slopes. Assumed, 1-3.
  int short_recoveries = 2;
  // A rover that slid aside before the mouth slides so again: 4-7 cm across 3-5 deg of compact soil
  // (simulated, with its axle steered to the line). What it was off by is planned for the next
  // time, at most so much, over the alignment gap; assumed, 0.04-0.08.
  double learned_aside_m = 0.06, learned_way_m = 0.45;
  // A push to each side that takes up less than this has moved nothing: five counts of the drum,
  // the tether's stretch and the seated arm's play. Assumed, 0.002-0.005.
  double wiggle_gain_m = 0.003;
  // An arm that leans more is turned into the middle of its play before the rover claims, until the
  // inertial unit has seen that turn. The picture tells the lean to 0.7 deg: cameras, board and arm
  // are mounted to a few tenths each. So an arm that it says to lean by 1.4 deg may lean by 2.1,
  // which comes loose (simulated). Assumed, 0.8-1.4 deg, 0.03-0.1 rad/s, 2-5 s and 0.4-1 s.
  // The wheels stand wound up in the soil and turn it on by a degree more once they are braked, so
  // that it stops early. Assumed, 0.5-1.2 deg.
  double straighten_rad = Radians(1.2), straight_rad = Radians(0.9);
  double straighten_rad_s = 0.05, straighten_accel_rad_s2 = 0.5;
  Tick straighten_limit = 3'000, straighten_rest = 600;
  Tick picture_limit = 5'000;  // for the picture at home, which may be late; assumed, 2-10 s
  // Seated, wheels braked: the tether is drawn taut before the brake, else the rover hangs loose in
  // the socket. Above a straight pull's 90 N, below the 105 N that lift it over a paddle; 60-150.
  double taut_tension_n = 100.0;
  double taut_m_s = 0.02;     // assumed, 0.01-0.05
  Tick taut_limit = 10'000;   // then brake in any case
  Tick confirm_time = 1'500;  // spool braked: nothing may move
  double confirm_slip_m = 0.003;
};

struct SearchOptions {
  double tilt_rad = Radians(6.0);
  double turn_rad = Radians(12.0);  // two overlap the lens's edge region; assumed, 8-20
  double reel_m = 0.6;              // towards the station, arm swinging into line; assumed, 0.4-0.8
  // A pull ends when the rover has turned by this much: half the lens's width of view, so that no
  // direction is passed over. 30-60 deg.
  double pull_turn_rad = Radians(45.0);
  double advance_m = 0.6;   // on dead reckoning: 6 cm of error at 10 % slip
  double near_gap_m = 1.2;  // nearer than this back up rather than go on blindly
  Tick move_limit = 25'000;
  // The wheels turn the rover only while the tether is nearer to the arm than this; see
  // PlanOptions::tether_angle_rad.
  double tether_rad = Radians(45.0);
  double pull_room_m = 0.3;          // left between tip and mouth after a pull; assumed, 0.2-0.5
  double abeam_rad = Radians(95.0);  // a leg ends there; it tipped at 95-104 deg; assumed, 85-100
  int turning_pulls = 6;             // of a rover that sees the board; 180 deg by 35-45 deg each
  double backwards_m = 0.3;          // drawn along backwards, it is in balance; assumed, 0.2-0.4
  // A pull that turned it by less left it facing along the tether: paddles turn a rover on compact
  // soil by 10 deg to and fro, of which half a step's length evens out most. Assumed, 6-12 deg.
  double still_turn_rad = Radians(8.0);
  double whole_pull = 0.85;  // share of a pull; less is a spool that stalled; assumed, 0.7-0.95
  int stuck_pulls = 2;       // then the station is reached, or nothing helps; assumed, 2-3
  // An arm raised so far after a pull hangs from the cone: the rover is near it, and backs off
  // before it turns. 12 deg below the level it lies on the ground. Assumed, 0-3 deg.
  double raised_rad = Radians(1.5);
  double reverse_m = 1.0;            // axle from 1.2 m before the mouth to 2.2 m; assumed, 0.7-1.5
  double sweep_rad = Radians(20.0);  // looks to each side: within tether_rad, lens's edges overlap
  // Looks from nearly the same place show the same. Assumed, 8-20 deg and 0.5-2 m of tether.
  double same_yaw_rad = Radians(12.0), same_place_m = 1.5;
  // The tip is at most 9 m from the mouth, facing away at 8 m, and reversing gives 2 m back.
  double reel_limit_m = 11.0;
};

/// Of a rover that comes by the tether alone.
struct HaulOptions {
  // A rover in the socket turns by 0.8-1.4 deg of 11 deg commanded, in the mouth by 3.5-4.3,
  // outside by 5.5-7 (simulated on loose and compact soil). Share of what is commanded; range
  // 0.15-0.3.
  double held_share = 0.22;
  // Arm against the axis of the socket, whose play is 1.5 deg.
  double elevation_rad = Radians(2.0);  // range 1.5-2.5
  // The wheels turn the rover, so the tether need not roll it. Below the station's friction on its
  // feet, 137 N; assumed, 60-130.
  double align_tension_n = 100.0;
  double firm_m = 0.003;                             // as MateOptions::wiggle_gain_m
  double push_rad_s = 0.1, push_accel_rad_s2 = 0.5;  // 8 deg to each side; assumed, 0.06-0.15
  Tick quarter = 1'400;
  int pushes = 6;  // in a row that each help; assumed, 4-8
  Tick ease_time = 1'500;
  int tries = 2;  // approaches by the tether; assumed, 1-3
  // Beyond this the arm jams in the cone (pure reeling; Tsai et al., V-C: 5 deg without moving the
  // station). Where it has an estimate from before, it does not try. Range 8-20 deg.
  double aside_rad = Radians(12.0);
};

/// The way out of a rover that starts seated. It reverses: the arm stays ahead and the tether taut.
struct ExcursionOptions {
  double clear_gap_m = 0.3;  // tip before the mouth when undocked; assumed, 0.2-0.6
  // Share of the weight's pull downhill that the tether takes, beside its tension in reverse.
  // Wheels that brake alone lift the arm, and a spool that holds alone pulls the station down.
  // Assumed, 0.1-0.5.
  double weight_share = 0.25;
  double yaw_gain_per_s = 0.5;  // steering back to the first heading; assumed, 0.2-1
  double return_m = 4.0;        // axle before the seat on its return; marks are made for 5 m; 3-5
};

/// Of a rover that has turned over. All assumed; angles and speeds leave the arm's motor, 80 N m,
/// three times the 20 N m of an arm held level.
struct RightingOptions {
  Tick over_for = 400;                 // turned over for this long, it has gone over; 0.2-1 s
  double upright_rad = Radians(50.0);  // within this the arm's levelling is enough; 40-60 deg
  double turn_rad_s = Radians(12.0);   // of the body, wheels free; 5-20 deg/s
  double swing_rad_s = Radians(15.0);  // of the arm, wheels braked; 5-25 deg/s
  double accel_rad_s2 = 0.5;           // 0.2-1
  double counter_rad = Radians(20.0);  // arm this near the body's front: their weights balance
  double down_rad = Radians(8.0);      // swung arm, below the level: a little above the ground
  double near_rad = Radians(4.0);      // a turn is over this far from its end
  double rest_rad_s = Radians(3.0);    // slower for rest_time: at rest
  Tick rest_time = 600, rest_limit = 6'000;
  double patience = 1.5;  // times a turn's nominal duration
  int tries = 3;
  // Before the second and third try: half a metre out of what the wheels have dug. 5-20 s.
  double leave_m_s = 0.05, leave_accel_rad_s2 = 0.3;
  Tick leave_time = 10'000;
};

struct LimitOptions {
  int rightings = 4;   // as recoveries
  int recoveries = 4;  // the limit that the paper asks for (V-B); assumed, 2-6
  int plans = 40;      // legs in all; ten times a straight approach
};

struct AxelOptions {
  TetherOptions tether{};
  DriveOptions drive{};
  HoldOptions hold{};
  SlideOptions slide{};
  DigOptions dig{};
  ArmOptions arm{};
  LookOptions look{};
  MovingOptions moving{};
  BracketOptions bracket{};
  PlanOptions plan{};
  FeltRockOptions felt_rocks{};
  MateOptions mate{};
  SearchOptions search{};
  HaulOptions haul{};
  ExcursionOptions excursion{};
  RightingOptions righting{};
  LimitOptions limit{};
  FilterNoise noise{};
};

}  // namespace dockyard::axel
