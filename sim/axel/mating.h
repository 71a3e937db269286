// Where the arm touches the cone. Both are turned parts, so their contacts are computed on the
// exact surfaces: the arm's edges against the cone's wall and floor, the cone's edges against the
// arm's sides. Edges of the arm are rounded by kCollisionMargin_m, those of the cone are sharp.
#pragma once

#include <vector>

#include "models/axel/station_model.h"
#include "models/parts/link.h"
#include "sim/physics/turned_solid.h"

namespace dockyard::axel {

struct MatingContact {
  int pair = 0;                       // of edge and surface; the same from step to step
  Eigen::Vector3d p_M{0, 0, 0};       // on the arm's surface
  Eigen::Vector3d normal_M{0, 0, 0};  // from the station to the arm
  double gap_m = 0.0;                 // < 0: pressed in
  double share = 1.0;                 // of the stiffness: lying flat is three contacts
  bool on_face = false;               // the flat annulus round the mouth
};

class Mating {
 public:
  /// A box on the arm counts by points along its edges. Throws std::invalid_argument when a part of
  /// the arm is neither box nor cylinder, sphere or turned.
  Mating(const ConeModel& cone, const std::vector<Collision>& arm_parts);

  /// Contacts with gaps below within_m. X_MA: the arm in the mouth's frame.
  void Find(const Pose3& X_MA, double within_m, std::vector<MatingContact>& contacts) const;

 private:
  struct Edge {
    Ring ring;
    double radius_m = 0.0;  // of its rounding
  };
  struct Part {
    Pose3 X_AP;        // its axis is z of P
    TurnedSolid core;  // without the rounding
    double rounding_m = 0.0;
  };
  void MeetCone(const Pose3& X_MA, double within_m, std::vector<MatingContact>& contacts) const;
  void MeetArm(const Pose3& X_MA, double within_m, std::vector<MatingContact>& contacts) const;

  std::vector<TurnedSolid> cone_;  // wall and floor, their axis z of the frame C
  std::vector<Edge> arm_edges_;    // in A
  std::vector<Ring> cone_edges_;   // in C
  std::vector<Part> parts_;
  double reach_m_ = 0.0;  // of the cone from the mouth's centre
};

}  // namespace dockyard::axel
