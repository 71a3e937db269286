#include "sim/vehicles/jointed_links.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/hash.h"

namespace dockyard {
namespace {

// Without what is drawn and what touches.
LinkModel InertialOf(const LinkModel& link) {
  return {link.name, link.mass_kg, link.p_LoCom_L, link.I_LCom_L, {}, {}};
}

std::size_t At(int i) { return static_cast<std::size_t>(i); }

// Of the joint, for each radian of its motor's output.
double TravelPerRad(const JointedLink& link) {
  return link.slides ? link.motor->lead_m_per_turn / (2.0 * kPi) : 1.0;
}

// Of the link alone about its joint's axis; of a slide its mass.
double OwnInertia(const JointedLink& each) {
  const LinkModel& link = each.link;
  if (each.slides) return link.mass_kg;
  const Eigen::Vector3d out = each.axis_L.cross(link.p_LoCom_L);
  return each.axis_L.dot(link.I_LCom_L * each.axis_L) + link.mass_kg * out.squaredNorm();
}

bool HasStops(const JointedLink& link) {
  return std::isfinite(link.low_rad) || std::isfinite(link.high_rad);
}

}  // namespace

TreePlaces AddJointedLinks(const JointedLinks& further, TreePlaces own,
                           std::vector<TreeLink>& links) {
  for (const JointedLink& each : further.links) {
    TreeLink& link = links.emplace_back();
    link.model = InertialOf(each.link);
    link.parent = own[At(each.carrier)];
    link.p_PL = each.X_PL.p;
    link.R_PL = each.X_PL.R;
    link.axis_L = each.axis_L;
    link.joint = each.slides ? JointKind::kSlide : JointKind::kHinge;
    link.damping_nms_per_rad = each.damping_nms_per_rad;
    link.stiffness_nm_per_rad = each.spring_nm_per_rad;
    link.rest_rad = each.rest_rad;
    if (each.motor) {
      const double travel = TravelPerRad(each);
      link.rotor_kg_m2 = each.motor->model.reflected_inertia_kg_m2 / (travel * travel);
    }
    own.push_back(static_cast<int>(links.size()) - 1);
  }
  return own;
}

std::vector<JointTie> TiesOf(const JointedLinks& further, const TreePlaces& places) {
  std::vector<JointTie> ties;
  for (const JointRatio& ratio : further.ratios) {
    ties.push_back({{places[At(ratio.link)], 1.0}, {places[At(ratio.other)], -ratio.ratio}});
  }
  return ties;
}

void SetStartAngles(const JointedLinks& further, const TreePlaces& places, TreeBody& tree) {
  const std::size_t own = places.size() - further.links.size();
  for (std::size_t i = 0; i < further.links.size(); ++i) {
    tree.SetAngle(places[own + i], further.links[i].start_rad);
  }
  for (const JointRatio& ratio : further.ratios) {
    const double other_rad = tree.angle_rad(places[At(ratio.other)]);
    tree.SetAngle(places[At(ratio.link)], ratio.ratio * other_rad + ratio.offset_rad);
  }
}

void LimitJoints(const JointedLinks& further, const TreePlaces& places, int body,
                 RigidWorld& world) {
  const std::size_t own = places.size() - further.links.size();
  for (std::size_t i = 0; i < further.links.size(); ++i) {
    const JointedLink& each = further.links[i];
    if (!HasStops(each) && each.friction_nm == 0.0) continue;
    JointLaw law = StopsAt(each.stop, each.low_rad, each.high_rad);
    law.friction_nm = each.friction_nm;
    world.Limit({body, places[own + i]}, law);
  }
  for (const LinkPin& pin : further.pins) {
    const BodyLink a{body, places[At(pin.a)]}, b{body, places[At(pin.b)]};
    const TreeBody& tree = world.body(body);
    const Eigen::Vector3d p_G = tree.motion(a.link).X_GL * pin.p_A;
    world.Add(PointTie{.a = a,
                       .b = b,
                       .p_A = pin.p_A,
                       .p_B = Inverse(tree.motion(b.link).X_GL) * p_G,
                       .stiffness_n_per_m = pin.stiffness_n_per_m,
                       .damping_ns_per_m = pin.damping_ns_per_m});
  }
}

double ShaftInertia(const JointedLink& joint, double travel_per_rad, const TreeBody& tree,
                    int link) {
  const TreeBody::Inertia inverse = tree.MassMatrix().inverse();
  const double at_start = 1.0 / inverse(tree.SpeedOf(link), tree.SpeedOf(link));
  const double alone = OwnInertia(joint) + tree.link(link).rotor_kg_m2;
  return travel_per_rad * travel_per_rad * std::min(at_start, alone);
}

JointDrives::JointDrives(const JointedLinks& further, const TreePlaces& places,
                         const TreeBody& tree) {
  const std::size_t own = places.size() - further.links.size();
  for (std::size_t i = 0; i < further.links.size(); ++i) {
    const JointedLink& each = further.links[i];
    if (!each.motor) continue;
    const double travel = TravelPerRad(each);
    const int link = places[own + i];
    const double inertia = ShaftInertia(each, travel, tree, link);
    Drive& drive = drives_.emplace_back(Drive{.link = link,
                                              .travel_per_rad = travel,
                                              .rate_rad_s = each.motor->rate_rad_s / travel,
                                              .low_rad = each.low_rad / travel,
                                              .high_rad = each.high_rad / travel,
                                              .model = each.motor->model,
                                              .motor = MotorDrive(each.motor->model, inertia)});
    drive.motor.ResetProfile(tree.angle_rad(link) / travel);
  }
}

void JointDrives::Step(bool running, double step_s, TreeBody& tree) {
  for (Drive& drive : drives_) {
    const double angle_rad = tree.angle_rad(drive.link) / drive.travel_per_rad;
    const double speed_rad_s = tree.rate_rad_s(drive.link) / drive.travel_per_rad;
    MotorCommand command;
    if (running && drive.rate_rad_s != 0.0) {
      // It turns back where it still comes to rest before the stop.
      const double slope = drive.model.max_accel_rad_s2;
      const double stopping_rad =
          std::abs(speed_rad_s) * (step_s + std::abs(speed_rad_s) / (2.0 * slope));
      const double left_rad =
          drive.rate_rad_s > 0.0 ? drive.high_rad - angle_rad : angle_rad - drive.low_rad;
      if (left_rad <= stopping_rad) drive.rate_rad_s = -drive.rate_rad_s;
      command = {.mode = MotorMode::kVelocity,
                 .target = drive.rate_rad_s,
                 .accel_rad_s2 = slope,
                 .current_limit_a = drive.model.max_current_a};
    }
    const DriveOutput output = drive.motor.Step(command, angle_rad, speed_rad_s, step_s);
    tree.AddJointTorque(drive.link, output.torque_nm() / drive.travel_per_rad);
  }
}

bool JointDrives::runs() const {
  for (const Drive& drive : drives_) {
    if (drive.rate_rad_s != 0.0) return true;
  }
  return false;
}

std::uint64_t JointDrives::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Drive& drive : drives_) {
    hash = drive.motor.StateHash(HashDouble(hash, drive.rate_rad_s));
  }
  return hash;
}

}  // namespace dockyard
