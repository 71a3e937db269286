// Loose stones on soil, and what a robot's convex parts do to them. Stones press on the soil, on
// the parts and on each other; all contacts that hang together are solved at once, with the robot.
//
// A step: the robot takes its loads (TreeBody::TakeLoads), then Step below, then TreeBody::Move.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "models/parts/soil_model.h"
#include "sim/rigid/body_contact.h"
#include "sim/rigid/contact_solver.h"
#include "sim/rigid/tree_body.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/soil_laws.h"
#include "sim/vehicles/loose_stone.h"

namespace dockyard {

/// A convex part of a link that stones meet, in the link's frame.
struct ToolPart {
  int link = 0;
  ConvexBody body_L;
};

/// How stones give way and rub. A contact gives by half a millimetre under 10 N, as a lip of sheet
/// metal does; in a prototype with these numbers stones of 3-5 cm were held with 0.36 mm of give.
struct StoneMaterial {
  double stiffness_n_per_m = 2e4;  // of a contact with a part or a stone; assumed, 1e4-1e5
  double damping_ns_per_m = 40.0;  // assumed, 20-100
  double friction = 0.6;           // with parts and stones; assumed, 0.3-0.8: rock on steel
  double soil_friction = 0.6;      // assumed, 0.4-0.8
};

/// One point of contact of the last step.
struct StoneTouch {
  int stone = 0;
  int part = -1;         // of the robot; else
  int other_stone = -1;  // a stone with a higher number; else the soil
  int feature = 0;
  Eigen::Vector3d p_G{0, 0, 0}, normal_G{0, 0, 1};  // of the force on the stone
  ContactLaw law;
  Eigen::Vector3d impulse_G{0, 0, 0};  // on the stone [N s]
  Eigen::Vector3d impulse_S{0, 0, 0}, bend_S{0, 0, 0};
};

class LooseStones {
 public:
  /// soils: by the ground's numbers; each corner is on that below it.
  LooseStones(std::vector<ToolPart> parts, std::vector<SoilModel> soils,
              const StoneMaterial& material);

  /// Its number. A stone starts awake, at rest.
  int Add(const LooseStone& stone);
  int count() const { return static_cast<int>(stones_.size()); }
  const LooseStone& stone(int i) const { return stones_[Place(i)].body; }
  /// A stone that has lain still for a quarter of a second sleeps: it stays exactly where it is
  /// until a part or a waking stone touches it, or the ground below it changes.
  bool asleep(int i) const { return stones_[Place(i)].asleep; }
  const std::vector<StoneTouch>& touches() const { return touches_; }

  void Step(TreeBody& tool, const Eigen::Vector3d& gravity_G, double step_s,
            const HeightGrid& ground);
  /// Sweeps of the solver in the last step, at most.
  int sweeps() const { return sweeps_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

  /// For tests: a load on a stone in the next step [N], and a push out of its sleep.
  void AddForce(int stone, const Eigen::Vector3d& force_G);

 private:
  struct Kept {
    LooseStone body;
    std::vector<SoilLaws> laws;           // by the soil's number
    std::vector<Eigen::Vector3d> area_S;  // of each corner, outwards [m^2]
    std::vector<double> sunk_m;           // of each corner's soil: depth that stays
    Eigen::Vector3d load_G{0, 0, 0};
    double still_s = 0.0, ground_m = 0.0;
    bool asleep = false, moved = false;  // moved: in the last step
  };
  static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
  void PlaceParts(const TreeBody& tool);
  void FindParts(int stone);
  void FindStones();
  void FindSoil(int stone, const HeightGrid& ground, double step_s);
  void FindTouches(const TreeBody& tool, const HeightGrid& ground, double step_s);
  void GoOnFromLastStep(StoneTouch& touch) const;
  void AddTouch(StoneTouch touch);
  void Solve(TreeBody& tool, const std::vector<int>& stones, std::vector<StoneTouch*> touches,
             double step_s);
  void SolveAll(TreeBody& tool, double step_s);
  void Rest(Kept& kept, const HeightGrid& ground, double step_s);

  std::vector<ToolPart> parts_;
  std::vector<Pose3> part_poses_;              // in G, of the links
  std::vector<Eigen::Vector3d> part_centres_;  // in G
  Eigen::Vector3d parts_centre_G_{0, 0, 0};
  double parts_reach_m_ = 0.0;  // of a sphere about it that holds all parts
  std::vector<SoilModel> soils_;
  StoneMaterial material_;
  std::vector<Kept> stones_;
  std::vector<StoneTouch> touches_, last_touches_;
  std::vector<BodyContact> found_;
  ContactStepOf<kManyContacts> step_;
  int sweeps_ = 0;
};

}  // namespace dockyard
