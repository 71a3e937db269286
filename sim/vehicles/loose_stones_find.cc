// Which contacts a step has.
#include <algorithm>
#include <cmath>

#include "sim/rigid/plate_contacts.h"
#include "sim/soil/sinking_plate.h"
#include "sim/vehicles/loose_stones.h"
#include "sim/vehicles/moved_soil.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// A sleeper wakes when the ground below its centre has changed by more. Assumed, 0.05-0.5 mm.
constexpr double kGroundChange_m = 1e-4;
// A corner that faces down with less bears nothing [m^2].
constexpr double kLeastArea_m2 = 1e-9;

bool MayMeet(const ConvexBody& a, const Vector3d& a_G, const ConvexBody& b, const Vector3d& b_G) {
  const double reach_m = a.radius_m + b.radius_m;
  return (a_G - b_G).squaredNorm() < reach_m * reach_m;
}

}  // namespace

// Goes on from the same contact of the last step.
void LooseStones::GoOnFromLastStep(StoneTouch& touch) const {
  for (const StoneTouch& last : last_touches_) {
    if (last.stone != touch.stone || last.part != touch.part || last.feature != touch.feature ||
        last.other_stone != touch.other_stone) {
      continue;
    }
    touch.impulse_S = last.impulse_S;
    touch.bend_S = last.bend_S;
    return;
  }
}

void LooseStones::AddTouch(StoneTouch touch) {
  GoOnFromLastStep(touch);
  touches_.push_back(touch);
}

void LooseStones::PlaceParts(const TreeBody& tool) {
  part_poses_.resize(parts_.size());
  part_centres_.resize(parts_.size());
  parts_centre_G_.setZero();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    part_poses_[i] = tool.motion(parts_[i].link).X_GL;
    part_centres_[i] = part_poses_[i] * parts_[i].body_L.centre;
    parts_centre_G_ += part_centres_[i] / static_cast<double>(parts_.size());
  }
  parts_reach_m_ = 0.0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const double off_m = (part_centres_[i] - parts_centre_G_).norm();
    parts_reach_m_ = std::max(parts_reach_m_, off_m + parts_[i].body_L.radius_m);
  }
}

void LooseStones::FindParts(int stone) {
  Kept& kept = stones_[Place(stone)];
  const Pose3& X_GS = kept.body.motion().X_GL;
  const ConvexBody& shape = kept.body.shape_S();
  const Vector3d centre_G = X_GS * shape.centre;
  const double near_m = parts_reach_m_ + shape.radius_m;
  if ((centre_G - parts_centre_G_).squaredNorm() > near_m * near_m) return;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!MayMeet(shape, centre_G, parts_[i].body_L, part_centres_[i])) continue;
    found_.clear();
    AddPlateContacts(shape, Inverse(X_GS) * part_poses_[i] * parts_[i].body_L, found_);
    for (const BodyContact& at : found_) {
      AddTouch({.stone = stone,
                .part = static_cast<int>(i),
                .feature = at.feature,
                .p_G = X_GS * at.p,
                .normal_G = -(X_GS.R * at.normal),
                .law = {-at.depth_m, material_.friction, at.share * material_.stiffness_n_per_m,
                        at.share * material_.damping_ns_per_m}});
    }
    if (!found_.empty()) kept.asleep = false;
  }
}

void LooseStones::FindStones() {
  for (int a = 0; a < count(); ++a) {
    for (int b = a + 1; b < count(); ++b) {
      Kept &one = stones_[Place(a)], &other = stones_[Place(b)];
      if (one.asleep && other.asleep) continue;
      const Pose3 &X_GA = one.body.motion().X_GL, &X_GB = other.body.motion().X_GL;
      const ConvexBody &shape = one.body.shape_S(), &part = other.body.shape_S();
      if (!MayMeet(shape, X_GA * shape.centre, part, X_GB * part.centre)) continue;
      found_.clear();
      AddPlateContacts(shape, Inverse(X_GA) * X_GB * part, found_);
      for (const BodyContact& at : found_) {
        AddTouch({.stone = a,
                  .other_stone = b,
                  .feature = at.feature,
                  .p_G = X_GA * at.p,
                  .normal_G = -(X_GA.R * at.normal),
                  .law = {-at.depth_m, material_.friction, at.share * material_.stiffness_n_per_m,
                          at.share * material_.damping_ns_per_m}});
      }
      // A stone that only lies against one that sleeps does not keep it awake: Rest.
      if (!found_.empty()) one.asleep = other.asleep = false;
    }
  }
}

// Each lower corner is a plate as large as its part of the surface that faces down. It bears by
// p(z) where it was not as deep before, else by the soil's rebound.
void LooseStones::FindSoil(int stone, const HeightGrid& ground, double step_s) {
  Kept& kept = stones_[Place(stone)];
  const LinkMotion& motion = kept.body.motion();
  const ConvexBody& shape = kept.body.shape_S();
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    const Vector3d p_G = motion.X_GL * shape.vertices[i];
    const double below_m = BearingHeight(ground, p_G.x(), p_G.y()) - p_G.z();
    const double area_m2 = -(motion.X_GL.R.row(2).dot(kept.area_S[i]));
    double& sunk_m = kept.sunk_m[i];
    if (below_m <= 0.0 || area_m2 < kLeastArea_m2) {
      sunk_m = 0.0;
      continue;
    }
    const Vector3d normal_G = ground.Normal(p_G.x(), p_G.y());
    const double depth_m = below_m * normal_G.z();
    // Aside of where it pressed the soil is as it was.
    const Vector3d v_G = motion.VelocityAt(p_G);
    const double aside_m = step_s * (v_G - v_G.dot(normal_G) * normal_G).norm();
    sunk_m *= std::max(0.0, 1.0 - aside_m / std::sqrt(area_m2));
    const SoilLaws& laws = kept.laws.at(ground.SoilAt(p_G));
    const double rebound = area_m2 * laws.elastic_pa_per_m;
    const SinkingPlate plate{area_m2 * laws.k, laws.n, rebound};
    const double borne_n = PressPlate(plate, depth_m, sunk_m);
    // Yielding soil dissipates by itself; damping is for the elastic rest.
    const double yield_n = plate.force_n_per_m_n * std::pow(depth_m, plate.n);
    const double elastic = std::clamp(1.0 - borne_n / yield_n, 0.0, 1.0);
    AddTouch({.stone = stone,
              .feature = static_cast<int>(i),
              .p_G = p_G,
              .normal_G = normal_G,
              .law = {sunk_m - depth_m, material_.soil_friction, rebound,
                      elastic * area_m2 * laws.damping_pa_s_per_m}});
  }
}

void LooseStones::FindTouches(const TreeBody& tool, const HeightGrid& ground, double step_s) {
  touches_.clear();
  PlaceParts(tool);
  for (int i = 0; i < count(); ++i) {
    Kept& kept = stones_[Place(i)];
    if (kept.asleep) {
      const Vector3d& at = kept.body.motion().X_GL.p;
      const double change_m = BearingHeight(ground, at.x(), at.y()) - kept.ground_m;
      if (std::abs(change_m) > kGroundChange_m) {
        kept.asleep = false;
        kept.still_s = 0.0;
      }
    }
    FindParts(i);
  }
  FindStones();
  for (int i = 0; i < count(); ++i) {
    if (!stones_[Place(i)].asleep) FindSoil(i, ground, step_s);
  }
}

}  // namespace dockyard
