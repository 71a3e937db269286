// A planar stand-in for the rover, for testing the controller without physics: wheels that slip,
// turns that fall short, a stiff tether on a rated spool, an arm that lifts when the tether is
// slack, and cameras that report the true board pose through a lens with edges and noise.
#pragma once

#include <memory>
#include <optional>

#include "controller/axel/axel.h"
#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "sim/base/random.h"

namespace dockyard::axel {

/// A frame of a rover at rest: all counts and currents zero, no images.
inline SensorFrame StillFrame() {
  SensorFrame frame;
  frame.motors.resize(kMotorCount);
  return frame;
}

/// A nominal with round numbers in the ranges of the Axel class.
Nominal TestNominal();

struct KinematicWorld {
  double slip = 0.05;            // share of the rolled way that is lost
  double heading_short = 0.25;   // share of the commanded turn that is lost
  double vision_noise = 0.0;     // 1: range sigma 0.008 m/m^2, heading 1 deg/m, bearing 0.3 deg
  double yaw_drift_rad_s = 0.0;  // of the inertial unit
  double slack_m = 0.10;         // at power-on
  double marks_range_m = 6.0;    // no detection beyond
  double roll_tension_n = 60.0;  // that pulls the freely rolling rover along
  bool blind = false;
  bool while_driving = false;         // the controller may look under way
  Tick images_late = 0;               // from the exposure to the frame that brings them
  bool images_lost = false;           // of a moving rover
  std::optional<double> jam_depth_m;  // the tip goes no deeper than this, once
  std::optional<double> held_at_m;    // the axle comes no nearer than this, once: the wheels spin
  // In reverse the axle comes no farther out than this, on one leg: the wheels dig.
  std::optional<double> held_back_at_m;
  std::uint64_t seed = 1;
};

class KinematicRover {
 public:
  KinematicRover(const Nominal& nominal, const KinematicWorld& world, const Pose2& X_DR);

  /// The sensors' present readings.
  SensorFrame Sense();
  /// One control period under these commands.
  void Step(const Commands& commands);
  /// Sees the board from the true pose at the exposure.
  LocateOutput Locate();

  const Pose2& X_DR() const { return X_DR_; }
  double tension_n() const { return tension_n_; }
  double elevation_rad() const { return elevation_; }
  double depth_m() const;       // tip behind the mouth plane
  double tip_offset_m() const;  // beside the cone's axis
  int sightings() const { return sightings_; }
  /// The leg on which the wheels dug is over.
  void ComeOff() {
    if (dug_) world_.held_back_at_m.reset();
  }
  void Unjam() {
    world_.jam_depth_m.reset();
    world_.held_at_m.reset();
  }

  // The places when the tip last passed the mouth.
  struct Entry {
    double offset_m = 0.0, heading_rad = 0.0;
  };
  const std::optional<Entry>& entry() const { return entry_; }

 private:
  void MoveWheels(const Commands& commands);
  void MoveArm(const Commands& commands);
  void MoveSpool(const MotorCommand& command);
  void PullAlong();
  void Guide(const Pose2& before);
  double Path() const;
  double Guided() const;

  Nominal nominal_;
  KinematicWorld world_;
  RandomStream noise_;
  Pose2 X_DR_;
  Tick tick_ = 0;
  double yaw_ = 0.0, pitch_ = 0.0, elevation_ = 0.0, arm_ = 0.0;
  double left_ = 0.0, right_ = 0.0, left_speed_ = 0.0, right_speed_ = 0.0;
  double free_m_ = 0.0, reeled_m_ = 0.0, reel_speed_ = 0.0, tension_n_ = 0.0;
  double spool_current_ = 0.0;
  bool wheels_free_ = false, images_due_ = false, dug_ = false;
  // Images are exposed in the frame after the question.
  struct Exposed {
    Tick tick = 0;
    Pose2 X_DR;
    double pitch = 0.0;
  };
  std::optional<Exposed> on_the_way_;
  Exposed seen_;
  int sightings_ = 0;
  std::optional<Entry> entry_;
};

/// A docking in closed loop with the stand-in.
struct KinematicRun {
  Verdict verdict = Verdict::kUnderWay;
  double time_s = 0.0;
  double depth_m = 0.0;
  std::optional<KinematicRover::Entry> entry;
  Belief belief;
  int sightings = 0;
  double max_elevation_rad = 0.0, max_way_tension_n = 0.0;  // until it reels in
  std::vector<Commands> commands;                           // every tick
  std::vector<std::string> phases;                          // as they changed
  std::vector<Pose2> path;                                  // true, every second
};
KinematicRun RunKinematic(const KinematicWorld& world, const DockingCoords& start,
                          const AxelOptions& options = {}, double limit_s = 600.0);

}  // namespace dockyard::axel
