// Ground that does not sink: its heights, and which floor lies where.
#pragma once

#include <cstdint>
#include <vector>

#include "models/parts/contact_material.h"
#include "models/parts/floor_model.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// The floors by the numbers of the heights' samples (HeightGrid::soils).
struct FirmGround {
  HeightGrid heights;
  std::vector<FloorModel> floors;  // at least one
};

/// Of a body of this stiffness and damping on a floor, one behind the other; its friction is grip
/// times that of rubber. The damping is that of slow motion, for which the shares of the yielding
/// are as the springs': sum of c (k / k_i)^2.
ContactMaterial MaterialOn(const FloorModel& floor, double stiffness_n_per_m,
                           double damping_ns_per_m, double grip);

/// Where the numbers of the pairs begin that tyres and corners have on the ground, apart from those
/// of all other contacts.
inline constexpr std::int64_t kTyrePairs = std::int64_t{1} << 40;
inline constexpr std::int64_t kFloorPairs = std::int64_t{1} << 41;

/// A point further above the ground than this, which nears it at this speed, gets no contact in a
/// step: three steps and 1 mm. Numerical.
inline double ContactReach(double speed_m_s, double step_s) {
  return 1e-3 + 3.0 * step_s * speed_m_s;
}

}  // namespace dockyard
