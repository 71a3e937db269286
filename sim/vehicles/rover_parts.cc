#include "sim/vehicles/rover_parts.h"

#include <Eigen/Geometry>
#include <cmath>
#include <variant>

#include "models/parts/scoop_shape.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;
using namespace part_group;

// Of rockers and bogies; assumed, 10-40 mm.
constexpr double kBar_m = 0.02;
// The can's side starts so far behind its rim, which face_contact.h lets press; assumed, 5-20 mm.
constexpr double kBehindRim_m = 0.01;
constexpr int kCanCorners = 12;

struct Adder {
  const RoverModel& rover;
  const WheeledBody& body;
  double friction = 0.0;
  PartContacts& parts;

  void Add(int link, ConvexBody shape_L, ContactMaterial material, const PartGroups& groups) const {
    material.friction = friction;
    parts.Add({.at = {body.number(), link},
               .body_L = std::move(shape_L),
               .is_bar = (groups.group & (kChassis | kMast)) != 0,
               .material = material,
               .groups = groups});
  }
};

void AddWheels(const Adder& to) {
  for (int wheel = 0; wheel < to.body.wheel_count(); ++wheel) {
    ContactMaterial material = to.rover.contacts.wheels;
    material.friction = to.friction;
    to.parts.Add({.at = {to.body.number(), to.body.wheel_link(wheel)},
                  .body_L = WheelHull(to.rover.tyre),
                  .wheel = to.rover.tyre,
                  .material = material,
                  .groups = {kWheels, kStones}});
  }
}

void AddChassis(const Adder& to) {
  const PartGroups groups{kChassis, kStones | kMast};
  const ContactMaterial& material = to.rover.contacts.body;
  const LinkModel& body = to.rover.body;
  const auto* box = std::get_if<BoxShape>(&body.collisions.front().shape);
  to.Add(0, BoxAt(body.p_LoCom_L, box->size_m), material, groups);
  const double top_m = body.p_LoCom_L.z() + 0.5 * box->size_m.z();
  for (const Polygon& outline : to.rover.plan.body) {
    std::vector<Vector3d> points;
    for (const Eigen::Vector2d& corner : outline) {
      points.emplace_back(corner.x(), corner.y(), top_m);
      points.emplace_back(corner.x(), corner.y(), top_m + kPanel_m);
    }
    to.Add(0, HullOf(points), material, groups);
  }
  // From the hinge of a rocker or a bogie to those that it carries.
  const TreeBody& tree = to.body.tree();
  for (int i = 1; i < tree.link_count(); ++i) {
    const TreeLink& link = tree.link(i);
    if (!to.body.IsSuspension(link.parent) || link.p_PL.norm() <= kBar_m) continue;
    to.Add(link.parent, BarBetween(Vector3d::Zero(), link.p_PL, kBar_m), material, groups);
  }
}

void AddArm(const Adder& to) {
  const PartGroups groups{kArm, kStones | kMast};
  const ContactMaterial& material = to.rover.contacts.arm;
  const ArmModel& arm = *to.rover.arm;
  to.Add(to.body.arm().link(kArmPitch), HullOf(ArmBar(arm).vertices), material, groups);
  for (const int scoop : {kFrontScoop, kBackScoop}) {
    for (const TriangleMesh& plate : ScoopPlates(arm.scoop, scoop == kFrontScoop)) {
      to.Add(to.body.arm().link(scoop), HullOf(plate.vertices), material, groups);
    }
  }
}

ConvexBody CanSide(const MastModel& mast) {
  const InstrumentModel& can = mast.instrument;
  const double front_m = mast.link2_m - can.switch_out_m - kBehindRim_m;
  std::vector<Vector3d> points;
  for (int i = 0; i < kCanCorners; ++i) {
    const double angle = 2.0 * kPi * i / kCanCorners;
    for (const double x_m : {mast.link2_m - can.length_m, front_m}) {
      points.emplace_back(x_m, can.radius_m * std::cos(angle), can.radius_m * std::sin(angle));
    }
  }
  return HullOf(points);
}

void AddMast(const Adder& to) {
  const PartGroups groups{kMast, kStones | kChassis | kArm};
  const ContactMaterial& material = to.rover.contacts.body;
  const MastModel& mast = *to.rover.mast;
  const double can_m = mast.link2_m - mast.instrument.length_m;
  to.Add(to.body.mast_link(kMastShoulder),
         BarBetween(Vector3d::Zero(), {mast.link1_m, 0.0, 0.0}, kMastBar_m), material, groups);
  to.Add(to.body.mast_link(kMastElbow), BarBetween(Vector3d::Zero(), {can_m, 0.0, 0.0}, kMastBar_m),
         material, groups);
  to.Add(to.body.mast_link(kMastCan), CanSide(mast), material, groups);
}

}  // namespace

ConvexBody BoxAt(const Vector3d& centre, const Vector3d& size_m) {
  std::vector<Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    corners.push_back(centre + corner.cwiseProduct(size_m));
  }
  return HullOf(corners);
}

ConvexBody BarBetween(const Vector3d& from, const Vector3d& to, double thick_m) {
  const Vector3d along = to - from;
  const Pose3 X_LV{Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), along).toRotationMatrix(),
                   0.5 * (from + to)};
  return X_LV * BoxAt(Vector3d::Zero(), {along.norm(), thick_m, thick_m});
}

void AddRoverParts(const RoverModel& rover, const WheeledBody& body, double friction,
                   PartContacts& parts) {
  const Adder to{rover, body, friction, parts};
  AddWheels(to);
  AddChassis(to);
  if (rover.arm) AddArm(to);
  if (rover.mast) AddMast(to);
}

}  // namespace dockyard
