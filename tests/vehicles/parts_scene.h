// Scenes of a rover's parts, a rock and each other. Overlaps are measured at points on the
// surfaces, not by what finds the contacts.
#pragma once

#include <algorithm>
#include <vector>

#include "models/parts/gravity.h"
#include "models/rocky7/load_robot.h"
#include "sim/base/random.h"
#include "sim/rigid/rocks.h"
#include "sim/vehicles/mast_body.h"
#include "sim/vehicles/surface_points.h"
#include "vehicles/stone_rig.h"

namespace dockyard {

inline RoverModel Rocky7() {
  return rocky7::LoadRobot(SourceFile("models/rocky7/rocky7.yaml")).rover;
}

/// Points on the surfaces of parts, by their numbers.
inline std::vector<std::vector<Eigen::Vector3d>> PointsOf(const PartContacts& parts) {
  std::vector<std::vector<Eigen::Vector3d>> points_L;
  for (int i = 0; i < parts.count(); ++i) {
    points_L.push_back(SurfacePoints(parts.part(i).body_L, 0.02));
  }
  return points_L;
}

/// How deep points on one part's surface are in another part, at most.
inline double DepthOf(const PartContacts& parts, const RigidWorld& world, int a, int b,
                      const std::vector<Eigen::Vector3d>& points_A) {
  const auto Pose = [&](const SolidPart& part) {
    return part.at.body < 0 ? Pose3{} : world.body(part.at.body).motion(part.at.link).X_GL;
  };
  const SolidPart &one = parts.part(a), &other = parts.part(b);
  const Pose3 X_BA = Inverse(Pose(other)) * Pose(one);
  const double reach_m = one.body_L.radius_m + other.body_L.radius_m;
  if ((X_BA * one.body_L.centre - other.body_L.centre).norm() > reach_m) return 0.0;
  double deepest_m = 0.0;
  for (const Eigen::Vector3d& p_A : points_A) {
    const Eigen::Vector3d p_B = X_BA * p_A;
    double out_m = -1e9;
    for (const HalfSpace& face : other.body_L.faces) {
      out_m = std::max(out_m, face.normal.dot(p_B) - face.offset_m);
    }
    deepest_m = std::max(deepest_m, -out_m);
  }
  return deepest_m;
}

/// Of all pairs that may meet and are no wheels.
template <class Visit>
void ForOverlaps(const PartContacts& parts, const RigidWorld& world,
                 const std::vector<std::vector<Eigen::Vector3d>>& points_L, const Visit& visit) {
  for (int a = 0; a < parts.count(); ++a) {
    for (int b = 0; b < parts.count(); ++b) {
      const PartGroups &one = parts.part(a).groups, &other = parts.part(b).groups;
      if (a == b || (one.group & other.meets) == 0 || (other.group & one.meets) == 0) continue;
      if (parts.part(a).wheel || parts.part(b).wheel) continue;
      visit(a, b, DepthOf(parts, world, a, b, points_L[static_cast<std::size_t>(a)]));
    }
  }
}

inline double DeepestOverlap(const PartContacts& parts, const RigidWorld& world,
                             const std::vector<std::vector<Eigen::Vector3d>>& points_L) {
  double deepest_m = 0.0;
  ForOverlaps(parts, world, points_L,
              [&](int, int, double depth_m) { deepest_m = std::max(deepest_m, depth_m); });
  return deepest_m;
}

/// How far at most the deepest contact of a part of the mast with the body yields where the torque
/// that the shoulder's motor has now and the mast's weight press it there, by its lever about the
/// shoulder, friction on their side. A mast that is folded back presses with its can some
/// centimetres from that axis. 0: nothing presses.
inline double YieldUnderShoulder(const ArmRig& rig, int a, int b) {
  const int mast = std::max(a, b), other = std::min(a, b);
  if (rig.parts.part(mast).groups.group != part_group::kMast) return 0.0;
  const WorldContact* deepest = nullptr;
  double stiffness_n_per_m = 0.0;  // of all contacts there
  const auto ForContacts = [&](const auto& visit) {
    for (const PartContacts::Met& met : rig.parts.met()) {
      if (met.a != other || met.b != mast) continue;
      visit(rig.world.contacts()[static_cast<std::size_t>(met.contact)]);
    }
  };
  ForContacts([&](const WorldContact& contact) {
    if (deepest == nullptr || contact.gap_m < deepest->gap_m) deepest = &contact;
  });
  if (deepest == nullptr) return 0.0;
  ForContacts([&](const WorldContact& contact) {
    if ((contact.p_G - deepest->p_G).norm() > 1e-3) return;
    stiffness_n_per_m += contact.share * contact.material.stiffness_n_per_m;
  });
  const TreeBody& tree = rig.body.tree();
  const Pose3& X_GS = tree.motion(rig.body.mast_link(kMastShoulder)).X_GL;
  const Eigen::Vector3d axis_G = X_GS.R.col(1), down_G = -Eigen::Vector3d::UnitZ();
  double load_nm =
      std::abs(rig.body.output(rig.first_motor() + kArmMotors + kMastShoulder).torque_nm());
  for (const int i : {kMastShoulder, kMastElbow, kMastCan}) {
    const LinkModel& model = tree.link(rig.body.mast_link(i)).model;
    const Eigen::Vector3d com_G = tree.motion(rig.body.mast_link(i)).X_GL * model.p_LoCom_L;
    load_nm +=
        std::abs(kEarthGravity_m_s2 * model.mass_kg * axis_G.dot((com_G - X_GS.p).cross(down_G)));
  }
  const Eigen::Vector3d lever_m = axis_G.cross(deepest->p_G - X_GS.p);
  const double along_m = std::abs(deepest->normal_G.dot(lever_m));
  const double across_m = (lever_m - deepest->normal_G.dot(lever_m) * deepest->normal_G).norm();
  const double pressing_m = along_m - deepest->material.friction * across_m;
  return pressing_m > 0.0 ? load_nm / (pressing_m * stiffness_n_per_m) : along_m;
}

// Contacts yield by 1 mm under 20 N, the most that the arm presses with; blows press deeper.
inline constexpr double kMostOverlap_m = 4e-3;

/// A rock before the rover, and arm and mast driven anywhere with all their motors' torque. The
/// deepest overlap, without those that the shoulder's torque makes.
inline double OverlapOfScene(std::uint64_t scene) {
  RandomStream random(StreamKey(scene, "parts"));
  ArmRig rig(Rocky7(), "compact_gravel");
  const double high_m = random.Uniform(0.05, 0.3);
  const ConvexBody rock = RockShape({2.0 * high_m, high_m}, 0.1, 0.0, scene);
  const double x_m = 0.55 + high_m + random.Uniform(0.0, 0.1);
  rig.parts.Add({.body_L = Pose3::Translation(x_m, random.Uniform(-0.1, 0.1), 0.0) * rock,
                 .material = MaterialOf(0.6),
                 .groups = {part_group::kBeddedStones, part_group::kRover}});
  const auto Turn = [&](int motor, double low_rad, double high_rad) {
    rig.commands[static_cast<std::size_t>(motor)] = {
        MotorMode::kPosition, random.Uniform(low_rad, high_rad), 0.4, 2.0, 10.0};
  };
  const auto points_L = PointsOf(rig.parts);
  double deepest_m = 0.0;
  for (int move = 0; move < 2; ++move) {
    const ArmModel& arm = *rig.model.arm;
    const int first = rig.first_motor();
    Turn(first + kArmRoll, -0.5, 0.5);
    Turn(first + kArmPitch, arm.pitch_low_rad, arm.pitch_high_rad);
    Turn(first + kFrontScoop, arm.scoop_low_rad, arm.scoop_high_rad);
    Turn(first + kBackScoop, arm.scoop_low_rad, arm.scoop_high_rad);
    const MastModel& mast = *rig.model.mast;
    for (int i = 0; i < kMastMotors; ++i) {
      Turn(first + kArmMotors + i, mast.low_rad[static_cast<std::size_t>(i)],
           mast.high_rad[static_cast<std::size_t>(i)]);
    }
    for (int i = 0; i < 10; ++i) {
      rig.Run(0.3);
      ForOverlaps(rig.parts, rig.world, points_L, [&](int a, int b, double depth_m) {
        if (depth_m >= kMostOverlap_m && depth_m < YieldUnderShoulder(rig, a, b)) return;
        deepest_m = std::max(deepest_m, depth_m);
      });
    }
  }
  return deepest_m;
}

}  // namespace dockyard
