#include "sim/axel/tsai2013_keys.h"

namespace dockyard::axel {
namespace {

void VisitVision(Keys& keys, Tsai2013Vision& vision) {
  keys.Number({"black_below_mean", "", "adaptive threshold: black is this share below the mean"},
              vision.black_below_mean, Between(0.05, 0.9));
  keys.Number({"window_share", "", "standard deviation of the mean's window over the width"},
              vision.window_share, Between(0.01, 0.2));
  keys.Number({"closeness_px", "px", "closeness of a detection to the re-projected model"},
              vision.closeness_px, Between(0.0, 50.0));
  keys.Number({"closeness_radii", "", "and so many radii of its disc"}, vision.closeness_radii,
              Between(0.0, 5.0));
  keys.Integer({"agreeing_points", "", "detections that must lie so close"}, vision.agreeing_points,
               4, 8);
  keys.Choice({"first", "", "of each rotation, the detection that the homography takes first"},
              vision.first, {"lowest", "topmost", "leftmost", "largest"});
}

void VisitBlobs(Keys& keys, Tsai2013Vision& vision) {
  keys.Number({"least_area_px", "px", "blob filter: area of a black region, in pixels, at least"},
              vision.least_area_px, Between(5.0, 200.0));
  keys.Number({"most_area_share", "", "the same at most, as a share of the image"},
              vision.most_area_share, Between(0.005, 0.5));
  keys.Number({"least_axis_ratio", "", "its minor axis over its major one, at least"},
              vision.least_axis_ratio, Between(0.1, 0.9));
  keys.Integer({"most_holes", "", "its holes at most: 2 is an Euler number of -1"},
               vision.most_holes, 0, 20);
  keys.Number({"coincidence", "", "centroids of region, rim and white so near, in radii"},
              vision.coincidence, Between(0.05, 1.0));
  keys.Number({"least_white", "", "white's share of the disc, at least"}, vision.least_white,
              Between(0.0, 0.15));
  keys.Number({"most_white", "", "white's share of the disc, at most"}, vision.most_white,
              Between(0.2, 1.0));
  keys.Number({"fullness", "", "region's area over its ellipse's, at least; not in the paper"},
              vision.fullness, Between(0.0, 0.95));
  keys.Number({"pattern_within", "", "the white is measured within this share of the radius"},
              vision.pattern_within, Between(0.3, 1.0));
}

void VisitRegions(Keys& keys, Tsai2013Options& options) {
  keys.Number({"align_r_m", "m", "border between approach and alignment, axle to mouth"},
              options.align_r_m, Between(1.5, 5.0));
  keys.Number({"mate_r_m", "m", "border between alignment and mating"}, options.mate_r_m,
              Between(1.0, 3.0));
  keys.Number({"mate_gap_m", "m", "arm's tip before the mouth where the alignment ends"},
              options.mate_gap_m, Between(0.05, 1.0));
  keys.Number({"recover_r_m", "m", "the recovery goal, on the axis"}, options.recover_r_m,
              Between(1.5, 5.0));
  keys.Degrees({"heading_deg", "deg", "tolerance before the mating (5 in the paper)"},
               options.heading_rad, Between(0.5, 20.0));
  keys.Number({"tip_offset_m", "m", "the same of the tip at the mouth, sideways"},
              options.tip_offset_m, Between(0.01, 0.3));
  keys.Number({"contact_depth_m", "m", "tip inside the mouth at contact"}, options.contact_depth_m,
              Between(-0.1, 0.15));
  keys.Number({"contact_within_m", "m", "how far before it a sighting counts as contact"},
              options.contact_within_m, Between(0.0, 0.1));
  keys.Number({"reel_in_m", "m", "tether reeled in from contact (0.25 in the paper)"},
              options.reel_in_m, Between(0.05, 0.5));
}

void VisitDrive(Keys& keys, Tsai2013Options& options) {
  keys.Number({"turn_cost_m", "m", "a radian of turning, in metres of way, in the choice of arcs"},
              options.turn_cost_m, NonNegative(10.0));
  keys.Number({"least_radius_m", "m", "of an arc"}, options.least_radius_m, Between(0.3, 10.0));
  keys.Degrees({"most_turn_deg", "deg", "of an arc"}, options.most_turn_rad, Between(10.0, 360.0));
  keys.Number({"drive_m_s", "m/s", "speed of the faster wheel"}, options.drive_m_s,
              Between(0.005, 0.2));
  keys.Number({"mate_m_s", "m/s", "the same in the mating region"}, options.mate_m_s,
              Between(0.005, 0.2));
  keys.Number({"reel_m_s", "m/s", "tether's speed in the reel-in"}, options.reel_m_s,
              Between(0.005, 0.2));
  keys.Number({"wheel_accel_rad_s2", "rad/s2", "of the trapezoids"}, options.wheel_accel_rad_s2,
              Between(0.01, 5.0));
  keys.Number({"taut_n", "N", "tension that the standing spool draws"}, options.taut_n,
              Between(5.0, 150.0));
  keys.Number({"tighten_m_s", "m/s", "tether's speed while it does"}, options.tighten_m_s,
              Between(0.005, 0.2));
  keys.Integer({"blind_looks", "", "image pairs in a row without a pose before it gives up"},
               options.blind_looks, 1, 100);
  keys.Degrees({"look_pitch_deg", "deg", "pitch beyond which the body is levelled before a look"},
               options.look_pitch_rad, Between(1.0, 45.0));
}

}  // namespace

void VisitTsai2013Keys(Keys& keys, Tsai2013Vision& vision, Tsai2013Options& options) {
  VisitVision(keys, vision);
  VisitBlobs(keys, vision);
  VisitRegions(keys, options);
  VisitDrive(keys, options);
}

}  // namespace dockyard::axel
