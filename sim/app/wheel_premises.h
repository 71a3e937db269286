// What the soil's laws presume about a wheel, and where a row leaves it.
#pragma once

#include <string>
#include <vector>

#include "sim/soil/single_wheel.h"

namespace dockyard {

/// Whether the axle is below the soil as it was: none of the laws holds.
bool IsBuried(const WheelModel& wheel, const SingleWheelResult& result);

/// A sentence for each premise that does not hold. docs/reference/soil.md has their sources.
std::vector<std::string> BrokenPremises(const SingleWheelSetup& setup,
                                        const SingleWheelResult& result);

}  // namespace dockyard
