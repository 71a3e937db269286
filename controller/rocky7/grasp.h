// The grasp of Nesnas, Maimone and Das (ICRA 2000), section V: the arm goes down until it feels a
// stone or the ground; then the scoops close, and as they feel resistance the arm is raised in
// small amounts. It ends when they have come to rest, are shut, or after a time, and the arm lifts
// them out of the cameras' view. It feels by the motors' currents alone, and weighs the arm by them
// before and after. Where it weighs, scoops that hold something that does not rise, such as a rock
// in the ground, open again: kMissed; kFailed where the arm does not rise without them either.
#pragma once

#include <string>
#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/rocky7/arm_weight.h"
#include "controller/rocky7/nominal/nominal.h"
#include "controller/rocky7/phases.h"

namespace dockyard::rocky7 {

class Grasp {
 public:
  /// ground_as_body: the ground under the arm is taken to be parallel to the body, not level.
  explicit Grasp(const Nominal& nominal, bool ground_as_body = false);

  /// From the arm as it is stowed, the rover standing. The target is so far to the left of the arm.
  void Start(const SensorFrame& sensed, bool weighs, double aside_m = 0.0);
  /// One period of kDeploy to kLift; what ends the phase, if anything.
  Event Step(Phase phase, const SensorFrame& sensed);
  /// Of the arm's motors, in their order: braked until the first grasp. Lifted, the arm holds what
  /// the scoops have: shut ones feel the same with a stone as without.
  const std::vector<MotorCommand>& commands() const { return commands_; }
  /// What the arm weighs more than before the grasp; unknown where it was not weighed.
  Load load() const;
  const std::string& note() const { return note_; }

 private:
  double Angle(const SensorFrame& sensed, ArmMotor motor) const;
  double Current(const SensorFrame& sensed, ArmMotor motor) const;
  double Open(const SensorFrame& sensed) const;
  /// Against the level, with the scoops' axis at this height over the ground.
  double PitchFor(double height_m, const SensorFrame& sensed) const;
  double ShoulderHeight() const { return nominal_.arm.p_RA.z() + nominal_.rolling_radius_m; }
  /// Pitch against the level; scoops about the ground's normal, open by so much.
  void Turn(const SensorFrame& sensed, double pitch_rad, double pitch_rad_s, double open_rad,
            double scoop_rad_s);
  bool Arrived(const SensorFrame& sensed) const;
  void Weigh(const SensorFrame& sensed, RisingCurrent& rise) const;
  Event Lower(const SensorFrame& sensed);
  Event Close(const SensorFrame& sensed);
  Event Lift(const SensorFrame& sensed);

  const Nominal nominal_;
  const bool ground_as_body_;
  std::size_t first_ = 0;  // of the arm's motors
  Tick since_ = 0;         // the phase began
  std::vector<MotorCommand> commands_;
  double pitch_rad_ = 0.0;  // commanded, against the level
  double aside_rad_ = 0.0;  // roll with which the scoops close over the target
  double roll_rad_ = 0.0;   // commanded
  double usual_a_ = 0.0, raised_rad_ = 0.0, least_open_rad_ = 0.0;
  Tick still_ = 0;
  bool weighs_ = false, releases_ = false;
  RisingCurrent empty_, loaded_;
  std::string note_;
};

}  // namespace dockyard::rocky7
