// Where the rover touches rocks: its wheels by their outline, arm and body by their shapes.
#pragma once

#include <cstdint>
#include <vector>

#include "models/axel/axel_model.h"
#include "models/parts/wheel.h"
#include "sim/axel/rock_bed.h"
#include "sim/axel/rover_body.h"
#include "sim/rigid/body_contact.h"

namespace dockyard::axel {

/// A contact of a link with a rock, in G.
struct RockContact {
  RoverLink link = RoverLink::kBody;
  std::int64_t pair = 0;  // of rock and feature; the same from step to step
  BodyContact at;
};

class RockContacts {
 public:
  /// arm_parts: in A, as the arm meets the station.
  RockContacts(const RoverModel& rover, const std::vector<Collision>& arm_parts,
               std::vector<ConvexBody> rocks);

  /// Contacts of the rover as it stands.
  void Find(const RoverBody& rover, std::vector<RockContact>& contacts);
  /// How deep a link reaches into any rock there [m]; 0: clear of all.
  double Depth(RoverLink link, const Pose3& X_GL);

 private:
  /// What a link shows to rocks, in its own frame.
  struct Shape {
    std::vector<WheelModel> wheels;  // one or none
    std::vector<Cylinder> cylinders;
    std::vector<ConvexBody> hulls;
    Eigen::Vector3d centre{0, 0, 0};
    double radius_m = 0.0;  // of the sphere about it that holds the shape
  };
  /// The rocks that the link may meet before it has moved by kSlack_m from here.
  struct Near {
    Eigen::Vector3d p_G{0, 0, 0};
    std::vector<int> rocks;
    bool known = false;
  };
  static Shape ShapeOf(const std::vector<Collision>& collisions);
  void AddContacts(const Shape& shape, const Pose3& X_GL, const ConvexBody& rock);

  std::vector<ConvexBody> rocks_;
  std::vector<Shape> shapes_;  // by RoverLink
  std::vector<Near> near_;
  std::vector<BodyContact> found_;  // of one link and rock
};

}  // namespace dockyard::axel
