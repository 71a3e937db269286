// What detect and pose share: the rig and board of files, the pipeline's name, a pose as JSON.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/io/vision_settings.h"
#include "controller/vision/pose_refine.h"
#include "sim/log/json_io.h"

namespace dockyard {

/// A rover's file (its `cameras`) or a file of cameras with `left` and `right` (docs/cameras.md).
/// Throws ConfigError.
StereoRig RigOf(const std::string& file, int width, int height);
/// A board's file, or a station's: its `board`. Throws ConfigError.
FiducialBoard BoardOf(const std::string& file);

struct PipelineOptions {
  std::string name = "dockyard";
  std::optional<int> min_points{};
  /// Throws UsageError when min_points stands beside another pipeline than tsai2013.
  void RequireSound() const;
  VisionSettings settings() const;
};
void AddPipelineOptions(CLI::App& command, PipelineOptions& options);

/// {p_m, quaternion_wxyz, covariance_order, covariance}; no covariance where the pipeline has none.
Json PoseJson(const Pose3& X_RB, const Matrix6d& covariance);
/// "x 3.812 y 0.014 z 0.301 m, turned ..." for people.
std::string PoseText(const Pose3& X_RB, const Matrix6d& covariance);

}  // namespace dockyard
