// Loose stones on soil, as bodies of a world. The soil presses on their corners; what else touches
// them is for others to find (part_contacts.h). A stone that lies still sleeps.
//
// A step: AddSoilContacts, then the world's step, then Rest.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "models/parts/soil_model.h"
#include "sim/rigid/rigid_world.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/soil_laws.h"
#include "sim/vehicles/loose_stone.h"

namespace dockyard {

class LooseStones {
 public:
  /// soils: by the ground's numbers; each corner is on that below it. The world must outlive this.
  LooseStones(RigidWorld& world, std::vector<SoilModel> soils, double soil_friction);

  /// Its number. A stone starts awake, at rest.
  int Add(const LooseStone& stone);
  /// The soil under a stone is pressed in as deep as its corners are in this ground now.
  void Bed(int stone, const HeightGrid& ground);
  int count() const { return static_cast<int>(stones_.size()); }
  int body(int i) const { return stones_[Place(i)].body; }  // in the world
  const ConvexBody& shape_S(int i) const { return stones_[Place(i)].shape_S; }
  const LinkMotion& motion(int i) const { return world_.body(body(i)).motion(0); }
  double mass_kg(int i) const { return world_.body(body(i)).link(0).model.mass_kg; }
  /// A stone that has lain still for a quarter of a second sleeps: it stays exactly where it is
  /// until a body that moves touches it, or the ground below it changes.
  bool asleep(int i) const { return world_.asleep(body(i)); }

  /// To be called when all other contacts of the step are known, which may wake a stone.
  void AddSoilContacts(const HeightGrid& ground, double step_s);
  /// After the step: lets stones sleep.
  void Rest(const HeightGrid& ground, double step_s);
  std::uint64_t StateHash(std::uint64_t seed) const;

  /// For tests: a load on a stone in the next step [N], and a push out of its sleep.
  void AddForce(int stone, const Eigen::Vector3d& force_G);

 private:
  struct Kept {
    int body = 0;
    ConvexBody shape_S;
    std::vector<SoilLaws> laws;           // by the soil's number
    std::vector<Eigen::Vector3d> area_S;  // of each corner, outwards [m^2]
    std::vector<double> sunk_m;           // of each corner's soil: depth that stays
    double still_s = 0.0, ground_m = 0.0;
  };
  static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
  void WakeIfGroundChanged(Kept& kept, const HeightGrid& ground);
  void AddSoilContacts(Kept& kept, const HeightGrid& ground, double step_s);
  bool IsHeld(const Kept& kept) const;

  RigidWorld& world_;
  std::vector<SoilModel> soils_;
  double soil_friction_ = 0.0;
  std::vector<Kept> stones_;
};

}  // namespace dockyard
