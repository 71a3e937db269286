// Speed of the physics alone, on the scenario's own rover, station and soils.
#pragma once

#include <string>

#include "sim/axel/world.h"

namespace dockyard::axel {

/// CPU time of this process [s].
double CpuSeconds();

/// Both wheels driven over their soil, far from the station, the tether in tow.
WorldSetup DrivingSetup(const std::string& soil);
double DrivingStepsPerSecond(const WorldSetup& setup);

/// The spool draws a rover that is 8 deg off the cone's axis into it; only steps in which the cone
/// presses on the arm are counted.
double ConeStepsPerSecond(const std::string& soil);

/// The same rover in MuJoCo with smooth rigid wheels, driven by the same commands: on a plane, or
/// on a height field of the setup's own samples.
double TwinStepsPerSecond(const WorldSetup& setup, bool uneven);
/// Drawn into the same cone, cut into convex hulls, on a station that stands fast; wheels on a
/// plane. 0: it never came into contact.
double TwinConeStepsPerSecond(const std::string& soil);

/// Braked and at rest.
double RestingStepsPerSecond(const std::string& soil);

/// From a scenario with its models read to a world at rest [s].
double SetUpSeconds(const std::string& soil);

/// Drives for one second; for a count of its instructions.
void DriveOneSecond(World& world);

}  // namespace dockyard::axel
