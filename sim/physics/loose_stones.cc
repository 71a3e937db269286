#include "sim/physics/loose_stones.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "sim/base/hash.h"
#include "sim/physics/moved_soil.h"
#include "sim/physics/plate_contacts.h"
#include "sim/soil/sinking_plate.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// A stone slower than this, at every point, for so long sleeps. Assumed, 0.1-1 mm/s, 0.1-1 s: in
// that time it would creep 0.05 mm.
constexpr double kStill_m_s = 2e-4, kStill_s = 0.25;
// It wakes when the ground below its centre has changed by more. Assumed, 0.05-0.5 mm.
constexpr double kGroundChange_m = 1e-4;
// A corner that faces down with less bears nothing [m^2].
constexpr double kLeastArea_m2 = 1e-9;

bool MayMeet(const ConvexBody& a, const Vector3d& a_G, const ConvexBody& b, const Vector3d& b_G) {
  const double reach_m = a.radius_m + b.radius_m;
  return (a_G - b_G).squaredNorm() < reach_m * reach_m;
}

// The outward area of each corner: of each face an equal part.
std::vector<Vector3d> CornerAreas(const ConvexBody& body) {
  std::vector<Vector3d> areas(body.vertices.size(), Vector3d::Zero());
  for (const HalfSpace& face : body.faces) {
    const auto IsOn = [&](std::size_t i) {
      return face.offset_m - face.normal.dot(body.vertices[i]) < 1e-7 * body.radius_m;
    };
    double area_m2 = 0.0;
    for (const auto& t : body.triangles) {
      if (!IsOn(t[0]) || !IsOn(t[1]) || !IsOn(t[2])) continue;
      const Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]], &c = body.vertices[t[2]];
      area_m2 += 0.5 * (b - a).cross(c - a).norm();
    }
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (IsOn(i)) on.push_back(i);
    }
    for (const std::size_t i : on) {
      areas[i] += area_m2 / static_cast<double>(on.size()) * face.normal;
    }
  }
  return areas;
}

}  // namespace

LooseStones::LooseStones(std::vector<ToolPart> parts, const SoilModel& soil,
                         const StoneMaterial& material)
    : parts_(std::move(parts)), soil_(soil), material_(material) {}

int LooseStones::Add(const LooseStone& stone) {
  const ConvexBody& shape = stone.shape_S();
  // A round plate as wide as the stone.
  stones_.push_back({stone, MakeRimLaws(soil_, shape.radius_m), CornerAreas(shape),
                     std::vector<double>(shape.vertices.size(), 0.0)});
  return count() - 1;
}

void LooseStones::AddForce(int stone, const Vector3d& force_G) {
  Kept& kept = stones_.at(Place(stone));
  kept.load_G += force_G;
  kept.asleep = false;
  kept.still_s = 0.0;
}

Vector3d LooseStones::PartsForce(int stone, double step_s) const {
  Vector3d sum = Vector3d::Zero();
  for (const StoneTouch& touch : touches_) {
    if (touch.stone == stone && touch.part >= 0) sum += touch.impulse_G / step_s;
  }
  return sum;
}

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
    const double rebound = area_m2 * kept.laws.elastic_pa_per_m;
    const SinkingPlate plate{area_m2 * kept.laws.k, kept.laws.n, rebound};
    const double borne_n = PressPlate(plate, depth_m, sunk_m);
    // Yielding soil dissipates by itself; damping is for the elastic rest.
    const double yield_n = plate.force_n_per_m_n * std::pow(depth_m, plate.n);
    const double elastic = std::clamp(1.0 - borne_n / yield_n, 0.0, 1.0);
    AddTouch({.stone = stone,
              .feature = static_cast<int>(i),
              .p_G = p_G,
              .normal_G = normal_G,
              .law = {sunk_m - depth_m, material_.soil_friction, rebound,
                      elastic * area_m2 * kept.laws.damping_pa_s_per_m}});
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

void LooseStones::Step(TreeBody& tool, const Vector3d& gravity_G, double step_s,
                       const HeightGrid& ground) {
  FindTouches(tool, ground, step_s);
  for (Kept& kept : stones_) {
    kept.moved = !kept.asleep;
    if (kept.asleep) continue;
    kept.body.TakeWeight(gravity_G, step_s);
    kept.body.AddImpulse(step_s * kept.load_G, kept.body.motion().X_GL.p);
    kept.load_G.setZero();
  }
  SolveAll(tool, step_s);
  for (Kept& kept : stones_) {
    if (kept.asleep) continue;
    kept.body.Move(step_s);
    Rest(kept, ground, step_s);
  }
  // Those of sleepers are kept for when they wake.
  for (const StoneTouch& last : last_touches_) {
    if (!stones_[Place(last.stone)].moved) touches_.push_back(last);
  }
  last_touches_ = touches_;
}

void LooseStones::Rest(Kept& kept, const HeightGrid& ground, double step_s) {
  const LinkMotion& motion = kept.body.motion();
  const int stone = static_cast<int>(&kept - stones_.data());
  const bool held = std::any_of(touches_.begin(), touches_.end(), [&](const StoneTouch& touch) {
    return touch.stone == stone && touch.part >= 0;
  });
  const double speed_m_s =
      motion.v_GL_G.norm() + kept.body.shape_S().radius_m * motion.w_GL_G.norm();
  kept.still_s = held || speed_m_s > kStill_m_s ? 0.0 : kept.still_s + step_s;
  if (kept.still_s < kStill_s) return;
  kept.asleep = true;
  kept.ground_m = BearingHeight(ground, motion.X_GL.p.x(), motion.X_GL.p.y());
  kept.body.SetMotion(Vector3d::Zero(), Vector3d::Zero());
}

std::uint64_t LooseStones::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Kept& kept : stones_) {
    hash = HashDouble(kept.body.StateHash(hash), kept.still_s);
    for (const double sunk_m : kept.sunk_m) hash = HashDouble(hash, sunk_m);
  }
  for (const StoneTouch& touch : last_touches_) {
    for (int i = 0; i < 3; ++i) hash = HashDouble(hash, touch.bend_S[i]);
  }
  return hash;
}

}  // namespace dockyard
