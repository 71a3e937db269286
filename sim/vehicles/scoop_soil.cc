#include "sim/vehicles/scoop_soil.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "models/parts/scoop_shape.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Pieces of lip and wall: across the width, and along the profile.
constexpr int kAcross = 5, kAlong = 3;

// Slopes slump so often; assumed, 5-50 ms. One pass while the scoop is in the soil, as it keeps the
// heap before it off the trench behind it; more when it is out, until all is at rest (assumed,
// 5-50).
constexpr double kSlump_s = 0.01;
constexpr int kPassesWhenOut = 10;

double Below(const HeightGrid& ground, const Vector3d& p_G) {
  return BearingHeight(ground, p_G.x(), p_G.y()) - p_G.z();
}

}  // namespace

ScoopSoil::ScoopSoil(const ScoopModel& scoop, bool front, const std::vector<SoilModel>& soils) {
  for (const SoilModel& soil : soils) {
    all_laws_.push_back(
        {MakeTipLaws(soil, scoop.wall_m, scoop.width_m), MakeRimLaws(soil, scoop.width_m)});
  }
  laws_ = all_laws_.front().lip;
  wall_laws_ = all_laws_.front().wall;
  const auto profile = ScoopProfile(scoop);
  const auto At = [&](const Eigen::Vector2d& xz, double across) {
    return Vector3d((front ? 1.0 : -1.0) * xz.x(), scoop.width_m * across, xz.y());
  };
  way_L_ = (At(profile[3], 0.0) - At(profile[2], 0.0)).normalized();
  lip_area_m2_ = scoop.width_m * scoop.wall_m / kAcross;
  reach_m_ = 2.0 * scoop.depth_m;
  for (int i = 0; i < kAcross; ++i) {
    const double across = (i + 0.5) / kAcross - 0.5;
    lips_.push_back({At(profile[3], across)});
    for (int piece = 1; piece < 3; ++piece) {  // back and floor
      const Vector3d from = At(profile[piece], across), way = At(profile[piece + 1], across) - from;
      for (int k = 0; k < kAlong; ++k) {
        Wall wall;
        wall.p_L = from + (k + 0.5) / kAlong * way;
        wall.normal_L = way.cross(Vector3d::UnitY()).normalized();
        wall.area_m2 = way.norm() * scoop.width_m / (kAlong * kAcross);
        walls_.push_back(wall);
      }
    }
  }
}

// The wedge before a wall comes out at depth x tan(45 deg + phi / 2). The trench opens behind it.
void ScoopSoil::Heap(HeightGrid& ground, const Wall& wall, const Vector3d& p_G,
                     const Vector3d& swept_G, double depth_m) const {
  const Eigen::Vector2d aside = swept_G.head<2>();
  const double way_m = aside.norm();
  if (way_m == 0.0) return;
  const double out_m = depth_m * wall_laws_.sqrt_n_phi + ground.cell_m;
  const Eigen::Vector2d at = p_G.head<2>(), towards = aside / way_m;
  MoveSoil(ground, at - ground.cell_m * towards, at + out_m * towards, wall.area_m2 * way_m);
}

ScoopLoad ScoopSoil::Step(HeightGrid& ground, const LinkMotion& scoop, double step_s) {
  if (all_laws_.size() > 1) {
    const Laws& here = all_laws_.at(ground.SoilAt(scoop.X_GL.p));
    laws_ = here.lip;
    wall_laws_ = here.wall;
  }
  ScoopLoad load;
  load.deepest_m = -1e3;
  const auto Add = [&](const Vector3d& force_G, const Vector3d& p_G) {
    load.force_G += force_G;
    load.torque_G += (p_G - scoop.X_GL.p).cross(force_G);
  };
  const Vector3d way_G = scoop.X_GL.R * way_L_;
  for (Lip& lip : lips_) {
    const Vector3d p_G = scoop.X_GL * lip.p_L;
    const double depth_m = Below(ground, p_G);
    load.deepest_m = std::max(load.deepest_m, depth_m);
    if (depth_m <= 0.0) {
      lip.pressed_m = 0.0;
      continue;
    }
    const double yield_pa = std::max(YieldPressure(laws_, depth_m), BladePressure(laws_, depth_m));
    const double into_m = step_s * scoop.VelocityAt(p_G).dot(way_G);
    lip.pressed_m = std::clamp(lip.pressed_m + into_m, 0.0, yield_pa / laws_.elastic_pa_per_m);
    const double force_n = lip_area_m2_ * laws_.elastic_pa_per_m * lip.pressed_m;
    load.lip_n += force_n;
    Add(-force_n * way_G, p_G);
  }
  const double modulus_m = ShearModulus(wall_laws_, ContactDepth(load.deepest_m));
  for (Wall& wall : walls_) {
    const Vector3d p_G = scoop.X_GL * wall.p_L;
    const double depth_m = Below(ground, p_G);
    if (depth_m <= 0.0) {
      wall.push = 0.0;
      wall.rub_G.setZero();
      continue;
    }
    const Vector3d way = step_s * scoop.VelocityAt(p_G), normal_G = scoop.X_GL.R * wall.normal_L;
    const double into_m = way.dot(normal_G);
    wall.push = Shear(wall.push, into_m, modulus_m);
    const Vector3d aside = way - into_m * normal_G;
    const double slide_m = aside.norm(), keep = Decay(slide_m / modulus_m);
    wall.rub_G *= keep;
    if (slide_m > 0.0) wall.rub_G += (1.0 - keep) / slide_m * aside;
    wall.rub_G -= wall.rub_G.dot(normal_G) * normal_G;
    const double wall_n = wall.area_m2 * FacePressure(wall_laws_, depth_m, 1.0);
    Add(-wall_n * (wall.push * normal_G + wall_laws_.tan_rim * std::abs(wall.push) * wall.rub_G),
        p_G);
    Heap(ground, wall, p_G, into_m * normal_G, depth_m);
  }
  since_slump_s_ += step_s;
  if (load.deepest_m > 0.0) {
    slumps_ = true;
    slope_ = {scoop.X_GL.p.head<2>(), reach_m_, wall_laws_.tan_phi};
  }
  if (slumps_ && since_slump_s_ >= kSlump_s) {
    slumps_ = !Slump(ground, slope_, load.deepest_m > 0.0 ? 1 : kPassesWhenOut);
    since_slump_s_ = 0.0;
  }
  return load;
}

std::uint64_t ScoopSoil::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, slumps_ ? 1 : 0);
  for (const Lip& lip : lips_) hash = HashDouble(hash, lip.pressed_m);
  for (const Wall& wall : walls_) {
    hash = HashDouble(hash, wall.push);
    for (int i = 0; i < 3; ++i) hash = HashDouble(hash, wall.rub_G[i]);
  }
  return hash;
}

}  // namespace dockyard
