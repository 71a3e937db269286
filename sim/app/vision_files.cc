#include "sim/app/vision_files.h"

#include <cstdio>

#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "models/read/near_names.h"
#include "sim/app/commands.h"

namespace dockyard {

void AddRigOptions(CLI::App& command, RigOptions& options) {
  command.add_option("--robot", options.robot, "a robot's file: its cameras");
  command.add_option(
      "--rig", options.rig,
      "instead: a file of two cameras, left and right; or two of one each, LEFT,RIGHT");
}

StereoRig RigOf(const RigOptions& options, const std::vector<System>& systems, int width,
                int height) {
  if (options.robot.empty() == options.rig.empty()) {
    throw UsageError("give one of --robot FILE and --rig FILE");
  }
  if (!options.rig.empty()) return LoadRig(options.rig, width, height, Rays::kMasked);
  for (const System& system : systems) {
    if (!system.files.rig) continue;
    if (const auto rig = system.files.rig(options.robot, width, height)) return *rig;
  }
  if (const auto cameras = NamedCamerasOf(options, systems)) {
    const auto camera = [&](const char* name, const Pose3*& X_RC) {
      const PlacedCamera& placed = CameraNamed(name, *cameras, options.robot);
      X_RC = &placed.X_FC;
      return width > 0 ? Resized(placed.camera, width, height) : placed.camera;
    };
    const Pose3 *X_RL = nullptr, *X_RQ = nullptr;
    const Camera left = camera("left", X_RL), right = camera("right", X_RQ);
    return {left, right, *X_RL, *X_RQ};
  }
  throw ConfigError(options.robot + ": expected a robot's file with cameras, found another");
}

std::optional<std::vector<PlacedCamera>> NamedCamerasOf(const RigOptions& options,
                                                        const std::vector<System>& systems) {
  if (options.robot.empty() || !options.rig.empty()) return std::nullopt;
  for (const System& system : systems) {
    if (!system.files.cameras) continue;
    if (auto cameras = system.files.cameras(options.robot)) return cameras;
  }
  return std::nullopt;
}

const PlacedCamera& CameraNamed(const std::string& name, const std::vector<PlacedCamera>& cameras,
                                const std::string& file) {
  if (cameras.empty()) throw ConfigError(file + ": expected a robot with cameras, found none");
  if (name.empty()) return cameras.front();
  std::vector<std::string> known;
  for (const PlacedCamera& camera : cameras) {
    if (camera.name == name) return camera;
    known.push_back(camera.name);
  }
  throw ConfigError(file + ": expected a camera '" + name + "' in the list 'cameras', found none" +
                    DidYouMeanOrKnown(name, known));
}

double CalibrationErrorOf(const RigOptions& options) {
  return options.rig.empty() ? 0.0 : LoadCalibrationError(options.rig);
}

NamedBoard BoardOf(const std::string& file, const std::vector<System>& systems) {
  if (IsBoardFile(LoadYaml(file))) return LoadBoard(file);
  for (const System& system : systems) {
    if (!system.files.board) continue;
    if (auto board = system.files.board(file)) return *board;
  }
  throw ConfigError(file + ": expected a board's file or a target's with a board, found another");
}

VisionSettings PipelineOptions::settings() const {
  const bool tsai = name == PipelineName(VisionPipeline::kTsai2013);
  VisionSettings settings{.pipeline = tsai ? VisionPipeline::kTsai2013 : VisionPipeline::kDockyard};
  settings.min_points = min_points.value_or(settings.min_points);
  return settings;
}

void PipelineOptions::RequireSound() const {
  if (!min_points || settings().pipeline == VisionPipeline::kTsai2013) return;
  throw UsageError("--min-points is a choice of --pipeline tsai2013 alone");
}

void AddPipelineOptions(CLI::App& command, PipelineOptions& options) {
  command.add_option("--pipeline", options.name, "dockyard (default) or tsai2013")
      ->check(CLI::IsMember(
          {PipelineName(VisionPipeline::kDockyard), PipelineName(VisionPipeline::kTsai2013)}));
  command
      .add_option("--min-points", options.min_points,
                  "tsai2013: detections given to the homography, 4 (default) or 5")
      ->check(CLI::Range(4, 5));
}

Json PoseJson(const Pose3& X_RB, const Matrix6d& covariance) {
  const Eigen::Quaterniond q(X_RB.R);
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  Json json{{"p_m", {X_RB.p.x(), X_RB.p.y(), X_RB.p.z()}},
            {"quaternion_wxyz", {sign * q.w(), sign * q.x(), sign * q.y(), sign * q.z()}}};
  if (covariance.isZero()) return json;
  json["covariance_order"] = {"p_x_m", "p_y_m", "p_z_m", "turn_x_rad", "turn_y_rad", "turn_z_rad"};
  Json rows = Json::array();
  for (int i = 0; i < 6; ++i) {
    Json row = Json::array();
    for (int j = 0; j < 6; ++j) row.push_back(covariance(i, j));
    rows.push_back(row);
  }
  json["covariance"] = rows;
  return json;
}

std::string PoseText(const Pose3& X_RB, const Matrix6d& covariance) {
  const Eigen::Quaterniond q(X_RB.R);
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  char text[300];
  std::snprintf(text, sizeof text, "p %.4f %.4f %.4f m, quaternion wxyz %.5f %.5f %.5f %.5f",
                X_RB.p.x(), X_RB.p.y(), X_RB.p.z(), sign * q.w(), sign * q.x(), sign * q.y(),
                sign * q.z());
  std::string line = text;
  if (covariance.isZero()) return line;
  const Eigen::Matrix<double, 6, 1> s = covariance.diagonal().cwiseSqrt();
  std::snprintf(text, sizeof text, ", 1 sigma %.4f %.4f %.4f m, %.3f %.3f %.3f deg", s(0), s(1),
                s(2), Degrees(s(3)), Degrees(s(4)), Degrees(s(5)));
  return line + text;
}

}  // namespace dockyard
