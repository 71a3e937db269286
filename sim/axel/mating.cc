#include "sim/axel/mating.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/physics/collision_shapes.h"
#include "sim/physics/turned_shape.h"

namespace dockyard::axel {
namespace {

// Between two points of a straight edge this far apart a throat of 32 mm goes 0.06 mm deeper.
constexpr double kEdgeSpacing_m = 4e-3;
constexpr double kFloorThickness_m = 0.03;  // only its front is ever met
// A contact belongs to the face when it is this near the mouth's plane and faces outwards.
constexpr double kFaceDepth_m = 4e-3;
constexpr double kFaceNormal = 0.9;

// The cone's frame C: the mouth's, with z along the cone's axis.
const Pose3& X_MC() {
  static const Pose3 X{RotY(0.5 * kPi), Eigen::Vector3d::Zero()};
  return X;
}

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

Core CoreOf(const Collision& part) {
  if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
    const double half = 0.5 * cylinder->length_m, r = cylinder->radius_m;
    return {DrawnIn({{-half, r}, {half, r}}, kCollisionMargin_m)};
  }
  if (const auto* turned = std::get_if<TurnedShape>(&part.shape)) {
    return {DrawnIn(turned->profile_m, kCollisionMargin_m)};
  }
  if (const auto* sphere = std::get_if<SphereShape>(&part.shape)) {
    return {{{0.0, 0.0}}, sphere->radius_m};
  }
  throw std::invalid_argument("the arm's collision shape '" + part.name +
                              "' is no cylinder, sphere or box");
}

std::vector<Eigen::Vector2d> Outline(const std::vector<Eigen::Vector2d>& rims) {
  std::vector<Eigen::Vector2d> outline{{rims.front().x(), 0.0}};
  outline.insert(outline.end(), rims.begin(), rims.end());
  outline.emplace_back(rims.back().x(), 0.0);
  return outline;
}

bool IsOnFace(const MatingContact& contact) {
  return contact.p_M.x() > -kFaceDepth_m && contact.normal_M.x() > kFaceNormal;
}

}  // namespace

Mating::Mating(const ConeModel& cone, const std::vector<Collision>& arm_parts) {
  const double mouth = cone.mouth_radius_m, throat = cone.throat_radius_m;
  const double outer = cone.face_outer_radius_m, end = cone.socket_end_m;
  cone_.emplace_back(std::vector<Eigen::Vector2d>{
      {0.0, outer}, {0.0, mouth}, {-cone.funnel_length_m, throat}, {-end, throat}, {-end, outer}});
  if (cone.stop_depth_m > 0.0) {
    const double front = -cone.stop_depth_m, back = front - kFloorThickness_m;
    cone_.emplace_back(
        std::vector<Eigen::Vector2d>{{back, 0.0}, {back, throat}, {front, throat}, {front, 0.0}});
  }
  const auto AddEdge = [&](double z, double radius) {
    Ring ring;
    ring.centre.z() = z;
    ring.radius_m = radius;
    cone_edges_.push_back(ring);
  };
  AddEdge(0.0, mouth);
  AddEdge(-cone.funnel_length_m, throat);
  AddEdge(0.0, outer);
  reach_m_ = std::hypot(end, outer);

  for (const Collision& part : arm_parts) {
    if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
      for (const Eigen::Vector3d& p : EdgePoints(*box)) {
        Ring point;
        point.centre = part.X_LG * p;
        arm_edges_.push_back({point, kCollisionMargin_m});
      }
      continue;
    }
    const Core core = CoreOf(part);
    if (core.rims.size() > 1) {  // a ball has no sides
      parts_.push_back({part.X_LG, TurnedSolid(Outline(core.rims)), core.rounding_m});
    }
    for (const Eigen::Vector2d& rim : core.rims) {
      Ring ring;
      ring.centre.z() = rim.x();
      ring.radius_m = rim.y();
      arm_edges_.push_back({part.X_LG * ring, core.rounding_m});
    }
  }
}

void Mating::Find(const Pose3& X_MA, double within_m, std::vector<MatingContact>& contacts) const {
  contacts.clear();
  MeetCone(X_MA, within_m, contacts);
  MeetArm(X_MA, within_m, contacts);
  for (MatingContact& contact : contacts) contact.on_face = IsOnFace(contact);
}

void Mating::MeetCone(const Pose3& X_MA, double within_m,
                      std::vector<MatingContact>& contacts) const {
  const Pose3 X_CA = Inverse(X_MC()) * X_MA;
  RingPoints points;
  int pair = 0;
  for (const Edge& edge : arm_edges_) {
    const Ring ring = X_CA * edge.ring;
    for (const TurnedSolid& solid : cone_) {
      ++pair;
      if (ring.centre.norm() > reach_m_ + ring.radius_m + within_m) continue;
      const int count = FindNearPoints(ring, solid, edge.radius_m + within_m, points);
      for (int i = 0; i < count; ++i) {
        const RingPoint& point = points[i];
        contacts.push_back({pair, X_MC() * (point.p - edge.radius_m * point.normal),
                            X_MC().R * point.normal, point.distance_m - edge.radius_m,
                            point.share});
      }
    }
  }
}

void Mating::MeetArm(const Pose3& X_MA, double within_m,
                     std::vector<MatingContact>& contacts) const {
  RingPoints points;
  int pair = 1000;
  for (const Part& part : parts_) {
    const Pose3 X_MP = X_MA * part.X_AP;
    const Pose3 X_PC = Inverse(X_MP) * X_MC();
    for (const Ring& edge : cone_edges_) {
      ++pair;
      const int count = FindNearPoints(X_PC * edge, part.core, part.rounding_m + within_m, points);
      for (int i = 0; i < count; ++i) {
        const RingPoint& point = points[i];
        if (!point.on_side) continue;  // edge to edge: found as the arm's edge on the wall
        contacts.push_back(
            {pair, X_MP * (point.p - (point.distance_m - part.rounding_m) * point.normal),
             -(X_MP.R * point.normal), point.distance_m - part.rounding_m, point.share});
      }
    }
  }
}

}  // namespace dockyard::axel
