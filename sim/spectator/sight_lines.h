// The bodies between two points of a logged run, and how near the robot comes to one.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/log/logged_run.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// Run and shapes must outlive it. All places are in the world W [m].
class SightLines {
 public:
  using Which = std::function<bool(const StageBody&)>;

  /// Throws DataError for a log whose bodies are not those of the shapes.
  SightLines(const LoggedRun& run, const StageShapes& shapes);

  /// Whether a triangle of one of these bodies is on the line between both points.
  bool Blocked(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W, std::size_t sample,
               const Which& which) const;
  /// From a point to the nearest of the boxes round the robot's parts, which may be larger than the
  /// parts; 0 within one, infinite without a robot.
  double RobotDistance_m(const Eigen::Vector3d& p_W, std::size_t sample) const;
  /// Largest distance of a body's corners from its origin; 0 for a body that is not drawn.
  double Reach_m(const std::string& name) const;
  /// The corners of the upright box round the robot; none without a robot.
  std::vector<Eigen::Vector3d> RobotCorners_W(std::size_t sample) const;

 private:
  struct Part {
    const RenderMesh* mesh = nullptr;
    Pose3 X_OP, X_PO;  // O: the body's frame
    Eigen::AlignedBox3d box_P;
    Eigen::Vector3d middle_O{0, 0, 0};  // of the box
    double reach_m = 0.0;               // of its corners from there
  };
  struct Body {
    const StageBody* shape = nullptr;
    std::size_t place = 0;  // in the log
    std::vector<Part> parts;
  };
  static Part PartOf(const StagePart& drawn);

  const LoggedRun& run_;
  std::vector<Body> bodies_;
};

}  // namespace dockyard
