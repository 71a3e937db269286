// A rover on wheels in soil: body, rockers and bogies with their differential, steering brackets
// and wheels as one tree of links, with a drive on every wheel and every bracket. It may have an
// arm with scoops and a mast.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/parts/rover_model.h"
#include "models/parts/soil_model.h"
#include "sim/drives/bristle.h"
#include "sim/drives/motor_drive.h"
#include "sim/rigid/rigid_world.h"
#include "sim/soil/wheel_soil.h"
#include "sim/vehicles/arm_body.h"
#include "sim/vehicles/mast_body.h"

namespace dockyard {

class WheeledBody {
 public:
  /// Adds its tree to the world, which must outlive this. The body's frame starts at X_GB: R's
  /// place in plan, at the height of the axles. soils: by the ground's numbers.
  WheeledBody(RigidWorld& world, const RoverModel& rover, const std::vector<SoilModel>& soils,
              const Pose3& X_GB);

  /// Motors: the wheels' drives in the plan's order, then the steered wheels' steering in the same
  /// order, then the arm's (arm_model.h), then the mast's (mast_model.h). Angles count from the
  /// start, those of arm and mast from their zeros.
  int motor_count() const { return static_cast<int>(motors_.size()); }
  double angle_rad(int motor) const { return tree().angle_rad(motors_[Place(motor)].link); }
  double rate_rad_s(int motor) const { return tree().rate_rad_s(motors_[Place(motor)].link); }
  const DriveOutput& output(int motor) const { return motors_[Place(motor)].output; }

  /// Loads of the next step under a command for each motor: drives, hinges, soil. Leaves the ruts
  /// in the ground.
  void AddLoads(const std::vector<MotorCommand>& commands, double step_s, HeightGrid& ground);

  int number() const { return number_; }  // in the world
  const TreeBody& tree() const { return world_.body(number_); }
  TreeBody& tree() { return world_.body(number_); }
  const LinkMotion& body() const { return tree().motion(0); }
  const LinkMotion& wheel(int i) const { return tree().motion(wheel_link_[Place(i)]); }
  int wheel_count() const { return static_cast<int>(wheel_link_.size()); }
  int wheel_link(int wheel) const { return wheel_link_[Place(wheel)]; }  // of the tree
  /// Whether a link is a rocker or a bogie.
  bool IsSuspension(int link) const;
  /// The soil's load on a wheel in the last step.
  const WheelLoad& load(int wheel) const { return loads_[Place(wheel)]; }
  /// Angle of the rocker on one side; nose-down positive. 0 of a rigid rover.
  double rocker_rad(bool left) const {
    return rocker_[left] > 0 ? tree().angle_rad(rocker_[left]) : 0;
  }
  bool has_arm() const { return arm_.has_value(); }
  const ArmBody& arm() const { return *arm_; }
  /// The link that a motor of the mast turns; kMastCan (mast_body.h): the instrument.
  int mast_link(int motor) const { return mast_link_ + motor; }
  /// Puts the mast at these angles, for a start.
  void PutMast(const std::array<double, 3>& angle_rad);
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Motor {
    int link = 0;
    MotorDrive drive;
    DriveOutput output;
  };
  /// A passive hinge with friction and stops.
  struct Hinge {
    int link = 0;
    double stop_rad = 0.0, bend_rad = 0.0;  // of the friction's bristle
  };
  static std::size_t Place(int i) { return static_cast<std::size_t>(i); }
  /// The links in a tree's order, with their places in the members.
  std::vector<TreeLink> LinksOf(const RoverModel& rover);
  std::vector<JointTie> TiesOf() const;
  void AddHinge(std::vector<TreeLink>& links, const RoverModel& rover, bool left, bool bogie);
  void AddWheel(std::vector<TreeLink>& links, const RoverModel& rover, std::size_t wheel);

  RigidWorld& world_;
  int number_ = 0;
  int arm_link_ = 0, mast_link_ = 0;  // their first
  int rocker_[2]{}, bogie_[2]{};      // links, right and left; 0: none
  std::vector<int> wheel_link_, bracket_link_;
  std::vector<Hinge> hinges_;
  ShaftBristle hinge_friction_;
  std::vector<Motor> motors_;
  std::vector<WheelSoil> soils_;
  std::vector<WheelLoad> loads_;
  std::optional<ArmBody> arm_;
};

}  // namespace dockyard
