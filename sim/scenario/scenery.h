// Things that cameras see and nothing runs into: the items of a scenario's list `scenery`.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

/// Its frame: the middle of its foot, z up; of a mesh that of the file.
struct SceneryItem {
  enum class Kind { kBox, kCylinder, kCone, kSphere, kMesh, kSet, kRoom, kOutdoors };
  enum class Colour {
    kGrey,
    kWhite,
    kBlack,
    kBrick,
    kDenim,
    kConeOrange,
    kOrange,
    kBlue,
    kGrass,
    kSoil,
    kFloor
  };
  Kind kind = Kind::kBox;
  Colour colour = Colour::kGrey;
  Eigen::Vector3d size_m{0, 0, 0};  // of a box or a room; else diameter, diameter, height
  std::string file{};               // of a mesh: resolved path
  double scale = 1.0;
  Pose2 X_DO{};
  double up_m = 0.0;  // over the ground there
  double roll_rad = 0.0, pitch_rad = 0.0;
  // Of a set: boxes, cones and spheres in a disc about its place. A room and the outdoors have a
  // count of loose things, a distance that these keep, and the outdoors a radius.
  int count = 0;
  double radius_m = 0.0, least_m = 0.05, largest_m = 0.4;
  double clear_m = 0.5;  // from target, start and the line between them
  // Of a room's furniture and things: the share that is blue, reddish or orange, and the largest
  // side of what is reddish or orange.
  double coloured = 0.0, reddish_m = 0.0;
  std::vector<Colour> colours{};
};

}  // namespace dockyard
