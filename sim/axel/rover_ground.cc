#include "sim/axel/rover_ground.h"

#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::axel {
namespace {

GroundMaterial MakeMaterial(const ArmTipModel& tip, double mass_kg) {
  const double critical = 2.0 * std::sqrt(tip.ground_stiffness_n_per_m * mass_kg);
  return {tip.ground_stiffness_n_per_m, tip.ground_damping_ratio * critical, tip.ground_friction};
}

// Round plates that bear like parts of a body in soil. Two rims of the tip share a plate of its
// diameter: at 17 deg to the ground the arm's end covers about that area. Four corners of a box
// share its smallest face. The two ends of a lying cylinder share a strip as wide as its radius,
// the chord of one that is in by an eighth of it, and so a sphere has its radius. All are assumed,
// range half to twice of each.
double TipPlate(double radius_m) { return std::sqrt(2.0) * radius_m; }
double CornerPlate(const Eigen::Vector3d& size_m) {
  return std::sqrt(size_m.prod() / size_m.maxCoeff() / kPi);
}
double EndPlate(double radius_m, double length_m) {
  return std::sqrt(2.0 * radius_m * length_m / kPi);
}
// Of a corner of a convex hull. Assumed, range 0.01-0.1 m.
constexpr double kHullPlate_m = 0.03;

}  // namespace

RoverGround::RoverGround(const RoverModel& rover, const std::vector<SoilModel>& marked_soils) {
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
    rim.plate_m = TipPlate(rover.tip.radius_m);
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
  if (marked_soils.empty()) return;
  marks_.emplace(marked_soils);
  for (const Rim& rim : rims_) marks_->Add(rim.material, rim.plate_m);
}

void RoverGround::AddShape(RoverLink link, const GroundMaterial& material,
                           const Collision& collision) {
  const Pose3& X = collision.X_LG;
  const auto Add = [&](const Eigen::Vector3d& p_G, const Eigen::Vector3d& axis_G, double radius,
                       double plate_m) {
    Rim rim;
    rim.plate_m = plate_m;
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
      Add(sign.cwiseProduct(box->size_m), none, 0.0, CornerPlate(box->size_m));
    }
  } else if (const auto* cylinder = std::get_if<CylinderShape>(&collision.shape)) {
    for (double end : {-0.5, 0.5}) {
      Add(Eigen::Vector3d(0.0, 0.0, end * cylinder->length_m), Eigen::Vector3d::UnitZ(),
          cylinder->radius_m, EndPlate(cylinder->radius_m, cylinder->length_m));
    }
  } else if (const auto* sphere = std::get_if<SphereShape>(&collision.shape)) {
    Add(none, none, sphere->radius_m, sphere->radius_m);
  } else if (const auto* hull = std::get_if<HullShape>(&collision.shape)) {
    for (const Eigen::Vector3d& p : hull->points) Add(p, none, 0.0, kHullPlate_m);
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

Eigen::Vector3d RoverGround::Force(HeightGrid& ground, std::size_t rim, const Eigen::Vector3d& p_G,
                                   const Eigen::Vector3d& v_G, double dt_s) {
  if (marks_) return marks_->Step(ground, rim, p_G, v_G, dt_s);
  return GroundForce(ground, rims_[rim].material, p_G, v_G, dt_s, rims_[rim].contact);
}

void RoverGround::AddForces(HeightGrid& ground, double dt_s, RoverBody& rover) {
  Eigen::Vector3d on_tip = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < rims_.size(); ++i) {
    const Rim& rim = rims_[i];
    const LinkMotion& link = rover.motion(rim.link);
    const Eigen::Vector3d p_G = LowestPoint(rim, link.X_GL);
    const bool is_tip = rim.link == RoverLink::kArm;
    const Eigen::Vector3d force_G = Force(ground, i, p_G, link.VelocityAt(p_G), dt_s);
    if (force_G.isZero(0.0)) continue;
    rover.AddForce(rim.link, force_G, p_G);
    if (is_tip) on_tip += force_G;
  }
  if (marks_) marks_->Slump(ground, dt_s);
  tip_force_n_ = on_tip.norm();
}

std::uint64_t RoverGround::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Rim& rim : rims_) hash = HashPoint(hash, rim.contact);
  return marks_ ? marks_->StateHash(hash) : hash;
}

}  // namespace dockyard::axel
