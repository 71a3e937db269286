// A planar stand-in for the robot, for testing the controller without physics: belts that follow at
// once, turns that come out otherwise than the odometry has them, and drawn pictures that arrive a
// period late. Nothing touches: the robot drives through the pyramid.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "raposa/controller/drawn_marks.h"

namespace dockyard::raposa {

struct KinematicWorld {
  double lever_m = 0.0;         // from the camera to the turning centre
  double turn_share = 1.0;      // of the odometry's turns that come about
  int every = 1;                // period with a picture
  double camera_until_s = 1e9;  // then it is silent
  Scene scene{};
  std::function<Scene(double time_s)> scene_at{};  // in place of it
};

struct KinematicRun {
  Verdict verdict = Verdict::kUnderWay;
  double time_s = 0.0;
  int passes = 0;
  std::vector<std::string> phases;    // as they changed
  std::vector<double> estimates_deg;  // at the begin of each pass
  std::vector<Pose2> after_passes;    // the camera in P at the end of each
  Commands last;
  Belief belief;
  Pose2 X_PC;  // the camera at the end
  double lamps_from_m = 0.0, arm_from_m = 0.0, most_arm_rad = 0.0;

  // The guide before the camera at the end.
  double ahead_m() const;
  double aside_m() const;
  double off_axis_rad() const;  // of the camera's axis against the guide's
  /// Within reach of the doors, and no farther off than the bi-cone enters; assumed, 10-20 mm and
  /// 18 deg.
  bool reached() const;
};

/// From a pose of the camera in P, until the controller's verdict or the limit.
KinematicRun RunKinematic(const Nominal& nominal, const Pose2& X_PC, const KinematicWorld& world,
                          double limit_s = 300.0);
/// The same with the nominal parameters of the tests, at a point of the grid.
KinematicRun RunKinematicAt(double r_m, double alpha_deg, const KinematicWorld& world = {},
                            double limit_s = 300.0);

}  // namespace dockyard::raposa
