#include "sim/vehicles/carried_soil.h"

#include <algorithm>
#include <cmath>

#include "models/parts/scoop_shape.h"
#include "sim/base/hash.h"
#include "sim/soil/moved_soil.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Pieces of a floor: across the width, and along the profile.
constexpr int kAcross = 8, kAlong = 8;
// Lips that are further apart hold no loose soil: some six grains of a coarse sand. Assumed, 2-10
// mm.
constexpr double kGap_m = 0.005;
// What runs out becomes a heap at once, within this multiple of a scoop's depth and this number of
// passes. 100 cm^3, more than two scoops hold, make a heap of 4 cm.
constexpr double kReach = 3.0;
constexpr int kMostPasses = 5000;
// Passes in a step, where soil has been taken. Assumed, 1-50.
constexpr int kPassesAStep = 10;

}  // namespace

CarriedSoil::CarriedSoil(const ScoopModel& scoop, const std::vector<SoilModel>& soils)
    : scoop_(scoop), soils_(soils) {
  const auto profile = ScoopProfile(scoop);
  const Eigen::Vector2d from = profile[3], along = profile[2] - profile[3];  // from the lip on
  for (const std::size_t number : {0u, 1u}) {
    const double side = number == 0 ? 1.0 : -1.0;
    for (int i = 0; i < kAlong * kAcross; ++i) {
      const Eigen::Vector2d xz = from + (i / kAcross + 0.5) / kAlong * along;
      const double y_m = scoop.width_m * ((i % kAcross + 0.5) / kAcross - 0.5);
      Piece piece;
      piece.scoop = number;
      piece.p_L = {side * xz.x(), y_m, xz.y()};
      piece.area_m2 = std::abs(along.x()) * scoop.width_m / (kAlong * kAcross);
      piece.to_side_m = 0.5 * scoop.width_m - std::abs(y_m);
      pieces_.push_back(piece);
    }
  }
}

void CarriedSoil::Raise(HeightGrid& ground, const LinkMotion& scoop, Piece& piece) {
  const Vector3d p_G = scoop.X_GL * piece.p_L;
  const double depth_m = ground.Height(p_G.x(), p_G.y()) - p_G.z();
  if (depth_m > 0.0) {
    const SoilModel& soil = soils_.at(ground.SoilAt(p_G));
    density_kg_m3_ = soil.density_kg_m3;
    gravity_m_s2_ = soil.gravity_m_s2;
    double most_m = std::max(0.0, scoop.X_GL.p.z() - p_G.z());
    if (scoop_.sides == ScoopSides::kOpen) {
      most_m = std::min(most_m, piece.to_side_m * std::tan(soil.friction_angle_rad));
    }
    piece.high_m = std::max(piece.high_m, std::min(depth_m, most_m));
  }
  const double out_m = std::clamp(piece.high_m - std::max(0.0, depth_m), 0.0, piece.high_m);
  const double more_m = out_m - piece.taken_m;
  if (more_m <= 0.0) return;
  AddSoil(ground, p_G.head<2>(), -piece.area_m2 * more_m);
  volume_m3_ += piece.area_m2 * more_m;
  slumps_ = true;
  piece.taken_m = out_m;
}

void CarriedSoil::Spill(HeightGrid& ground, const std::array<const LinkMotion*, 2>& scoops) {
  for (Piece& piece : pieces_) {
    const Vector3d p_G = scoops[piece.scoop]->X_GL * piece.p_L;
    if (piece.taken_m > 0.0) AddSoil(ground, p_G.head<2>(), piece.area_m2 * piece.taken_m);
    piece.high_m = piece.taken_m = 0.0;
  }
  if (volume_m3_ > 0.0) Slumps(ground, scoops[0]->X_GL.p, kMostPasses);
  volume_m3_ = 0.0;
}

void CarriedSoil::Slumps(HeightGrid& ground, const Vector3d& at_G, int most_passes) {
  const SoilModel& soil = soils_.at(ground.SoilAt(at_G));
  const double reach_m = kReach * scoop_.depth_m;
  slumps_ =
      !Slump(ground, {at_G.head<2>(), reach_m, std::tan(soil.friction_angle_rad)}, most_passes);
}

std::array<CarriedSoil::Load, 2> CarriedSoil::Step(HeightGrid& ground,
                                                   const std::array<const LinkMotion*, 2>& scoops,
                                                   double open_rad) {
  std::array<Load, 2> loads{};
  if (2.0 * scoop_.depth_m * std::sin(0.5 * open_rad) > kGap_m) {
    Spill(ground, scoops);
    return loads;
  }
  const Vector3d& axis_G = scoops[0]->X_GL.p;
  if (slumps_) Slumps(ground, axis_G, kPassesAStep);
  const double up_m = axis_G.z() - ground.Height(axis_G.x(), axis_G.y());
  if (volume_m3_ == 0.0 && up_m > 2.0 * scoop_.depth_m) return loads;
  for (Piece& piece : pieces_) {
    const LinkMotion& scoop = *scoops[piece.scoop];
    Raise(ground, scoop, piece);
    if (piece.taken_m <= 0.0) continue;
    const double weight_n = density_kg_m3_ * gravity_m_s2_ * piece.area_m2 * piece.taken_m;
    const Vector3d force_G(0.0, 0.0, -weight_n);
    loads[piece.scoop].force_G += force_G;
    loads[piece.scoop].torque_G += (scoop.X_GL.R * piece.p_L).cross(force_G);
  }
  return loads;
}

std::uint64_t CarriedSoil::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(HashDouble(seed, volume_m3_), slumps_ ? 1 : 0);
  for (const Piece& piece : pieces_) {
    hash = HashDouble(HashDouble(hash, piece.high_m), piece.taken_m);
  }
  return hash;
}

}  // namespace dockyard
