// Links of a robot that its system does not command: their joints are in the URDF file, and what a
// URDF file has no word for is in the robot's YAML file.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "models/parts/jointed_link.h"
#include "models/read/keys.h"
#include "models/read/urdf.h"

namespace dockyard {

/// The keys of such joints as they are in the file. NaN: not there.
struct JointFile {
  std::string name;
  double start_rad = NAN, start_m = NAN;
  JointStop stop{NAN, NAN}, slide_stop{NAN, NAN};
  double spring_nm_per_rad = NAN, rest_rad = NAN, spring_n_per_m = NAN, rest_m = NAN;
  double rate_rad_s = NAN, rate_m_s = NAN, lead_m_per_turn = NAN;
  std::optional<MotorModel> motor;
};
struct PinFile {
  std::string link, to;
  LinkPin pin;
};
struct JointsFile {
  std::vector<JointFile> joints;
  std::vector<PinFile> pins;
  ContactMaterial contact = JointedLinks{}.contact;
};

/// The keys `joints`, `pins` and `link_contact`, which may all be left out.
void VisitJoints(Keys& keys, JointsFile& file);

/// A system's own links and joints by their names; the links in the order of their numbers.
struct OwnLinks {
  std::vector<std::string> links, joints;
};

/// All other joints of a welded model with their links. `in`: the robot's file, for messages.
/// Throws ConfigError for joints of other types than continuous, revolute and prismatic, links
/// without mass, friction or damping of the system's own joints, names that no joint or link has,
/// and keys that do not fit a joint.
JointedLinks TakeJointedLinks(const YamlReader& in, const UrdfModel& welded, const OwnLinks& own,
                              const JointsFile& file);

}  // namespace dockyard
