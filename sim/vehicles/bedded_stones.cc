#include "sim/vehicles/bedded_stones.h"

#include <algorithm>
#include <utility>

#include "sim/base/hash.h"

namespace dockyard {

using Eigen::Vector3d;

BeddedStones::BeddedStones(std::vector<ConvexBody> stones, const std::vector<SoilModel>& soils,
                           const HeightGrid& ground)
    : stones_(std::move(stones)) {
  for (const ConvexBody& stone : stones_) {
    Vector3d low = stone.centre, high = stone.centre;
    for (const Vector3d& vertex : stone.vertices) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
    const double diameter_m = 0.5 * (high - low).head<2>().sum();
    const double surface_m = ground.Height(stone.centre.x(), stone.centre.y());
    Bed bed{RoundPlate(soils.at(ground.SoilAt(stone.centre)), diameter_m)};
    bed.start_m = bed.depth_m = bed.stays_m = std::max(0.0, surface_m - low.z());
    beds_.push_back(bed);
  }
}

void BeddedStones::AddTo(PartContacts& parts, const ContactMaterial& material,
                         const PartGroups& groups) {
  first_part_ = parts.count();
  for (const ConvexBody& stone : stones_) {
    parts.Add({.body_L = stone, .material = material, .groups = groups});
  }
}

int BeddedStones::StoneOf(int part) const {
  const int stone = part - first_part_;
  return stone < static_cast<int>(stones_.size()) ? std::max(stone, -1) : -1;
}

void BeddedStones::Sink(const RigidWorld& world, double step_s, PartContacts& parts) {
  for (Bed& bed : beds_) bed.down_n = bed.stiffness_n_per_m = 0.0;
  force_n_ = 0.0;
  for (const PartContacts::Met& met : parts.met()) {
    const int a = StoneOf(met.a), b = StoneOf(met.b);
    if (a < 0 && b < 0) continue;
    const WorldContact& contact = world.contacts()[static_cast<std::size_t>(met.contact)];
    const Vector3d force_G = contact.impulse_G / step_s;  // on part a
    Bed& bed = beds_[static_cast<std::size_t>(std::max(a, b))];
    bed.down_n += b >= 0 ? force_G.z() : -force_G.z();
    bed.stiffness_n_per_m = std::max(bed.stiffness_n_per_m, contact.material.stiffness_n_per_m);
    force_n_ += contact.normal_G.dot(force_G);
  }
  for (std::size_t i = 0; i < beds_.size(); ++i) {
    Bed& bed = beds_[i];
    if (bed.down_n <= 0.0 && bed.depth_m <= bed.stays_m) continue;
    // To where the soil bears the load, by the stiffness of soil and contact in series.
    double stays_m = bed.stays_m;
    const double borne_n = PressPlate(bed.plate, bed.depth_m, stays_m);
    bed.depth_m += (bed.down_n - borne_n) / (bed.plate.rebound_n_per_m + bed.stiffness_n_per_m);
    PressPlate(bed.plate, bed.depth_m, bed.stays_m);
    bed.depth_m = std::max(bed.depth_m, bed.stays_m);
    parts.Place(first_part_ + static_cast<int>(i), Pose3::Translation(0.0, 0.0, -sunk_m(i)));
  }
}

std::uint64_t BeddedStones::StateHash(std::uint64_t seed) const {
  for (const Bed& bed : beds_) seed = HashDouble(HashDouble(seed, bed.depth_m), bed.stays_m);
  return seed;
}

}  // namespace dockyard
