// What a row presumes: steady forces, and what the soil's laws presume about a wheel.
#pragma once

#include <string>
#include <vector>

#include "sim/soil/single_wheel.h"

namespace dockyard {

/// Whether the axle is below the soil as it was: none of the laws holds.
bool IsBuried(const WheelModel& wheel, const SingleWheelResult& result);

/// A sentence for each premise of a row that does not hold. docs/reference/soil.md has the sources
/// of those of the laws.
std::vector<std::string> BrokenPremises(const SingleWheelSetup& setup,
                                        const SingleWheelResult& result);

}  // namespace dockyard
