// Where parts of one body meet walls that are turned about one axis, such as an arm in a cone. The
// contacts are computed on the exact surfaces: the parts' edges against the walls, the walls' edges
// against the sides of turned parts. Edges of parts are rounded by kCollisionMargin_m, those of
// walls are sharp.
#pragma once

#include <vector>

#include "models/parts/link.h"
#include "sim/rigid/turned_solid.h"

namespace dockyard {

struct BoreContact {
  int pair = 0;                     // of edge and surface; the same from step to step
  Eigen::Vector3d p{0, 0, 0};       // on the part's surface
  Eigen::Vector3d normal{0, 0, 0};  // from the wall to the part
  double gap_m = 0.0;               // < 0: pressed in
  double share = 1.0;               // of the stiffness: lying flat is three contacts
};

class BoreContacts {
 public:
  /// all_round: as of FindNearPoints, for parts that fit their seat.
  explicit BoreContacts(bool all_round = false) : all_round_(all_round) {}

  /// outline_m: corners (z, r) as TurnedSolid takes them, in the frame C of the walls.
  void AddWall(const std::vector<Eigen::Vector2d>& outline_m);
  /// An edge that stands out of the walls.
  void AddWallEdge(double z_m, double radius_m);
  /// In the frame A of the parts. Boxes and hulls count by points along their edges.
  void AddPart(const Collision& part);

  /// Contacts with gaps below within_m, in a frame M.
  void Find(const Pose3& X_MC, const Pose3& X_MA, double within_m,
            std::vector<BoreContact>& contacts) const;
  /// No wall is farther from the origin of C.
  double reach_m() const { return reach_m_; }

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
  // Edges of one part, with a ball that holds them.
  struct Group {
    std::size_t first = 0, end = 0;
    Eigen::Vector3d centre{0, 0, 0};  // in A
    double radius_m = 0.0;
  };
  void AddPoints(const Pose3& X_AL, const std::vector<Eigen::Vector3d>& points_L);
  void AddGroup(std::size_t first);
  void MeetWalls(const Pose3& X_MC, const Pose3& X_MA, double within_m,
                 std::vector<BoreContact>& contacts) const;
  void MeetParts(const Pose3& X_MC, const Pose3& X_MA, double within_m,
                 std::vector<BoreContact>& contacts) const;

  bool all_round_;
  std::vector<TurnedSolid> walls_;  // their axis z of C
  std::vector<Ring> wall_edges_;    // in C
  std::vector<Edge> part_edges_;    // in A
  std::vector<Group> groups_;       // of part_edges_
  std::vector<Part> parts_;
  double reach_m_ = 0.0;
};

}  // namespace dockyard
