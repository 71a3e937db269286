// What a spectator of a run would see: the truth in pictures, for the log, the report and views
// from outside. No controller gets it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/pose.h"

namespace dockyard {

/// Where a body is. Its shape: Plant::Look.
struct BodyPose {
  std::string name;
  Pose3 X_WO;
};

/// A tether or cable.
struct StageLine {
  std::string name;
  double diameter_m = 0.0;
  Eigen::Vector3d rgb{0.6, 0.5, 0.1};  // linear, 0..1
  std::vector<Eigen::Vector3d> points_W;
};

/// Bodies that never move, as triangles of three corners each. Borrowed from the plant.
struct StageSolids {
  std::string name;
  Eigen::Vector3d rgb{0.5, 0.5, 0.5};  // linear, 0..1
  const std::vector<Eigen::Vector3d>* corners_W = nullptr;
};

/// Heights over the site frame G, row by row: height(ix, iy) at x0 + ix * cell, y0 + iy * cell.
/// Borrowed from the plant: good until it advances.
struct StageGround {
  Pose3 X_WG{};
  double x0_m = 0.0, y0_m = 0.0, cell_m = 0.0;
  int nx = 0, ny = 0;
  const double* heights_m = nullptr;   // [iy * nx + ix]
  std::uint64_t revision = 0;          // changes when heights change
  Eigen::Vector3d rgb{0.5, 0.5, 0.5};  // linear, 0..1
};

/// The moving part of what is seen.
struct Stage {
  std::vector<BodyPose> bodies;  // the robot's body first
  std::vector<StageLine> lines;
  std::vector<StageSolids> solids;  // the same in all stages of a run
  StageGround ground;               // without heights: there is none
  Pose3 X_WD;                       // the target's frame on the ground
};

/// A motor and a camera of the robot, as its nominal parameters have them.
struct NamedMotor {
  std::string name;
  double rad_per_count = 0.0;
};
struct NamedCamera {
  std::string name;
  Camera camera;
  Pose3 X_OC;                  // in the body that carries it
  std::string body = "robot";  // that body, one of the stage
};

}  // namespace dockyard
