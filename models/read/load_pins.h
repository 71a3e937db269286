// The keys `contact_pins`, `contact_pads` and `supplies` of a robot's or a dock's file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "models/parts/spring_pins.h"
#include "models/read/keys.h"

namespace dockyard {

/// As they are in the file: with the names of links.
struct PinsFile {
  struct Pin {
    std::string link;
    SpringPin pin;
    double yaw_rad = 0.0, pitch_rad = 0.0;  // of its direction, from the link's x axis
  };
  struct Pad {
    std::string link;
    ContactPad pad;
    double yaw_rad = 0.0, pitch_rad = 0.0;  // of its normal, from the link's x axis
  };
  std::vector<Pin> pins;
  std::vector<Pad> pads;
  std::vector<ContactSupply> supplies;
};

/// All of them may be left out.
void VisitPins(Keys& keys, PinsFile& file);

/// link_of: the number of a link by its name and its pose in the link that carries it, or a throw
/// of ConfigError whose message begins with the second argument.
struct LinkPlace {
  int link = 0;
  Pose3 X_LF;  // the named link may be welded to another
};
using LinkFinder = std::function<LinkPlace(const std::string& name, const std::string& place)>;

/// in: the file. Throws ConfigError.
ElectricalParts TakePins(const YamlReader& in, const PinsFile& file, const LinkFinder& link_of);

}  // namespace dockyard
