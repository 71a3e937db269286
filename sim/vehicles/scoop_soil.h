// Forces of soil on a scoop: on its lip as on a narrow blade that is pressed in, on its floor and
// back as on walls that push soil before them. They leave a trench and a heap in the ground.
#pragma once

#include <cstdint>
#include <vector>

#include "models/parts/arm_model.h"
#include "models/parts/soil_model.h"
#include "sim/rigid/motion.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/moved_soil.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {

struct ScoopLoad {
  Eigen::Vector3d force_G{0, 0, 0};
  Eigen::Vector3d torque_G{0, 0, 0};  // about the scoop's origin
  double lip_n = 0.0;                 // of it along the lip's way in
  double deepest_m = 0.0;             // of the lip below the ground; < 0: above it
};

/// The lip bears along its plate. It gives elastically, and yields at p(z) at its depth z below the
/// ground, the greater of a wide plate's k z^n and a narrow blade's (sim/soil/soil_laws.h).
///
/// A piece of a wall at depth z is pushed back by the passive pressure there, as far as its way
/// through the soil has mobilised it, and rubs along the wall with the soil's friction on metal.
/// Either side of the wall counts: it has soil before it whichever way it goes. Depths count from
/// the soil as it was, or from the floor of a trench: the pressure has the heap in it already.
///
/// The soil that a wall sweeps sideways is heaped up where its passive wedge comes out, and slumps
/// where that is too steep, until it has come to rest. What a scoop lifts out is not taken from the
/// ground.
class ScoopSoil {
 public:
  /// soils: by the ground's numbers; the one below the scoop's origin counts.
  ScoopSoil(const ScoopModel& scoop, bool front, const std::vector<SoilModel>& soils);

  /// The load on a scoop that moves so; advances the soil's memory by a step.
  ScoopLoad Step(HeightGrid& ground, const LinkMotion& scoop, double step_s);
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  /// A piece of the lip: how far the soil before it is pressed elastically.
  struct Lip {
    Eigen::Vector3d p_L{0, 0, 0};
    double pressed_m = 0.0;
  };
  /// A piece of a wall: the shares of pressure and rubbing that are mobilised.
  struct Wall {
    Eigen::Vector3d p_L{0, 0, 0}, normal_L{0, 0, 1};
    double area_m2 = 0.0, push = 0.0;
    Eigen::Vector3d rub_G{0, 0, 0};
  };

  void Heap(HeightGrid& ground, const Wall& wall, const Eigen::Vector3d& p_G,
            const Eigen::Vector3d& swept_G, double depth_m) const;

  struct Laws {
    SoilLaws lip, wall;
  };
  std::vector<Laws> all_laws_;
  SoilLaws laws_, wall_laws_;       // those of the last step
  Eigen::Vector3d way_L_{0, 0, 0};  // of the lip, out of its plate
  double lip_area_m2_ = 0.0;        // of a piece
  std::vector<Lip> lips_;
  std::vector<Wall> walls_;
  double reach_m_ = 0.0;  // of what slumps about the scoop
  double since_slump_s_ = 0.0;
  bool slumps_ = false;  // soil that the scoop has moved is not at rest yet
  LooseSlope slope_;
};

}  // namespace dockyard
