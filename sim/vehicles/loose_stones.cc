#include "sim/vehicles/loose_stones.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/hash.h"
#include "sim/soil/moved_soil.h"
#include "sim/soil/sinking_plate.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// A stone slower than this, at every point, for so long sleeps. Assumed, 0.1-1 mm/s, 0.1-1 s: in
// that time it would creep 0.05 mm.
constexpr double kStill_m_s = 2e-4, kStill_s = 0.25;

// A sleeper wakes when the ground below its centre has changed by more. Assumed, 0.05-0.5 mm.
constexpr double kGroundChange_m = 1e-4;
// A corner that faces down with less bears nothing [m^2].
constexpr double kLeastArea_m2 = 1e-9;

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

LooseStones::LooseStones(RigidWorld& world, std::vector<SoilModel> soils, double soil_friction)
    : world_(world), soils_(std::move(soils)), soil_friction_(soil_friction) {}

int LooseStones::Add(const LooseStone& stone) {
  const ConvexBody& shape = stone.shape_S;
  std::vector<SoilLaws> laws;  // of a round plate as wide as the stone
  for (const SoilModel& soil : soils_) laws.push_back(MakeRimLaws(soil, shape.radius_m));
  stones_.push_back({world_.Add(BodyOf(stone)), shape, std::move(laws), CornerAreas(shape),
                     std::vector<double>(shape.vertices.size(), 0.0)});
  return count() - 1;
}

void LooseStones::Bed(int stone, const HeightGrid& ground) {
  Kept& kept = stones_.at(Place(stone));
  const Pose3& X_GL = motion(stone).X_GL;
  for (std::size_t i = 0; i < kept.shape_S.vertices.size(); ++i) {
    const Vector3d p_G = X_GL * kept.shape_S.vertices[i];
    const double below_m = BearingHeight(ground, p_G.x(), p_G.y()) - p_G.z();
    kept.sunk_m[i] = std::max(0.0, below_m * ground.Normal(p_G.x(), p_G.y()).z());
  }
}

void LooseStones::AddForce(int stone, const Vector3d& force_G) {
  Kept& kept = stones_.at(Place(stone));
  world_.SetAsleep(kept.body, false);
  kept.still_s = 0.0;
  world_.body(kept.body).AddForce(0, force_G, motion(stone).X_GL.p);
}

void LooseStones::AddSoilContacts(const HeightGrid& ground, double step_s) {
  for (Kept& kept : stones_) {
    WakeIfGroundChanged(kept, ground);
    if (!world_.asleep(kept.body)) AddSoilContacts(kept, ground, step_s);
  }
}

void LooseStones::WakeIfGroundChanged(Kept& kept, const HeightGrid& ground) {
  if (!world_.asleep(kept.body)) return;
  const Vector3d& at = world_.body(kept.body).motion(0).X_GL.p;
  if (std::abs(BearingHeight(ground, at.x(), at.y()) - kept.ground_m) <= kGroundChange_m) return;
  world_.SetAsleep(kept.body, false);
  kept.still_s = 0.0;
}

// Each lower corner is a plate as large as its part of the surface that faces down. It bears by
// p(z) where it was not as deep before, else by the soil's rebound.
void LooseStones::AddSoilContacts(Kept& kept, const HeightGrid& ground, double step_s) {
  const LinkMotion& motion = world_.body(kept.body).motion(0);
  const ConvexBody& shape = kept.shape_S;
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
    world_.AddContact(
        {.a = {kept.body, 0},
         .pair = static_cast<std::int64_t>(i),
         .p_G = p_G,
         .normal_G = normal_G,
         .gap_m = sunk_m - depth_m,
         .material = {rebound, elastic * area_m2 * laws.damping_pa_s_per_m, soil_friction_, 0.0}});
  }
}

bool LooseStones::IsHeld(const Kept& kept) const {
  const auto& contacts = world_.contacts();
  return std::any_of(contacts.begin(), contacts.end(), [&](const WorldContact& contact) {
    const auto IsRobot = [&](const BodyLink& at) {
      return at.body >= 0 && world_.body(at.body).link_count() > 1;
    };
    return (contact.a.body == kept.body && IsRobot(contact.b)) ||
           (contact.b.body == kept.body && IsRobot(contact.a));
  });
}

void LooseStones::Rest(const HeightGrid& ground, double step_s) {
  for (Kept& kept : stones_) {
    if (world_.asleep(kept.body)) continue;
    const LinkMotion& motion = world_.body(kept.body).motion(0);
    const double speed_m_s = motion.v_GL_G.norm() + kept.shape_S.radius_m * motion.w_GL_G.norm();
    kept.still_s = speed_m_s > kStill_m_s || IsHeld(kept) ? 0.0 : kept.still_s + step_s;
    if (kept.still_s < kStill_s) continue;
    kept.ground_m = BearingHeight(ground, motion.X_GL.p.x(), motion.X_GL.p.y());
    world_.SetAsleep(kept.body, true);
  }
}

// The world's own is its bodies'.
std::uint64_t LooseStones::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Kept& kept : stones_) {
    hash = HashDouble(hash, kept.still_s);
    for (const double sunk_m : kept.sunk_m) hash = HashDouble(hash, sunk_m);
  }
  return hash;
}

}  // namespace dockyard
