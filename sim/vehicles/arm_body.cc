#include "sim/vehicles/arm_body.h"

#include "models/parts/scoop_shape.h"
#include "sim/rigid/solid_link.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Share of the arm's mass in the shoulder's housing, which only rolls; assumed, 0.1-0.4. It is a
// block of this size; assumed, 0.03-0.08.
constexpr double kShoulderShare = 0.2, kShoulder_m = 0.05;

SolidMass ScoopMass(const ScoopModel& scoop, bool front) {
  std::vector<SolidMass> plates;
  for (const TriangleMesh& plate : ScoopPlates(scoop, front)) {
    plates.push_back(MassOf(HullOf(plate.vertices), 1.0));
  }
  SolidMass whole = Together(plates);
  whole.I_com *= scoop.mass_kg / whole.mass_kg;
  whole.mass_kg = scoop.mass_kg;
  return whole;
}

SolidMass ShoulderMass(const ArmModel& arm) {
  const double mass_kg = kShoulderShare * arm.mass_kg;
  const double moment = mass_kg * kShoulder_m * kShoulder_m / 6.0;
  return {mass_kg, Vector3d::Zero(), moment * Eigen::Matrix3d::Identity()};
}

SolidMass BarMass(const ArmModel& arm) {
  const double mass_kg = (1.0 - kShoulderShare) * arm.mass_kg;
  const ConvexBody bar = HullOf(ArmBar(arm).vertices);
  return MassOf(bar, mass_kg / MassOf(bar, 1.0).mass_kg);
}

}  // namespace

std::vector<TreeLink> ArmLinks(const ArmModel& arm, int first) {
  const Vector3d end(arm.length_m, 0.0, 0.0), y = Vector3d::UnitY();
  const double rotor = arm.scoop_motor.reflected_inertia_kg_m2;
  return {SolidLink(0, arm.p_RA, Vector3d::UnitX(), ShoulderMass(arm),
                    arm.roll.reflected_inertia_kg_m2),
          SolidLink(first + kArmRoll, Vector3d::Zero(), y, BarMass(arm),
                    arm.pitch.reflected_inertia_kg_m2),
          SolidLink(first + kArmPitch, end, y, ScoopMass(arm.scoop, true), rotor),
          SolidLink(first + kArmPitch, end, y, ScoopMass(arm.scoop, false), rotor)};
}

double ArmInertia(const ArmModel& arm, int motor) {
  const auto AboutHinge = [](const SolidMass& mass, const Vector3d& axis) {
    const double off2 = mass.p_com.cross(axis).squaredNorm();
    return axis.dot(mass.I_com * axis) + mass.mass_kg * off2;
  };
  if (motor == kArmRoll) {
    return arm.roll.reflected_inertia_kg_m2 + AboutHinge(ShoulderMass(arm), Vector3d::UnitX());
  }
  if (motor == kArmPitch) {
    return arm.pitch.reflected_inertia_kg_m2 + AboutHinge(BarMass(arm), Vector3d::UnitY());
  }
  return arm.scoop_motor.reflected_inertia_kg_m2 +
         AboutHinge(ScoopMass(arm.scoop, true), Vector3d::UnitY());
}

void LimitArm(const ArmModel& arm, const BodyLink& first, RigidWorld& world) {
  const auto Link = [&](int motor) { return BodyLink{first.body, first.link + motor}; };
  world.Limit(Link(kArmRoll), StopsAt(arm.stop, -arm.roll_stop_rad, arm.roll_stop_rad));
  world.Limit(Link(kArmPitch), StopsAt(arm.stop, arm.pitch_low_rad, arm.pitch_high_rad));
  for (const int scoop : {kFrontScoop, kBackScoop}) {
    world.Limit(Link(scoop), StopsAt(arm.scoop.stop, arm.scoop_low_rad, arm.scoop_high_rad));
  }
  world.LimitBetween(Link(kBackScoop), first.link + kFrontScoop,
                     StopsAt(arm.scoop.stop, 0.0, MostOpen_rad(arm.scoop)));
}

ArmBody::ArmBody(const ArmModel& arm, int first, const std::vector<SoilModel>& soils)
    : model_(arm),
      first_(first),
      soils_{ScoopSoil(arm.scoop, false, soils), ScoopSoil(arm.scoop, true, soils)},
      carried_(arm.scoop, soils) {}

void ArmBody::Stow(TreeBody& tree) const {
  tree.SetAngle(link(kArmPitch), model_.stowed_pitch_rad);
  tree.SetAngle(link(kFrontScoop), model_.stowed_scoop_rad);
  tree.SetAngle(link(kBackScoop), model_.stowed_scoop_rad);
}

void ArmBody::AddSoilLoads(TreeBody& tree, HeightGrid& ground, double step_s) {
  for (const bool is_front : {false, true}) {
    const int i = link(is_front ? kFrontScoop : kBackScoop);
    const LinkMotion& motion = tree.motion(i);
    const ScoopLoad load = soils_[is_front].Step(ground, motion, step_s);
    tree.AddForce(i, load.force_G, motion.X_GL.p);
    tree.AddTorque(i, load.torque_G);
  }
  const int front = link(kFrontScoop), back = link(kBackScoop);
  const auto loads = carried_.Step(ground, {&tree.motion(front), &tree.motion(back)},
                                   tree.angle_rad(back) - tree.angle_rad(front));
  for (const std::size_t side : {0u, 1u}) {
    const int i = side == 0 ? front : back;
    tree.AddForce(i, loads[side].force_G, tree.motion(i).X_GL.p);
    tree.AddTorque(i, loads[side].torque_G);
  }
}

std::uint64_t ArmBody::StateHash(std::uint64_t seed) const {
  return carried_.StateHash(soils_[1].StateHash(soils_[0].StateHash(seed)));
}

}  // namespace dockyard
