// The parts of World.
#pragma once

#include <array>
#include <optional>

#include "sim/axel/cable_tether.h"
#include "sim/axel/contact_world.h"
#include "sim/axel/drive_train.h"
#include "sim/axel/rover_body.h"
#include "sim/axel/rover_ground.h"
#include "sim/axel/station_body.h"
#include "sim/axel/tether.h"
#include "sim/axel/world.h"
#include "sim/drives/imu.h"
#include "sim/soil/wheel_soil.h"

namespace dockyard::axel {

/// All motion is computed in the site frame G; the world frame W enters with the truth only.
class World::Impl {
 public:
  explicit Impl(WorldSetup setup);

  void Step(const std::array<MotorCommand, kMotorCount>& commands);
  Truth MakeTruth() const;
  Tick tick() const;
  bool at_rest() const { return still_steps_ >= kRestSteps; }
  double time_s() const { return static_cast<double>(steps_) * setup_.step_s; }
  const HeightGrid& ground() const { return ground_; }
  TrueImu TakeTrueImu() { return imu_.Take(rover_.motion(RoverLink::kBody), X_WG_); }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  // At rest: no speed was above these for this many steps. Such a speed moves a body by half a
  // micrometre in a minute. Assumed, range 1e-10 to 1e-7 and 20-200 steps.
  static constexpr double kStill_m_s = 1e-8, kStill_rad_s = 1e-8;
  static constexpr int kRestSteps = 50;
  // A cable's masses of 4 g that swing or creep slower than this move nothing. Assumed, range 1e-4
  // to 1e-2.
  static constexpr double kStillCable_m_s = 1e-3;
  // It shakes rover and station by more than the limits above. Assumed, range 10-1000.
  static constexpr double kSlowerWithCable = 100.0;

  void TieTether();
  void Settle();
  void Move(const std::array<MotorCommand, kMotorCount>& commands);
  bool NoneFaster(double m_s, double rad_s) const;
  bool IsStill() const;
  double PullTether();
  double PullCable();
  void RollOnSoil();
  void RollWheel(RoverLink link, WheelSoil& soil, WheelLoad& load);
  Eigen::Vector3d TipInG() const;
  Eigen::Vector3d TipInMouth() const;
  Eigen::Vector3d TipVelocityInMouth() const;
  void TellMotion(Truth& truth) const;
  void TellMotors(Truth& truth) const;
  void TellTether(Truth& truth) const;

  WorldSetup setup_;
  Pose3 X_WG_;
  Eigen::Vector3d gravity_G_;  // [m/s^2]; leans where the site is a slope
  HeightGrid ground_;
  RigidWorld rigid_;
  RoverBody rover_;
  StationBody station_;
  StationHand hand_;
  ContactWorld contacts_;
  DriveTrain drives_;
  Tether tether_;
  std::optional<CableTether> cable_;  // in place of the massless tether
  RoverGround rover_ground_;
  WheelSoil left_soil_, right_soil_;
  std::array<WheelLoad, 2> loads_;  // of the left wheel and the right one
  ImuAverage imu_;
  TetherLoad pull_;
  bool tether_tied_ = false;        // on level ground not before the rover has settled
  double tether_at_start_m_ = 0.0;  // unstretched length out of the arm at power-on
  Eigen::Vector3d p_GM_start_ = Eigen::Vector3d::Zero();
  bool settled_ = false;
  std::int64_t steps_ = 0;
  int still_steps_ = 0;  // with the last commands
  std::array<MotorCommand, kMotorCount> last_commands_{};
};

}  // namespace dockyard::axel
