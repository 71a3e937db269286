// An arm with two scoops as links of a tree, with the soil on its scoops.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/parts/arm_model.h"
#include "models/parts/soil_model.h"
#include "sim/rigid/rigid_world.h"
#include "sim/vehicles/carried_soil.h"
#include "sim/vehicles/scoop_soil.h"

namespace dockyard {

/// The arm's links on link 0, in the order of its motors. `first`: the number of the first one.
std::vector<TreeLink> ArmLinks(const ArmModel& arm, int first);

/// What a motor of the arm turns with no load, its rotor included [kg m^2].
double ArmInertia(const ArmModel& arm, int motor);

/// Adds the stops of the joints and the scoops' lips on each other. `first`: of the arm's links.
void LimitArm(const ArmModel& arm, const BodyLink& first, RigidWorld& world);

class ArmBody {
 public:
  ArmBody(const ArmModel& arm, int first, const std::vector<SoilModel>& soils);

  /// Puts the arm as it is stowed.
  void Stow(TreeBody& tree) const;
  /// Of the soil on the scoops, for the next step.
  void AddSoilLoads(TreeBody& tree, HeightGrid& ground, double step_s);

  int link(int motor) const { return first_ + motor; }
  const ArmModel& model() const { return model_; }
  const CarriedSoil& carried() const { return carried_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  ArmModel model_;
  int first_ = 0;
  std::array<ScoopSoil, 2> soils_;  // back, front
  CarriedSoil carried_;
};

}  // namespace dockyard
