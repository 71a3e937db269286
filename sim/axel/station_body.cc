#include "sim/axel/station_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard::axel {
namespace {

// The module in S, tipped: its own frame stands level, and it is tipped about the mouth's centre.
TreeBody FreeModule(const StationModel& station, const Pose3& X_GS) {
  const Pose3 X_SL =
      MouthInStation(station) * Pose3::Translation(0.0, 0.0, -station.mouth_height_m);
  TreeLink link;
  link.model.name = station.module.name;
  link.model.mass_kg = station.module.mass_kg;
  link.model.p_LoCom_L = X_SL * station.module.p_LoCom_L;
  link.model.I_LCom_L = X_SL.R * station.module.I_LCom_L * X_SL.R.transpose();
  return TreeBody({link}, {}, X_GS);
}

}  // namespace

SinkingPlate SoleOf(const StationModel& station, const SoilModel& soil) {
  return station.sole_diameter_m > 0.0 ? RoundPlate(soil, station.sole_diameter_m) : SinkingPlate{};
}

StationBody::StationBody(RigidWorld& world, const StationModel& station, const Pose3& X_GS,
                         const SinkingPlate& sole)
    : world_(world),
      body_(world.Add(FreeModule(station, X_GS))),
      station_(station),
      X_SM_(MouthInStation(station)) {
  DOCKYARD_CHECK(!station.feet.empty());
  feet_.resize(station.feet.size());
  AddSole(sole);
}

GroundMaterial StationBody::MaterialOf(const SinkingPlate& sole) const {
  const double share_kg = station_.module.mass_kg / static_cast<double>(station_.feet.size());
  const bool sinks = sole.force_n_per_m_n > 0.0;
  const double stiffness = sinks ? sole.rebound_n_per_m : station_.foot_stiffness_n_per_m;
  return {stiffness, 2.0 * station_.foot_damping_ratio * std::sqrt(stiffness * share_kg),
          station_.foot_friction, sole};
}

void StationBody::AddFeetForces(const HeightGrid& ground, double dt_s) {
  const LinkMotion& own = motion();
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const Eigen::Vector3d p_G = own.X_GL * station_.feet[i].p_SF;
    const Eigen::Vector3d force_G = GroundForce(ground, soles_.at(ground.SoilAt(p_G)), p_G,
                                                own.VelocityAt(p_G), dt_s, feet_[i]);
    if (!force_G.isZero(0.0)) AddForce(force_G, p_G);
  }
}

Eigen::Matrix3d StationBody::InverseInertia() const {
  const Eigen::Matrix3d& R = motion().X_GL.R;
  return R * link().I_LCom_L.inverse() * R.transpose();
}

double StationBody::sunk_m() const {
  double deepest = 0.0;
  for (const GroundPoint& foot : feet_) deepest = std::max(deepest, foot.sunk_m);
  return deepest;
}

std::uint64_t StationBody::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const GroundPoint& foot : feet_) hash = HashPoint(hash, foot);
  return hash;
}

}  // namespace dockyard::axel
