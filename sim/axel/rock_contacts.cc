#include "sim/axel/rock_contacts.h"

#include <algorithm>
#include <utility>

#include "sim/vehicles/wheel_contact.h"

namespace dockyard::axel {
namespace {

// The list of near rocks is good for this way of a link [m].
constexpr double kSlack_m = 0.05;
// More features than any link has with one rock.
constexpr std::int64_t kMostFeatures = 1 << 20;

ConvexBody BoxHull(const Eigen::Vector3d& size_m) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back(size_m.cwiseProduct(
        Eigen::Vector3d(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5)));
  }
  return HullOf(points);
}

Cylinder AlongZ(const Pose3& X_LG, double from_m, double to_m, double radius_m) {
  return {X_LG * Eigen::Vector3d(0.0, 0.0, 0.5 * (from_m + to_m)), X_LG.R.col(2), radius_m,
          0.5 * (to_m - from_m)};
}

Cylinder operator*(const Pose3& X_GL, const Cylinder& cylinder) {
  return {X_GL * cylinder.centre, X_GL.R * cylinder.axis, cylinder.radius_m, cylinder.half_m};
}

}  // namespace

RockContacts::RockContacts(const RoverModel& rover, const std::vector<Collision>& arm_parts,
                           std::vector<ConvexBody> rocks)
    : rocks_(std::move(rocks)) {
  const auto count = static_cast<std::size_t>(LinkCount(rover));
  shapes_.resize(count);
  near_.resize(count);
  if (rocks_.empty()) return;
  shapes_[static_cast<std::size_t>(RoverLink::kBody)] = ShapeOf(rover.body.collisions);
  shapes_[static_cast<std::size_t>(RoverLink::kArm)] = ShapeOf(arm_parts);
  const auto AddWheel = [&](RoverLink link, const WheelModel& wheel) {
    Shape& shape = shapes_[static_cast<std::size_t>(link)];
    shape.wheels = {wheel};
    shape.radius_m = std::hypot(RollingRadius(wheel), 0.5 * wheel.width_m);
  };
  AddWheel(RoverLink::kLeftWheel, rover.left_wheel_soil);
  AddWheel(RoverLink::kRightWheel, rover.right_wheel_soil);
  for (std::size_t i = kOwnLinkCount; i < count; ++i) {
    shapes_[i] = ShapeOf(LinkOf(rover, static_cast<RoverLink>(i)).collisions);
  }
}

// A ball counts as a cylinder as long as it is wide, a turned part as one for each of its pieces.
RockContacts::Shape RockContacts::ShapeOf(const std::vector<Collision>& collisions) {
  Shape shape;
  for (const Collision& part : collisions) {
    const Pose3& X = part.X_LG;
    if (const auto* box = std::get_if<BoxShape>(&part.shape)) {
      shape.hulls.push_back(X * BoxHull(box->size_m));
    } else if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
      const double half_m = 0.5 * cylinder->length_m;
      shape.cylinders.push_back(AlongZ(X, -half_m, half_m, cylinder->radius_m));
    } else if (const auto* sphere = std::get_if<SphereShape>(&part.shape)) {
      shape.cylinders.push_back(AlongZ(X, -sphere->radius_m, sphere->radius_m, sphere->radius_m));
    } else if (std::holds_alternative<HullShape>(part.shape)) {
      shape.hulls.push_back(SolidOf(part));
    } else if (const auto* turned = std::get_if<TurnedShape>(&part.shape)) {
      for (std::size_t i = 1; i < turned->profile_m.size(); ++i) {
        const Eigen::Vector2d &a = turned->profile_m[i - 1], &b = turned->profile_m[i];
        if (b.x() > a.x()) {
          shape.cylinders.push_back(AlongZ(X, a.x(), b.x(), std::max(a.y(), b.y())));
        }
      }
    }
  }
  // About the middle of the parts' middles.
  double parts = 0.0;
  for (const Cylinder& cylinder : shape.cylinders) shape.centre += cylinder.centre, parts += 1.0;
  for (const ConvexBody& hull : shape.hulls) shape.centre += hull.centre, parts += 1.0;
  if (parts > 0.0) shape.centre /= parts;
  const auto Hold = [&](const Eigen::Vector3d& centre, double radius_m) {
    shape.radius_m = std::max(shape.radius_m, (centre - shape.centre).norm() + radius_m);
  };
  for (const Cylinder& c : shape.cylinders) Hold(c.centre, std::hypot(c.radius_m, c.half_m));
  for (const ConvexBody& hull : shape.hulls) Hold(hull.centre, hull.radius_m);
  return shape;
}

void RockContacts::AddContacts(const Shape& shape, const Pose3& X_GL, const ConvexBody& rock) {
  for (const WheelModel& wheel : shape.wheels) AddWheelContacts(rock, wheel, X_GL, found_);
  int feature = 0;
  for (const Cylinder& cylinder : shape.cylinders) {
    AddCylinderContacts(rock, X_GL * cylinder, feature, found_);
    feature += 2;
  }
  for (const ConvexBody& hull : shape.hulls) {
    AddHullContacts(rock, X_GL * hull, feature, found_);
    feature += static_cast<int>(hull.edges.size() + rock.edges.size());
  }
}

void RockContacts::Find(const RoverBody& rover, std::vector<RockContact>& contacts) {
  contacts.clear();
  if (rocks_.empty()) return;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    const Shape& shape = shapes_[i];
    const Pose3& X_GL = rover.motion(link).X_GL;
    const Eigen::Vector3d centre_G = X_GL * shape.centre;
    Near& near = near_[i];
    if (!near.known || (near.p_G - centre_G).squaredNorm() > kSlack_m * kSlack_m) {
      near = {centre_G, {}, true};
      for (std::size_t rock = 0; rock < rocks_.size(); ++rock) {
        const double reach_m = rocks_[rock].radius_m + shape.radius_m + kSlack_m;
        if ((rocks_[rock].centre - centre_G).squaredNorm() < reach_m * reach_m) {
          near.rocks.push_back(static_cast<int>(rock));
        }
      }
    }
    for (const int rock : near.rocks) {
      found_.clear();
      AddContacts(shape, X_GL, rocks_[rock]);
      for (const BodyContact& contact : found_) {
        const int surfaces = rock * rover.link_count() + static_cast<int>(i);
        contacts.push_back({link, surfaces * kMostFeatures + contact.feature, contact});
      }
    }
  }
}

double RockContacts::Depth(RoverLink link, const Pose3& X_GL) {
  double depth_m = 0.0;
  for (const ConvexBody& rock : rocks_) {
    found_.clear();
    AddContacts(shapes_[static_cast<std::size_t>(link)], X_GL, rock);
    for (const BodyContact& contact : found_) depth_m = std::max(depth_m, contact.depth_m);
  }
  return depth_m;
}

}  // namespace dockyard::axel
