// A planar world for testing the docking without physics: a robot whose wheels follow their
// commands and are larger than nominal, a dock that it cannot drive through, and sightings with
// errors in place of images.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller/custom/sighting.h"
#include "controller/io/controller.h"
#include "controller/motion/path_follower.h"

namespace dockyard::custom {

struct KinematicWorld {
  std::uint64_t seed = 1;
  Pose2 X_DR_start{1.5, 0.0, kPi};
  double left_scale = 1.0, right_scale = 1.0;  // wheels' true radii over nominal
  double turn_share = 1.0;                     // of the turns of wheels without slip
  double yaw_rad_per_sqrt_s = 0.0;             // random walk of the unit's yaw
  // Sightings: 1 sigma of their errors at a range r [m].
  std::function<double(double)> range_m = [](double r) { return 0.001 + 0.004 * r * r; };
  std::function<double(double)> aside_m = [](double r) { return 0.001 + 0.001 * r; };
  std::function<double(double)> turn_rad = [](double r) { return 0.01 + 0.02 * r; };
  double latency_s = 0.0, dropout = 0.0;  // dropout: share of images without marks
  double farthest_m = 3.5;                // to which marks show
  bool mirrored = true;                   // each sighting has the false branch, too
  bool camera_answers = true;
  std::function<bool(double time_s, double range_m)> marks_show{};  // empty: always
  double board_aside_m = 0.0;  // the board off its drawing, along y of D
  double contact_m = 0.008;    // the contact closes within this of the docked place
  double stop_m = 0.003;       // beyond which the dock stops the robot
  bool stalls = false;         // there the motors stop, too; else the wheels slip
  // The contact closes only at the second touch, after a turn by this with wheels pressing.
  double wiggle_rad = 0.0;
};

struct KinematicRun {
  Verdict verdict{};
  double time_s = 0.0;
  double along_m = 0.0, aside_m = 0.0, off_rad = 0.0;  // from the docked pose at the end
  double branch_open_s = 0.0;
  std::vector<std::string> phases;  // as they changed
  std::vector<Twist> twists;        // of A, true, each period
  Belief belief;
  bool closed = false;  // the contact at the end
};

/// Until the controller's verdict or the limit.
KinematicRun RunKinematic(const Nominal& nominal, const KinematicWorld& world,
                          double limit_s = 300.0);

}  // namespace dockyard::custom
