// Where a stone lies, from one map: its middle, its height above the ground about it, its sides.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "controller/stereo/elevation.h"

namespace dockyard {

struct StoneMiddleSettings {
  // How far the stone's middle may be from the prediction: three sigmas of the prediction. Assumed,
  // 4-8 cm: 10 % of a step and 2 deg of the distance.
  double window_m = 0.06;
  double ring_m = 0.06;  // the ground is looked at so far beyond the window; assumed, 3-8 cm
  double least_height_m = 0.006;  // of a stone; assumed, 4-10 mm: pebbles are lower
  double least_sigmas = 3.0;      // and over the ground's own roughness
  int least_cells = 4;            // of a stone; assumed, 3-8
  double upper_share = 0.5;  // the part above this share of the height counts; assumed, 0.4-0.7
  // Cells so far apart still touch: rows of pixels meet the ground 11 mm apart at 1 m.
  double link_m = 0.012;
  // Two tops are two stones if the saddle between them is lower than the lower top by this share of
  // its height, and by least_sigmas. Assumed, 0.2-0.5.
  double saddle_share = 0.35;
  // If a second stone is farther from the prediction than the nearest by less than this, the
  // prediction does not tell them apart. Assumed, 1-3 cm.
  double apart_m = 0.02;
};

enum class StoneVerdict : std::uint8_t {
  kFound,
  kFlat,     // nothing in the window stands out of the ground
  kBorder,   // what does has its middle beyond the window, or is cut by the part looked at
  kUnseen,   // too little of the window or of the ground about it is known
  kSeveral,  // two stones are about equally near to the prediction
};

struct StoneMiddle {
  StoneVerdict verdict = StoneVerdict::kUnseen;
  // Of the stone that is nearest to the prediction, with kFound and kSeveral. All in E.
  Eigen::Vector2d p_E{0, 0};
  double height_m = 0.0;                           // of its top above the ground there
  Eigen::Vector3d ground{0, 0, 0};                 // the ground's height: a + b x + c y
  double half_length_m = 0.0, half_width_m = 0.0;  // of what is seen of its upper part
  std::optional<double> heading_rad;  // of the longer side, from x, within half a turn; none: round
  double sigma_m = 0.0;               // of the ground's cells about the plane
};

/// The stone whose middle is nearest to a predicted place. The plane through the ground about it is
/// found by least absolute deviations, then without what stands out: a slope is no stone.
StoneMiddle FindStone(const ElevationMap& map, const Eigen::Vector2d& p_E_predicted,
                      const StoneMiddleSettings& settings);

}  // namespace dockyard
