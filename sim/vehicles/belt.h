// Forces of the ground on a belt that runs round two rollers. Independent of Bullet.
//
// The belt is divided into pads that travel with it. Each pad that touches carries
// * on the ground's normal the pressure of an elastic layer, integrated over the part of the pad
//   that is below the ground, and bounded damping, never suction;
// * in the ground's plane the elastic shear of the belt, damped, up to the strength mu p + c that
//   the pad's sliding since it touched down has mobilised (Janosi and Hanamoto 1961); beyond it the
//   pad slides, and the strength stands against the sliding (Wong and Chiang, Proc. IMechE D 215,
//   2001). The bend is kept at rest and gone at lift-off, so a resting belt does not creep.
// A pad's load grows and fades as it runs on and off, so the sums do not ripple. The gauge at which
// a robot on belts turns is not put in. docs/reference/physics.md has the equations.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "models/parts/belt.h"
#include "models/parts/soil_model.h"
#include "sim/rigid/motion.h"
#include "sim/soil/height_grid.h"
#include "sim/soil/sinking_plate.h"
#include "sim/soil/soil_laws.h"
#include "sim/vehicles/belt_loop.h"
#include "sim/vehicles/belt_place.h"
#include "sim/vehicles/friction_patches.h"

namespace dockyard {

struct BeltLoad {
  Eigen::Vector3d force_G = Eigen::Vector3d::Zero();   // of the ground on the carrier [N]
  Eigen::Vector3d torque_G = Eigen::Vector3d::Zero();  // about the carrier's origin [N m]
  double normal_n = 0.0;                               // the load that the belt bears
  double traction_n = 0.0;       // along the belt, positive where it drives the carrier forward
  double drive_torque_nm = 0.0;  // that a motor must give the sprocket, rolling loss included
  // Where the belt touches, in the carrier's x; empty, front behind rear, with no pad in contact.
  double front_m = -std::numeric_limits<double>::infinity();
  double rear_m = std::numeric_limits<double>::infinity();
  int pads = 0;  // in contact
};

/// One belt's contact state. Copyable, no globals; the same calls give the same bits.
class Belt {
 public:
  Belt(const BeltModel& belt, const BeltGround& ground);
  /// On soil that the pads sink into, of a friction angle, cohesion and K of its own. It is pressed
  /// by each pad anew, and keeps no rut in the grid: a belt that follows another sinks as deep.
  /// The rolling loss is that of the belt alone; compacting the soil resists by itself.
  Belt(const BeltModel& belt, const SoilModel& soil, double rolling_loss);

  /// The ground of the grid's next number, of another belt of the same model: each pad is on that
  /// below it, and the rolling loss is that below the carrier's origin.
  void AddGround(const Belt& other) { grounds_.push_back(other.grounds_.front()); }

  /// The ground's strength from place to place, on top of its own. The same patches for all belts
  /// of a robot.
  void SetPatches(const FrictionPatches& patches) { patches_ = patches; }

  /// Advances the contact by dt and returns the load. The drive's torque acts between the sprocket
  /// and whatever carries its motor; where that is another link than the carrier, the caller gives
  /// both their reactions.
  BeltLoad Step(const HeightGrid& ground, const LinkMotion& carrier, double belt_speed_m_s,
                double dt_s);

  /// Hash of the contact state, for bit-exact comparison of runs.
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  /// Holds for the step in which the pad touched last, else the pad is as made. Both vectors
  /// forward and left.
  struct Pad {
    std::uint64_t step = 0;
    Eigen::Vector2d slid_m = Eigen::Vector2d::Zero();  // since touch-down
    Eigen::Vector2d bend_m = Eigen::Vector2d::Zero();  // elastic shear of the belt
    double length_m = 0.0;                             // of it that touches
    double sunk_m = 0.0;  // depth of the soil under it that stays when the load goes
  };

  struct Ground {
    BeltGround firm;
    std::optional<SoilLaws> soil{};
    SinkingPlate plate{};  // of the soil under 1 m^2
  };
  /// What bears the pad, before damping [Pa].
  double Pressure(const Ground& on, double depth_m, Pad& pad) const;
  void LoadPad(int index, const BeltTouch& touch, const HeightGrid& ground, BeltPlace& at,
               BeltLoad& load);
  Eigen::Vector2d Grip(const Eigen::Vector2d& slide_m_s, double strength_n, double shear_m,
                       Pad& pad) const;

  BeltModel belt_;
  std::vector<Ground> grounds_;  // by the ground's number
  FrictionPatches patches_;
  BeltLoop loop_;
  double pitch_m_ = 0.0;
  double travel_m_ = 0.0;  // of pad 0's beginning round the loop
  double turned_m_ = 0.0;  // way since the belt turned round, as the rolling loss counts it
  std::uint64_t step_ = 0;
  std::vector<Pad> pads_;
};

}  // namespace dockyard
