#include "sim/rigid/bore_contacts.h"

#include <algorithm>

#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/convex_body.h"
#include "sim/rigid/turned_shape.h"

namespace dockyard {
namespace {

// Between two points of a straight edge this far apart a throat of 32 mm goes 0.06 mm deeper.
constexpr double kEdgeSpacing_m = 4e-3;
// More than rounding of a group's ball; numerical.
constexpr double kGroupPlay_m = 1e-6;

// The outline of a part without its rounding, as (z, r).
struct Core {
  std::vector<Eigen::Vector2d> rims;
  double rounding_m = kCollisionMargin_m;
};

// Points along the edges of a box, in its own frame, less than kEdgeSpacing_m apart.
std::vector<Eigen::Vector3d> EdgePoints(const BoxShape& box) {
  const Eigen::Vector3d half = (0.5 * box.size_m.array() - kCollisionMargin_m).max(0.0).matrix();
  std::vector<Eigen::Vector3d> points;
  for (int axis = 0; axis < 3; ++axis) {
    const int pieces = 1 + static_cast<int>(2.0 * half[axis] / kEdgeSpacing_m);
    for (int corner = 0; corner < 4; ++corner) {
      Eigen::Vector3d p;
      p[(axis + 1) % 3] = (corner & 1 ? 1.0 : -1.0) * half[(axis + 1) % 3];
      p[(axis + 2) % 3] = (corner & 2 ? 1.0 : -1.0) * half[(axis + 2) % 3];
      for (int i = 0; i <= pieces; ++i) {
        p[axis] = half[axis] * (2.0 * i / pieces - 1.0);
        points.push_back(p);
      }
    }
  }
  return points;
}

// The same of a hull. Its edges are not drawn in: it stands out by the margin, as in Bullet.
std::vector<Eigen::Vector3d> EdgePoints(const HullShape& hull) {
  const ConvexBody body = HullOf(hull.points);
  std::vector<Eigen::Vector3d> points;
  for (const auto& edge : body.edges) {
    const Eigen::Vector3d &a = body.vertices[edge[0]], &b = body.vertices[edge[1]];
    const int pieces = 1 + static_cast<int>((b - a).norm() / kEdgeSpacing_m);
    for (int i = 0; i <= pieces; ++i) {
      points.emplace_back(a + (b - a) * i / static_cast<double>(pieces));
    }
  }
  return points;
}

std::vector<Eigen::Vector2d> Outline(const std::vector<Eigen::Vector2d>& rims) {
  std::vector<Eigen::Vector2d> outline{{rims.front().x(), 0.0}};
  outline.insert(outline.end(), rims.begin(), rims.end());
  outline.emplace_back(rims.back().x(), 0.0);
  return outline;
}

}  // namespace

void BoreContacts::AddWall(const std::vector<Eigen::Vector2d>& outline_m) {
  walls_.emplace_back(outline_m);
  for (const Eigen::Vector2d& corner : outline_m) reach_m_ = std::max(reach_m_, corner.norm());
}

void BoreContacts::AddWallEdge(double z_m, double radius_m) {
  Ring ring;
  ring.centre.z() = z_m;
  ring.radius_m = radius_m;
  wall_edges_.push_back(ring);
}

void BoreContacts::AddPoints(const Pose3& X_AL, const std::vector<Eigen::Vector3d>& points_L) {
  for (const Eigen::Vector3d& p : points_L) {
    Ring point;
    point.centre = X_AL * p;
    part_edges_.push_back({point, kCollisionMargin_m});
  }
}

// Of the edges from the first on.
void BoreContacts::AddGroup(std::size_t first) {
  Group group{.first = first, .end = part_edges_.size()};
  const double count = static_cast<double>(group.end - first);
  for (std::size_t i = first; i < group.end; ++i)
    group.centre += part_edges_[i].ring.centre / count;
  for (std::size_t i = first; i < group.end; ++i) {
    const Edge& edge = part_edges_[i];
    const double away_m = (edge.ring.centre - group.centre).norm();
    group.radius_m = std::max(group.radius_m, away_m + edge.ring.radius_m);
  }
  groups_.push_back(group);
}

void BoreContacts::AddPart(const Collision& part) {
  const std::size_t first = part_edges_.size();
  Core core;
  if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
    AddPoints(part.X_LG, EdgePoints(*box));
  } else if (const auto* hull = std::get_if<HullShape>(&part.shape)) {
    AddPoints(part.X_LG, EdgePoints(*hull));
  } else if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
    const double half = 0.5 * cylinder->length_m, r = cylinder->radius_m;
    core.rims = DrawnIn({{-half, r}, {half, r}}, kCollisionMargin_m);
  } else if (const auto* turned = std::get_if<TurnedShape>(&part.shape)) {
    core.rims = DrawnIn(turned->profile_m, kCollisionMargin_m);
  } else {
    core = {{{0.0, 0.0}}, std::get<SphereShape>(part.shape).radius_m};
  }
  if (core.rims.size() > 1) {  // a ball has no sides
    parts_.push_back({part.X_LG, TurnedSolid(Outline(core.rims)), core.rounding_m});
  }
  for (const Eigen::Vector2d& rim : core.rims) {
    Ring ring;
    ring.centre.z() = rim.x();
    ring.radius_m = rim.y();
    part_edges_.push_back({part.X_LG * ring, core.rounding_m});
  }
  AddGroup(first);
}

void BoreContacts::Find(const Pose3& X_MC, const Pose3& X_MA, double within_m,
                        std::vector<BoreContact>& contacts) const {
  contacts.clear();
  MeetWalls(X_MC, X_MA, within_m, contacts);
  MeetParts(X_MC, X_MA, within_m, contacts);
}

void BoreContacts::MeetWalls(const Pose3& X_MC, const Pose3& X_MA, double within_m,
                             std::vector<BoreContact>& contacts) const {
  const Pose3 X_CA = Inverse(X_MC) * X_MA;
  RingPoints points;
  const int walls = static_cast<int>(walls_.size());
  for (const Group& group : groups_) {
    if ((X_CA * group.centre).norm() > reach_m_ + group.radius_m + kGroupPlay_m + within_m)
      continue;
    for (std::size_t e = group.first; e < group.end; ++e) {
      const Edge& edge = part_edges_[e];
      const Ring ring = X_CA * edge.ring;
      if (ring.centre.norm() > reach_m_ + ring.radius_m + within_m) continue;
      int pair = static_cast<int>(e) * walls;
      for (const TurnedSolid& wall : walls_) {
        ++pair;
        const int count = FindNearPoints(ring, wall, edge.radius_m + within_m, points, all_round_);
        for (int i = 0; i < count; ++i) {
          const RingPoint& point = points[i];
          contacts.push_back({pair, X_MC * (point.p - edge.radius_m * point.normal),
                              X_MC.R * point.normal, point.distance_m - edge.radius_m,
                              point.share});
        }
      }
    }
  }
}

void BoreContacts::MeetParts(const Pose3& X_MC, const Pose3& X_MA, double within_m,
                             std::vector<BoreContact>& contacts) const {
  RingPoints points;
  int pair = static_cast<int>(part_edges_.size() * walls_.size());
  for (const Part& part : parts_) {
    const Pose3 X_MP = X_MA * part.X_AP;
    const Pose3 X_PC = Inverse(X_MP) * X_MC;
    for (const Ring& edge : wall_edges_) {
      ++pair;
      const int count =
          FindNearPoints(X_PC * edge, part.core, part.rounding_m + within_m, points, all_round_);
      for (int i = 0; i < count; ++i) {
        const RingPoint& point = points[i];
        if (!point.on_side) continue;  // edge to edge: found as the part's edge on the wall
        contacts.push_back(
            {pair, X_MP * (point.p - (point.distance_m - part.rounding_m) * point.normal),
             -(X_MP.R * point.normal), point.distance_m - part.rounding_m, point.share});
      }
    }
  }
}

}  // namespace dockyard
