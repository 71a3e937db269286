// A target among its neighbours. The same stones seen from two places are the same but for a shift,
// by which odometry is off: which stone is the target is told by all of them together.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/tracking/stone_middle.h"

namespace dockyard {

struct FieldStone {
  Eigen::Vector2d p{0, 0};  // its middle, in the frame that its list says
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();
  double height_m = 0.0, height_sigma_m = 0.0;
  double ground_m = 0.0;  // the ground's height there
  double real = 1.0;      // chance that it is a stone at all
};

struct FieldSettings {
  double radius_m = 0.27;  // that is looked at about the target; assumed, 0.15-0.3
  // Of other stones that might be taken for one, per m^2: Golombek and Rapp's at 5 % of cover,
  // above 2 cm. Assumed, 5-20. Their heights are spread evenly over so much; assumed, 2-6 cm.
  double clutter_m2 = 11.0, clutter_height_m = 0.04;
  // What stands out by little may be noise: of that there is so much more. Assumed, 10-60.
  double noise_m2 = 30.0;
  double seen_again = 0.85;           // chance, of a stone; assumed, 0.6-0.95
  double focal_baseline_px_m = 25.0;  // of the rectified pair
  double tallest_m = 0.1;             // what is taller is no stone of that kind; assumed, 0.06-0.2
  // Two tops nearer together are of one stone: half the widths of two small ones. Assumed, 1.5-3
  // cm.
  double one_stone_m = 0.022;
  // What is no further ahead of the cameras and further aside is the rover's own front wheels.
  double wheels_ahead_m = 0.12, wheels_aside_m = 0.12;
  // A height may be as far off as it likes, at this price. Assumed, 2-6.
  double height_price = 4.0;
  // Between two ways to match that differ in the target by more than apart_m, log odds of the
  // better one. Assumed, 1-4 and 1-3 cm.
  double least_odds = 1.2, apart_m = 0.02;
};

/// The stones about a place, with how well a camera at p_EC tells their middles and heights.
std::vector<FieldStone> StonesAbout(const ElevationMap& map, const Eigen::Vector2d& p_E,
                                    const Eigen::Vector3d& p_EC, const FieldSettings& settings);

struct FieldMatch {
  Eigen::Vector2d shift_m{0, 0};  // of the remembered stones, beyond what was predicted
  Eigen::Matrix2d spread_m2 = Eigen::Matrix2d::Zero();  // of that
  std::vector<int> seen;  // by remembered stone: its index among those seen; -1: none
  double odds = 0.0;      // log odds over the next best way that has the target elsewhere
  int matched = 0;
};

/// Finds remembered stones among those seen, both in E; the target is the first. The prediction may
/// be off by a shift with this spread.
FieldMatch MatchField(const std::vector<FieldStone>& remembered,
                      const std::vector<FieldStone>& seen, const Eigen::Matrix2d& shift_spread_m2,
                      const FieldSettings& settings);

}  // namespace dockyard
