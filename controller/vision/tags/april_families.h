// Internal to the tags room. The families of libapriltag.
#pragma once

#include <apriltag/apriltag.h>

#include <memory>
#include <string>
#include <vector>

namespace dockyard {

using AprilFamily = std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)>;

std::vector<std::string> AprilFamilyNames();
/// Null for a name that is not in AprilFamilyNames.
AprilFamily AprilFamilyNamed(const std::string& name);

}  // namespace dockyard
