// Stones in the ground that a robot drives over and presses in. A stone does not tip or roll: it
// goes straight down as the soil under it yields.
#pragma once

#include <cstdint>
#include <vector>

#include "models/parts/soil_model.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/sinking_plate.h"
#include "sim/vehicles/part_contacts.h"

namespace dockyard {

class BeddedStones {
 public:
  /// Stones in G, in this ground. A stone bears like a round plate of its own area. soils: by the
  /// ground's numbers.
  BeddedStones(std::vector<ConvexBody> stones, const std::vector<SoilModel>& soils,
               const HeightGrid& ground);

  /// Makes them parts that others meet. material: of the stones on each other.
  void AddTo(PartContacts& parts, const ContactMaterial& material, const PartGroups& groups);
  /// After a world's step: lets the stones sink that were pressed in it.
  void Sink(const RigidWorld& world, double step_s, PartContacts& parts);

  const std::vector<ConvexBody>& stones() const { return stones_; }  // as they were put down
  /// How far each stone has sunk since [m].
  double sunk_m(std::size_t stone) const { return beds_[stone].depth_m - beds_[stone].start_m; }
  /// Sum of the normal forces on the stones in the last step [N].
  double force_n() const { return force_n_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Bed {
    SinkingPlate plate;
    double start_m = 0.0, depth_m = 0.0;           // of its foot below the ground
    double stays_m = 0.0;                          // of PressPlate
    double down_n = 0.0, stiffness_n_per_m = 0.0;  // of what presses on it
  };
  /// -1: the part is none of them.
  int StoneOf(int part) const;

  std::vector<ConvexBody> stones_;
  std::vector<Bed> beds_;
  int first_part_ = 0;  // theirs follow each other
  double force_n_ = 0.0;
};

}  // namespace dockyard
