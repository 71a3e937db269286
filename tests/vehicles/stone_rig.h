// Stones between the jaws of a vice, and before the scoops of a rover that a script moves.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/vehicles/loose_stones.h"
#include "sim/vehicles/part_contacts.h"
#include "sim/vehicles/rover_parts.h"
#include "vehicles/rover_rig.h"

namespace dockyard {

/// A box about the origin.
inline ConvexBody BoxBody(const Eigen::Vector3d& size_m) {
  return BoxAt(Eigen::Vector3d::Zero(), size_m);
}

/// Of a rover's scoops, and of stones on each other.
inline ContactMaterial MaterialOf(double friction) { return {2e4, 40.0, friction, 0.0}; }
inline constexpr PartGroups kStoneGroups{part_group::kLooseStones,
                                         part_group::kRover | part_group::kStones};

inline SoilModel SoilNamed(const std::string& name) {
  return LoadSoil(SourceFile("models/soils/" + name + ".yaml"));
}

/// Puts a stone's lowest corner on level ground.
inline LooseStone OnGround(const ConvexBody& shape, double x_m, double y_m, double turn_rad,
                           double density_kg_m3 = kStoneDensity_kg_m3) {
  return MakeLooseStone(shape, density_kg_m3, StandingAt(shape, RotZ(turn_rad), {x_m, y_m}, 0.0));
}

/// A rover with an arm and stones before it.
class ArmRig {
 public:
  ArmRig(const RoverModel& rover, const std::string& soil, double friction = 0.6,
         double step_s = 1e-3)
      : model(rover),
        ground(LevelGrid(-1.0, 3.0, 2.0, 5e-3)),
        body(world, rover, {SoilNamed(soil)},
             Pose3::Translation(0.0, 0.0, RollingRadius(rover.tyre))),
        parts(world),
        stones(world, {SoilNamed(soil)}, 0.6),
        commands(static_cast<std::size_t>(body.motor_count())),
        step_s_(step_s),
        friction_(friction) {
    AddRoverParts(rover, body, friction, parts);
  }

  void Add(const LooseStone& stone) {
    const int number = stones.Add(stone);
    parts.Add({.at = {stones.body(number), 0},
               .body_L = stone.shape_S,
               .material = MaterialOf(friction_),
               .groups = kStoneGroups});
  }
  void Step() {
    body.AddLoads(commands, step_s_, ground);
    parts.AddContacts();
    stones.AddSoilContacts(ground, step_s_);
    world.Step(step_s_);
    stones.Rest(ground, step_s_);
    time_s += step_s_;
  }
  void Run(double time_s) {
    for (int i = 0; i < std::lround(time_s / step_s_); ++i) Step();
  }

  /// The number of the arm's first motor.
  int first_motor() const {
    return body.motor_count() - (model.mast ? kMastMotors : 0) - kArmMotors;
  }
  double angle_rad(int arm_motor) const { return body.angle_rad(first_motor() + arm_motor); }
  double current_a(int arm_motor) const { return body.output(first_motor() + arm_motor).current_a; }
  void Turn(int arm_motor, double angle_rad, double speed_rad_s = 0.4, double current_a = 10.0) {
    commands[static_cast<std::size_t>(first_motor() + arm_motor)] = {
        MotorMode::kPosition, angle_rad, speed_rad_s, 2.0, current_a};
  }
  /// Of the scoops' axis in G.
  Eigen::Vector3d Axis() const { return body.tree().motion(body.arm().link(kFrontScoop)).X_GL.p; }
  /// The body's pitch and the arm's.
  double Pitch() const {
    return ToRollPitchYaw(body.tree().motion(body.arm().link(kArmPitch)).X_GL.R).pitch;
  }

  /// Below the scoops' axis when the arm's end is 50 mm above level ground.
  Eigen::Vector2d PointUnderArm() const {
    const double down_m = model.arm->p_RA.z() + RollingRadius(model.tyre) - 0.05;
    const double ahead_m = std::sqrt(model.arm->length_m * model.arm->length_m - down_m * down_m);
    return (body.body().X_GL * Eigen::Vector3d(model.arm->p_RA.x() + ahead_m, 0.0, 0.0)).head<2>();
  }
  /// Of a stone's centre of mass above the level ground.
  double StoneHeight(int i) const { return stones.motion(i).X_GL.p.z(); }
  /// The same in the arm's frame.
  Eigen::Vector3d StoneInArm(int i) const {
    const Pose3& X_GA = body.tree().motion(body.arm().link(kArmPitch)).X_GL;
    return Inverse(X_GA) * stones.motion(i).X_GL.p;
  }
  /// Straight on by this way of the wheels' rims, at the rover's speed.
  void Drive(double way_m) {
    const double rate = model.plan.speed_m_s / RollingRadius(model.tyre);
    for (std::size_t i = 0; i < model.plan.wheels.size(); ++i) {
      commands[i] = {MotorMode::kVelocity, rate, 0.0, 1.5, 2.0};
    }
    Run(way_m / model.plan.speed_m_s);
    for (std::size_t i = 0; i < model.plan.wheels.size(); ++i) commands[i] = {};
    Run(0.5);
  }

  RoverModel model;
  HeightGrid ground;
  RigidWorld world{{0.0, 0.0, -kEarthGravity_m_s2}};
  WheeledBody body;
  PartContacts parts;
  LooseStones stones;
  std::vector<MotorCommand> commands;  // braked at first
  double time_s = 0.0;
  std::function<void()> each_period;  // of a script

 private:
  double step_s_ = 1e-3, friction_ = 0.6;
};

/// The tangent of the steepest slope between two nodes of a grid, in a square about a place.
double Steepest(const HeightGrid& grid, const Eigen::Vector2d& at, double half_m);

/// A grasp as a controller may do it: from the motors' angles and currents alone, on level ground.
struct GraspScript {
  double open_share = 1.0;    // of the scoops' widest
  double lower_to_m = 0.030;  // axis above the ground
  double feels_a = 0.45;      // current of a scoop that resists
  double ground_a = 0.5;      // rise of the pitch motor's current
  double raise_rad = 0.006;   // in one go
  double raise_most_rad = 0.12;
  double close_rad_s = 0.25;
  double time_out_s = 20.0;
};

enum class GraspEnd { kHeld, kClosed, kTimeOut };

/// Lowers, closes in small raises, lifts by lift_rad; leaves the scoops pressing.
GraspEnd Grasp(ArmRig& rig, const GraspScript& script, double lift_rad);

}  // namespace dockyard
