// What is wrong with a robot and a dock by their geometry. A check finds it before a run is wasted.
#pragma once

#include <string>
#include <vector>

#include "models/custom/dock_model.h"
#include "models/custom/robot_model.h"

namespace dockyard::custom {

/// Texts, each with its place in front.
struct Findings {
  std::vector<std::string> faults;  // no robot can dock with one of these
  std::vector<std::string> doubts;  // odd, but may be meant
};

void Append(const Findings& more, Findings& findings);
/// Throws ConfigError with the first fault.
void RequireNoFault(const Findings& findings);

/// Boards that the dock's own parts hide, pins and pads that nothing can reach. file: the dock's.
Findings FindInDock(const DockModel& dock, const std::string& file);
/// Pins and pads that nothing can reach, and wheels that hang in the air. file: the
/// robot's.
Findings FindInRobot(const RobotModel& robot, const std::string& file);

/// Of one part each (reach_findings.cc, wheel_findings.cc).
Findings FindHiddenBoards(const DockModel& dock, const std::string& file);
Findings FindOutOfReach(const LinkTree& tree, const ElectricalParts& parts,
                        const std::string& file);
Findings FindHangingWheels(const RobotModel& robot, const std::string& file);

/// "file:line:column: list[i].key" of a model's file, as far as it has that.
std::string PlaceOfKey(const std::string& file, const std::string& list, std::size_t i,
                       const std::string& key);

/// The end of a finding's text.
inline constexpr const char* kWhatIsChecked = " (docs/reference/custom.md#what-check-finds)";

}  // namespace dockyard::custom
