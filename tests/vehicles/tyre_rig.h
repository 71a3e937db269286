// Small robots on tyres for tests: a box with wheels and casters on a level floor.
#pragma once

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "rigid/world_scenes.h"
#include "sim/base/hash.h"
#include "sim/rigid/convex_body.h"
#include "sim/vehicles/floor_contacts.h"
#include "sim/vehicles/tyres.h"

namespace dockyard {

inline constexpr double kG_m_s2 = kEarthGravity_m_s2;

/// A rigid floor on which rubber has this friction, 40 m long and wide.
inline FirmGround LevelFloor(double friction) {
  FirmGround ground{LevelGrid(-20.0, 40.0, 40.0, 0.5), {FloorModel{}}};
  ground.floors[0].friction = friction;
  return ground;
}

inline TyreModel RubberTyre(double radius_m, double width_m) {
  TyreModel tyre;
  tyre.radius_m = radius_m;
  tyre.width_m = width_m;
  tyre.rolling_resistance_m = 0.0;
  return tyre;
}

/// A disc that turns about y.
inline LinkModel WheelLink(double mass_kg, double radius_m) {
  LinkModel model;
  model.mass_kg = mass_kg;
  const double across = 0.25 * mass_kg * radius_m * radius_m;
  model.I_LCom_L.diagonal() = Eigen::Vector3d(across, 2.0 * across, across);
  return model;
}

inline ConvexBody BoxHull(const Eigen::Vector3d& centre_m, const Eigen::Vector3d& size_m) {
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d side(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    corners.push_back(centre_m + side.cwiseProduct(size_m));
  }
  return HullOf(corners);
}

/// Links and tyres as they are added; then a world of them.
struct CartPlan {
  static constexpr double kDrive_nms_per_rad = 20.0;
  std::vector<TreeLink> links;
  std::vector<Tyre> tyres;

  explicit CartPlan(const LinkModel& body) { links.push_back(BaseLink(body)); }

  int Add(const TreeLink& link) {
    links.push_back(link);
    return static_cast<int>(links.size()) - 1;
  }
  int AddSwivel(int parent, const Eigen::Vector3d& p_PL, double mass_kg = 0.05) {
    return Add(
        JointedLink(parent, BoxModel(mass_kg, {0.03, 0.03, 0.03}), p_PL, Eigen::Vector3d::UnitZ()));
  }
  /// A wheel on an axle along y.
  int AddWheel(int parent, const Eigen::Vector3d& p_PL, const TyreModel& tyre,
               double mass_kg = 0.1) {
    const int link =
        Add(JointedLink(parent, WheelLink(mass_kg, tyre.radius_m), p_PL, Eigen::Vector3d::UnitY()));
    tyres.push_back({.link = link, .model = tyre});
    return link;
  }
  /// A wheel with a stiff drive: a damper between its rate and the one wanted.
  int AddDriven(int parent, const Eigen::Vector3d& p_PL, const TyreModel& tyre) {
    const int link = AddWheel(parent, p_PL, tyre);
    links.back().damping_nms_per_rad = kDrive_nms_per_rad;
    return link;
  }
  /// A tyre that does not turn against its link.
  void Fix(int link, const Eigen::Vector3d& p_LK, const TyreModel& tyre) {
    tyres.push_back({.link = link, .model = tyre, .p_LK = p_LK});
  }
  double mass_kg() const {
    double sum_kg = 0.0;
    for (const TreeLink& link : links) sum_kg += link.model.mass_kg;
    return sum_kg;
  }
};

/// A cart in its world.
class Cart {
 public:
  Cart(const CartPlan& plan, FirmGround ground, double step_s, const Pose3& X_GB,
       const TreeRules& rules = {})
      : ground_(std::make_unique<FirmGround>(std::move(ground))),
        world_(std::make_unique<RigidWorld>(kDown)),
        step_s_(step_s) {
    number_ = world_->Add(TreeBody(plan.links, {}, X_GB, rules));
    tyres_ = std::make_unique<Tyres>(*world_, *ground_, number_, plan.tyres);
  }

  RigidWorld& world() { return *world_; }
  TreeBody& tree() { return world_->body(number_); }
  const LinkMotion& body() const { return std::as_const(*world_).body(number_).motion(0); }
  TyreTruth tyre(int i) const { return tyres_->truth(i, step_s_); }
  void Step() {
    tyres_->AddContacts(step_s_);
    world_->Step(step_s_);
  }
  /// before(): loads of each step.
  template <class Before>
  void Run(double seconds, const Before& before) {
    for (long i = 0; i < std::lround(seconds / step_s_); ++i) {
      before();
      Step();
    }
  }
  void Run(double seconds) {
    Run(seconds, [] {});
  }
  /// Turns a wheel of AddDriven at a rate in the next step.
  void Drive(int link, double rate_rad_s) {
    tree().AddJointTorque(link, CartPlan::kDrive_nms_per_rad * rate_rad_s);
  }
  double heading_rad() const {
    const Eigen::Matrix3d& R = body().X_GL.R;
    return std::atan2(R(1, 0), R(0, 0));
  }

 private:
  std::unique_ptr<FirmGround> ground_;
  std::unique_ptr<RigidWorld> world_;
  std::unique_ptr<Tyres> tyres_;
  int number_ = 0;
  double step_s_ = 0.0;
};

}  // namespace dockyard
