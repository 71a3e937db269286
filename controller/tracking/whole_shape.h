// Our tracker: the shape of the ground about the target is found again as a whole, by where it
// differs least from the new map. A target on a face or beside a taller stone is a point of that
// shape like any other.
#pragma once

#include <cstdint>

#include "controller/tracking/height_patch.h"

namespace dockyard {

struct WholeShapeSettings {
  double half_m = 0.08;          // of the shape's square; assumed, 0.06-0.12
  double step_m = 0.01;          // between its places; assumed, 5-15 mm
  double window_m = 0.08;        // how far the prediction may be off; assumed, 4-12 cm
  double yaw_rad = 0.12;         // and in heading; assumed, 0.05-0.2
  double yaw_step_rad = 0.06;    // assumed, 0.03-0.1: a place 8 cm away moves by half a step
  double least_share = 0.5;      // of its places that must be seen again; assumed, 0.3-0.7
  double least_relief_m = 2e-3;  // of a shape that is worth looking for; assumed, 1-4 mm
  double most_misfit = 2.0;      // root mean square over the sigmas; assumed, 1.5-4
  // The second-best place, this far off, must fit worse by so much. Assumed, 1-3 cm, 1.15-2.
  double apart_m = 0.02, least_ratio = 1.3;
};

enum class TrackVerdict : std::uint8_t {
  kFound,
  kFlat,       // the shape has no relief to find it by
  kUnseen,     // too little of it is in the new map
  kMisfit,     // it fits nowhere: the target is gone, or changed
  kAmbiguous,  // two places fit alike
};

struct TrackedShape {
  TrackVerdict verdict = TrackVerdict::kUnseen;
  Pose2 X_ET;             // of the target in the new map
  double height_m = 0.0;  // of the target there
  double misfit = 0.0;    // root mean square over the sigmas
  double ratio = 0.0;     // of the second-best misfit to the best
};

/// The shape about a target at X_ET.
HeightPatch ShapeAbout(const ElevationMap& map, const Pose2& X_ET,
                       const WholeShapeSettings& settings);

/// Finds the shape in a new map, about where odometry puts the target.
TrackedShape FindShape(const HeightPatch& shape, const ElevationMap& map,
                       const Pose2& X_ET_predicted, const WholeShapeSettings& settings);

}  // namespace dockyard
