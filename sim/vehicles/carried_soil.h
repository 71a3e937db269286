// Soil that two shut scoops lift out of the ground: what lies on their floors. It weighs on the
// arm, and runs out as soon as the lips part.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "models/parts/arm_model.h"
#include "models/parts/soil_model.h"
#include "sim/rigid/motion.h"
#include "sim/soil/height_grid.h"

namespace dockyard {

/// A floor is cut into pieces. While the lips are together, a piece under the ground takes the soil
/// above it: up to the scoops' axis where the sides are closed, and no steeper than the soil's
/// friction angle from an open side. As the piece rises, what stands out of the ground is taken
/// from it. A stone in the scoops takes no room.
class CarriedSoil {
 public:
  /// soils: by the ground's numbers.
  CarriedSoil(const ScoopModel& scoop, const std::vector<SoilModel>& soils);

  /// Weights of the soil on one scoop.
  struct Load {
    Eigen::Vector3d force_G{0, 0, 0};
    Eigen::Vector3d torque_G{0, 0, 0};  // about the scoop's origin
  };
  /// scoops: front, back, as they move now. open_rad: between them. Takes soil from the ground, or
  /// gives it back.
  std::array<Load, 2> Step(HeightGrid& ground, const std::array<const LinkMotion*, 2>& scoops,
                           double open_rad);

  double volume_m3() const { return volume_m3_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Piece {
    std::size_t scoop = 0;
    Eigen::Vector3d p_L{0, 0, 0};
    double area_m2 = 0.0, to_side_m = 0.0;
    double high_m = 0.0;   // of the soil on it
    double taken_m = 0.0;  // of that, what is no more in the ground
  };

  void Raise(HeightGrid& ground, const LinkMotion& scoop, Piece& piece);
  void Spill(HeightGrid& ground, const std::array<const LinkMotion*, 2>& scoops);

  void Slumps(HeightGrid& ground, const Eigen::Vector3d& at_G, int most_passes);

  ScoopModel scoop_;
  std::vector<SoilModel> soils_;
  std::vector<Piece> pieces_;
  double volume_m3_ = 0.0, density_kg_m3_ = 0.0, gravity_m_s2_ = 0.0;
  bool slumps_ = false;  // the ground from which soil was taken is not at rest yet
};

}  // namespace dockyard
