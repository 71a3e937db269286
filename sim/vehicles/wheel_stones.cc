#include "sim/vehicles/wheel_stones.h"

#include <algorithm>
#include <cmath>

#include "sim/base/hash.h"
#include "sim/vehicles/wheel_contact.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Of a wheel's metal on stone: 1 mm under a wheel's load of 25 N. Assumed, 1e4-1e5 N/m and 20-200
// N s/m.
constexpr double kStiffness_n_per_m = 2.5e4, kDamping_ns_per_m = 60.0;
// Nearer than this a stone is looked at [m].
constexpr double kNear_m = 0.01;

}  // namespace

WheelStones::WheelStones(std::vector<ConvexBody> stones, const std::vector<SoilModel>& soils,
                         const HeightGrid& ground, const WheelModel& tyre, double friction)
    : stones_(std::move(stones)), tyre_(tyre), friction_(friction) {
  const double radius_m = RollingRadius(tyre), half_m = 0.5 * tyre.width_m;
  reach_m_ = std::hypot(radius_m, half_m) + kNear_m;
  for (const ConvexBody& stone : stones_) {
    Eigen::Vector3d low = stone.centre, high = stone.centre;
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

Vector3d WheelStones::BendBefore(const Grip& grip) const {
  for (const Grip& before : grips_) {
    if (before.wheel == grip.wheel && before.stone == grip.stone &&
        before.feature == grip.feature) {
      return before.bend_G;
    }
  }
  return Vector3d::Zero();
}

Vector3d WheelStones::Press(const BodyContact& contact, const LinkMotion& wheel, double step_s,
                            Grip& grip) const {
  const Vector3d v_G = wheel.VelocityAt(contact.p);
  const double apart_m_s = contact.normal.dot(v_G);
  const double pressed_n = std::max(
      0.0, contact.share * (kStiffness_n_per_m * contact.depth_m - kDamping_ns_per_m * apart_m_s));
  const double across_n_per_m = contact.share * kStiffness_n_per_m;
  const Vector3d slide_G = v_G - apart_m_s * contact.normal;
  Vector3d bend_G = BendBefore(grip) + step_s * slide_G;
  bend_G -= contact.normal.dot(bend_G) * contact.normal;
  const double most_m = friction_ * pressed_n / across_n_per_m;
  if (bend_G.norm() > most_m) bend_G *= most_m / bend_G.norm();
  grip.bend_G = bend_G;
  Vector3d rubbing_n = -across_n_per_m * bend_G - contact.share * kDamping_ns_per_m * slide_G;
  if (rubbing_n.norm() > friction_ * pressed_n) {
    rubbing_n *= friction_ * pressed_n / rubbing_n.norm();
  }
  return pressed_n * contact.normal + rubbing_n;
}

void WheelStones::AddLoads(double step_s, WheeledBody& rover) {
  std::vector<Grip> grips;
  std::vector<BodyContact> contacts;
  force_n_ = 0.0;
  for (std::size_t s = 0; s < stones_.size(); ++s) {
    const ConvexBody& stone = stones_[s];
    Bed& bed = beds_[s];
    const Vector3d sunk_G(0.0, 0.0, bed.start_m - bed.depth_m);
    double down_n = 0.0;
    for (int w = 0; w < rover.wheel_count(); ++w) {
      const LinkMotion& wheel = rover.wheel(w);
      const Vector3d off_G = wheel.X_GL.p - stone.centre - sunk_G;
      if (off_G.squaredNorm() > (reach_m_ + stone.radius_m) * (reach_m_ + stone.radius_m)) continue;
      contacts.clear();
      AddWheelContacts(stone, tyre_, {wheel.X_GL.R, wheel.X_GL.p - sunk_G}, contacts);
      for (BodyContact& contact : contacts) {
        contact.p += sunk_G;
        grips.push_back({w, static_cast<int>(s), contact.feature, Vector3d::Zero()});
        const Vector3d force_G = Press(contact, wheel, step_s, grips.back());
        rover.tree().AddForce(rover.wheel_link(w), force_G, contact.p);
        down_n += force_G.z();
        force_n_ += force_G.dot(contact.normal);
      }
    }
    if (down_n <= 0.0 && bed.depth_m <= bed.stays_m) continue;
    // To where the soil bears the load, by the stiffness of soil and contact in series.
    double stays_m = bed.stays_m;
    const double borne_n = PressPlate(bed.plate, bed.depth_m, stays_m);
    bed.depth_m += (down_n - borne_n) / (bed.plate.rebound_n_per_m + kStiffness_n_per_m);
    PressPlate(bed.plate, bed.depth_m, bed.stays_m);
    bed.depth_m = std::max(bed.depth_m, bed.stays_m);
  }
  grips_ = std::move(grips);
}

std::uint64_t WheelStones::StateHash(std::uint64_t seed) const {
  for (const Bed& bed : beds_) seed = HashDouble(HashDouble(seed, bed.depth_m), bed.stays_m);
  for (const Grip& grip : grips_) seed = HashDouble(seed, grip.bend_G.norm());
  return seed;
}

}  // namespace dockyard
