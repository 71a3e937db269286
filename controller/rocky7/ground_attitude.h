// The body's attitude against the ground that it drives on.
#pragma once

#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

/// Roll and pitch against the ground: those of the inertial unit on level ground; none where the
/// ground, near and ahead, is taken to be parallel to the body.
inline ImuSample AgainstGround(ImuSample attitude, bool ground_as_body) {
  if (ground_as_body) attitude.roll_rad = attitude.pitch_rad = 0.0;
  return attitude;
}

}  // namespace dockyard::rocky7
