// Stones in the ground that a rover's wheels drive over and press in. A stone does not tip or roll:
// it goes straight down as the soil under it yields.
#pragma once

#include <cstdint>
#include <vector>

#include "models/parts/soil_model.h"
#include "sim/rigid/body_contact.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/sinking_plate.h"
#include "sim/vehicles/wheeled_body.h"

namespace dockyard {

class WheelStones {
 public:
  /// Stones in G, standing in this ground. A stone bears like a round plate of its own area.
  /// soils: by the ground's numbers.
  WheelStones(std::vector<ConvexBody> stones, const std::vector<SoilModel>& soils,
              const HeightGrid& ground, const WheelModel& tyre, double friction);

  /// Adds the stones' loads of the next step to the wheels, and lets the pressed stones sink.
  void AddLoads(double step_s, WheeledBody& rover);

  const std::vector<ConvexBody>& stones() const { return stones_; }  // as they were put down
  /// How far each stone has sunk since [m].
  double sunk_m(std::size_t stone) const { return beds_[stone].depth_m - beds_[stone].start_m; }
  /// Sum of the normal forces on a wheel in the last step [N].
  double force_n() const { return force_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Bed {
    SinkingPlate plate;
    double start_m = 0.0, depth_m = 0.0;  // of its foot below the ground
    double stays_m = 0.0;                 // of PressPlate
  };
  /// A contact that sticks, from step to step.
  struct Grip {
    int wheel = 0, stone = 0, feature = 0;
    Eigen::Vector3d bend_G{0, 0, 0};
  };
  /// Force on the wheel at a contact in G.
  Eigen::Vector3d Press(const BodyContact& contact, const LinkMotion& wheel, double step_s,
                        Grip& grip) const;
  Eigen::Vector3d BendBefore(const Grip& grip) const;

  std::vector<ConvexBody> stones_;
  std::vector<Bed> beds_;
  WheelModel tyre_;
  double friction_ = 0.0, reach_m_ = 0.0, force_n_ = 0.0;
  std::vector<Grip> grips_;
};

}  // namespace dockyard
