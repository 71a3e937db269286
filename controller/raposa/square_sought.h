// Whether an orange thing can be the guide: its blue square must be there, at some angle.
#pragma once

#include <bitset>

#include "controller/raposa/colour_pairs.h"
#include "controller/raposa/marks_projection.h"

namespace dockyard::raposa {

/// Angles of the camera about the guide from -110 to 110 deg, by 20 deg.
using Angles = std::bitset<12>;
/// The nearest of them; beyond 110 deg the last.
std::size_t AngleIndex(double alpha_rad);

/// The angles at which the image would show the square of the guide at the place, and shows no
/// blue there. None beyond 1.2 m, where the strips may be too thin.
/// @param guide  its heading does not count
Angles AnglesWithoutSquare(const Nominal& nominal, const TintMap& map, const PyramidPlace& guide);

}  // namespace dockyard::raposa
