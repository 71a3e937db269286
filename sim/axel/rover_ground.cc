#include "sim/axel/rover_ground.h"

#include <cmath>

namespace dockyard::axel {
namespace {

GroundMaterial MakeMaterial(const ArmTipModel& tip, double mass_kg) {
  const double critical = 2.0 * std::sqrt(tip.ground_stiffness_n_per_m * mass_kg);
  return {tip.ground_stiffness_n_per_m, tip.ground_damping_ratio * critical, tip.ground_friction};
}

}  // namespace

RoverGround::RoverGround(const RoverModel& rover) {
  // The mass that the ground meets at the end of a slender arm on a hinge: a third of the arm's.
  const GroundMaterial of_tip = MakeMaterial(rover.tip, rover.arm.mass_kg / 3.0);
  // Four corners carry a body that has tumbled.
  const GroundMaterial of_body = MakeMaterial(rover.tip, rover.mass_kg() / 4.0);
  for (double x : {rover.arm_length_m, rover.arm_length_m - rover.tip.length_m}) {
    Rim rim;
    rim.link = RoverLink::kArm;
    rim.p_L = Eigen::Vector3d(x, 0.0, 0.0);
    rim.axis_L = Eigen::Vector3d::UnitX();
    rim.radius_m = rover.tip.radius_m;
    rim.material = of_tip;
    rims_.push_back(rim);
  }
  for (int i = 0; i < LinkCount(rover); ++i) {
    const RoverLink link = static_cast<RoverLink>(i);
    if (link != RoverLink::kBody && i < kOwnLinkCount) continue;
    const LinkModel& model = LinkOf(rover, link);
    // The ground may carry a further link alone, such as a trailer's wheel.
    const GroundMaterial material =
        link == RoverLink::kBody ? of_body : MakeMaterial(rover.tip, model.mass_kg);
    for (const Collision& part : model.collisions) AddShape(link, material, part);
  }
}

void RoverGround::AddShape(RoverLink link, const GroundMaterial& material,
                           const Collision& collision) {
  const Pose3& X = collision.X_LG;
  const auto Add = [&](const Eigen::Vector3d& p_G, const Eigen::Vector3d& axis_G, double radius) {
    Rim rim;
    rim.link = link;
    rim.p_L = X * p_G;
    rim.axis_L = X.R * axis_G;
    rim.radius_m = radius;
    rim.material = material;
    rims_.push_back(rim);
  };
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  if (const auto* box = std::get_if<BoxShape>(&collision.shape)) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                                 corner & 4 ? 0.5 : -0.5);
      Add(sign.cwiseProduct(box->size_m), none, 0.0);
    }
  } else if (const auto* cylinder = std::get_if<CylinderShape>(&collision.shape)) {
    for (double end : {-0.5, 0.5}) {
      Add(Eigen::Vector3d(0.0, 0.0, end * cylinder->length_m), Eigen::Vector3d::UnitZ(),
          cylinder->radius_m);
    }
  } else if (const auto* sphere = std::get_if<SphereShape>(&collision.shape)) {
    Add(none, none, sphere->radius_m);
  } else if (const auto* hull = std::get_if<HullShape>(&collision.shape)) {
    for (const Eigen::Vector3d& p : hull->points) Add(p, none, 0.0);
  }
}

Eigen::Vector3d RoverGround::LowestPoint(const Rim& rim, const Pose3& X_GL) {
  const Eigen::Vector3d centre = X_GL * rim.p_L;
  if (rim.radius_m == 0.0) return centre;
  const Eigen::Vector3d axis = X_GL.R * rim.axis_L;
  const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ() + axis.z() * axis;
  const double size = down.norm();
  return size > 1e-9 ? Eigen::Vector3d(centre + (rim.radius_m / size) * down) : centre;
}

void RoverGround::AddForces(const HeightGrid& ground, double dt_s, RoverBody& rover) {
  Eigen::Vector3d on_tip = Eigen::Vector3d::Zero();
  for (Rim& rim : rims_) {
    const LinkMotion& link = rover.motion(rim.link);
    const Eigen::Vector3d p_G = LowestPoint(rim, link.X_GL);
    const bool is_tip = rim.link == RoverLink::kArm;
    const Eigen::Vector3d force_G =
        GroundForce(ground, rim.material, p_G, link.VelocityAt(p_G), dt_s, rim.contact);
    if (force_G.isZero(0.0)) continue;
    rover.AddForce(rim.link, force_G, p_G);
    if (is_tip) on_tip += force_G;
  }
  tip_force_n_ = on_tip.norm();
}

std::uint64_t RoverGround::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Rim& rim : rims_) hash = HashPoint(hash, rim.contact);
  return hash;
}

}  // namespace dockyard::axel
