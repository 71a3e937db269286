// Shared by detect and pose: the rig and board of files, the pipeline's name, a pose as JSON.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "controller/geometry/camera.h"
#include "controller/io/vision_settings.h"
#include "controller/vision/pose_refine.h"
#include "models/read/load_board.h"
#include "sim/base/json.h"
#include "sim/run/system.h"

namespace dockyard {

/// Where the cameras come from: a robot's file, or a file of two cameras.
struct RigOptions {
  std::string robot, rig;
};
void AddRigOptions(CLI::App& command, RigOptions& options);
/// The cameras of a robot's file that has them by name; none: it has a pair, or the rig's file is
/// given. Throws ConfigError.
std::optional<std::vector<PlacedCamera>> NamedCamerasOf(const RigOptions& options,
                                                        const std::vector<System>& systems);
/// The one of that name; with an empty name the first. file: for messages. Throws ConfigError.
const PlacedCamera& CameraNamed(const std::string& name, const std::vector<PlacedCamera>& cameras,
                                const std::string& file);
/// The nominal pair of the robot's file, or the cameras `left` and `right` of that or of the rig's
/// file (docs/reference/cameras.md). Throws UsageError unless exactly one of the two is given, and
/// ConfigError.
StereoRig RigOf(const RigOptions& options, const std::vector<System>& systems, int width,
                int height);
/// What the rig's file states its calibration to err [px]; 0 for a robot's cameras. Throws
/// ConfigError.
double CalibrationErrorOf(const RigOptions& options);
/// The board of a board's file, or of a system's target file. Throws ConfigError.
NamedBoard BoardOf(const std::string& file, const std::vector<System>& systems);

struct PipelineOptions {
  std::string name = "dockyard";
  std::optional<int> min_points{};
  /// Throws UsageError when min_points is given with a pipeline other than tsai2013.
  void RequireSound() const;
  VisionSettings settings() const;
};
void AddPipelineOptions(CLI::App& command, PipelineOptions& options);

/// {p_m, quaternion_wxyz, covariance_order, covariance}; no covariance where the pipeline has none.
Json PoseJson(const Pose3& X_RB, const Matrix6d& covariance);
/// "x 3.812 y 0.014 z 0.301 m, turned ..." for people.
std::string PoseText(const Pose3& X_RB, const Matrix6d& covariance);

}  // namespace dockyard
