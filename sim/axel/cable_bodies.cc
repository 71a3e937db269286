// What the tether touches: wheels, body, the station and rocks, as convex solids.
#include <variant>

#include "sim/axel/cable_tether.h"
#include "sim/axel/cone_shapes.h"

namespace dockyard::axel {
namespace {

// Sides of a prism that stands for a round part: one of 0.16 m differs from it by 5 mm at most.
constexpr int kSides = 12;
constexpr int kConeSides = 24;

// The wheel as the cable meets it: a prism over the paddles' tips. The cable lies across them.
CableBody WheelBody(const WheelModel& wheel, double friction) {
  const int sides = wheel.paddle_count >= 6 ? wheel.paddle_count : 2 * kSides;
  // The prism's z is the wheel's -y: its angles count about +y as the paddles' do.
  return CablePrism(RollingRadius(wheel), wheel.width_m, sides, -wheel.phase_rad, friction);
}

}  // namespace

void CableTether::AddBody(const CableBody& body, const Carried& carried) {
  bodies_.push_back(body);
  carried_.push_back(carried);
}

void CableTether::AddShapes(const std::vector<Collision>& collisions, const Carried& carried,
                            double friction) {
  for (const Collision& collision : collisions) {
    Carried own = carried;
    own.X_LB = carried.X_LB * collision.X_LG;
    if (const auto* box = std::get_if<BoxShape>(&collision.shape)) {
      AddBody(CableBox(box->size_m, friction), own);
    } else if (const auto* cylinder = std::get_if<CylinderShape>(&collision.shape)) {
      AddBody(CablePrism(cylinder->radius_m, cylinder->length_m, kSides, 0.0, friction), own);
    } else if (const auto* sphere = std::get_if<SphereShape>(&collision.shape)) {
      AddBody(CablePrism(sphere->radius_m, 2.0 * sphere->radius_m, kSides, 0.0, friction), own);
    } else {
      const ConvexBody solid = SolidOf(collision);
      own.X_LB = carried.X_LB * Pose3{Eigen::Matrix3d::Identity(), solid.centre};
      AddBody(CableRock(solid, friction), own);
    }
  }
}

CableTether::CableTether(const RoverModel& rover, const StationModel& station,
                         const std::vector<ConvexBody>& rocks)
    : model_(rover.tether),
      arm_length_m_(rover.arm_length_m),
      mouth_radius_m_(station.cone.mouth_radius_m),
      cable_({.axial_stiffness_n = rover.tether.axial_stiffness_n,
              .damping_ns_per_m = rover.tether.damping_ns_per_m,
              .diameter_m = rover.tether.diameter_m,
              .mass_kg_per_m = rover.tether.mass_kg_per_m,
              .friction_on_ground = rover.tether.friction_on_ground,
              .inside_m = rover.arm_length_m}),
      inner_(rover.tether, station, rover.arm_length_m) {
  spacing_m_ = CableModel{}.spacing_m;
  const Pose3 X_KB{RotX(0.5 * kPi), Eigen::Vector3d::Zero()};
  const double on_rover = model_.friction_on_rover, on_station = model_.friction_on_station;
  AddBody(WheelBody(rover.left_wheel_soil, on_rover),
          {Carrier::kRover, RoverLink::kLeftWheel, X_KB});
  AddBody(WheelBody(rover.right_wheel_soil, on_rover),
          {Carrier::kRover, RoverLink::kRightWheel, X_KB});
  AddShapes(rover.body.collisions, {Carrier::kRover, RoverLink::kBody, {}}, on_rover);
  for (int i = kOwnLinkCount; i < LinkCount(rover); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    AddShapes(LinkOf(rover, link).collisions, {Carrier::kRover, link, {}}, on_rover);
  }
  // The cone's block with its hole, and the module, both in S.
  const Collision block = ConeBlock(station.cone);
  const auto& round = std::get<CylinderShape>(block.shape);
  CableBody cone = CablePrism(round.radius_m, round.length_m, kConeSides, 0.0, on_station);
  cone.hole_radius_m = mouth_radius_m_;
  const Pose3 X_SM = MouthInStation(station);
  AddBody(cone, {Carrier::kStation, RoverLink::kBody, X_SM * block.X_LG});
  const Pose3 X_SL = X_SM * Pose3::Translation(0.0, 0.0, -station.mouth_height_m);
  AddShapes(station.module.collisions, {Carrier::kStation, RoverLink::kBody, X_SL}, on_station);
  for (const ConvexBody& rock : rocks) {
    AddBody(CableRock(rock, model_.friction_on_rock), {});
  }
}

void CableTether::PlaceBodies(const RoverBody& rover, const StationBody& station, bool still) {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Carried& carried = carried_[i];
    if (carried.by == Carrier::kGround) continue;
    const LinkMotion& link =
        carried.by == Carrier::kRover ? rover.motion(carried.link) : station.motion();
    LinkMotion& own = bodies_[i].motion;
    own.X_GL = link.X_GL * carried.X_LB;
    own.v_GL_G = Eigen::Vector3d::Zero();
    own.w_GL_G = Eigen::Vector3d::Zero();
    if (still) continue;
    own.v_GL_G = link.VelocityAt(own.X_GL.p);
    own.w_GL_G = link.w_GL_G;
  }
}

}  // namespace dockyard::axel
