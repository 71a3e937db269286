// The effect of a wheel's motion on the soil under all of its patches. It depends on displacements
// alone, so nothing happens at rest.
#pragma once

#include "sim/soil/soil_laws.h"

namespace dockyard {

/// One step of a wheel's motion [m].
struct WheelWay {
  double rolled_m = 0.0;  // of the paddles' tips about the axle, forward positive
  double ahead_m = 0.0, left_m = 0.0, up_m = 0.0;  // of the centre
};

struct WheelTravel {
  Mobilisation going;    // length 1: on its way ahead (t) or up (a); about 0 while it rocks
  double resting = 1.0;  // 1 - going^2
  /// Depth of soil that the paddles have carried out from under the wheel [m]: each takes a share
  /// of its buried height along as it slides back. A balance over the contact's length; steadily it
  /// is share x height x (slid / travelled), as in Pavlov and Johnson's trench model (2019).
  double excavated_m = 0.0;
};

/// The wheel's rim radius and how deep its paddles cut into the soil now.
struct PaddleCut {
  double rim_radius_m = 0.0;
  double depth_m = 0.0;  // 0: no paddles, or none in the soil
};

void Follow(WheelTravel& travel, const WheelWay& way, const PaddleCut& cut);

}  // namespace dockyard
