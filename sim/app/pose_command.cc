#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "controller/vision/point_pose.h"
#include "models/config_error.h"
#include "models/csv_table.h"
#include "models/yaml_reader.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/vision_files.h"

namespace dockyard {
namespace {

struct PoseArguments {
  std::string points, rig;
  int width = 1024, height = 768;
  PipelineOptions pipeline;
  bool json = false;
};

constexpr const char* kHelp = R"(Pose of a body from pixels of its known points, one camera or two.

Examples:
  dockyard pose points.csv --rig models/axel/axel.yaml
  dockyard pose points.csv --rig models/axel/axel.yaml --pipeline tsai2013 --json

POINTS has the columns camera,u_px,v_px,x_m,y_m,z_m: camera is left or right, pixel (0, 0) the middle of
the first pixel, x y z a point of the body. The points may lie in a plane or not; wrong ones are found and
left out. Prints the body's pose in the rover body (metres, unit quaternion w x y z, covariance) and which
points agree. Exit code 4: no pose; the reason is printed.)";

std::vector<PointPixel> LoadPoints(const std::string& file) {
  const YamlNode table = LoadCsv(file);
  std::vector<PointPixel> points;
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    const YamlReader in(table.items[i], "row " + std::to_string(i + 1),
                        {"camera", "u_px", "v_px", "x_m", "y_m", "z_m"});
    PointPixel point;
    point.view = in.Choice("camera", {"left", "right"});
    point.pixel = {in.Number("u_px", Between(-1e5, 1e5)), in.Number("v_px", Between(-1e5, 1e5))};
    point.p_B = {in.Number("x_m", Between(-1e4, 1e4)), in.Number("y_m", Between(-1e4, 1e4)),
                 in.Number("z_m", Between(-1e4, 1e4))};
    points.push_back(point);
  }
  return points;
}

int Pose(const PoseArguments& arguments) {
  arguments.pipeline.RequireSound();
  const std::vector<PointPixel> points = LoadPoints(arguments.points);
  const StereoRig rig = RigOf(arguments.rig, arguments.width, arguments.height);
  const auto pose = PoseFromPoints(points, rig, arguments.pipeline.settings());
  Json json;
  json["pipeline"] = arguments.pipeline.name;
  json["accepted"] = static_cast<bool>(pose);
  json["reason"] = pose ? Json() : Json(Name(pose.error()));
  if (!pose) {
    std::printf("%s\n", arguments.json ? json.dump(2).c_str()
                                       : (std::string("no pose: ") + Name(pose.error())).c_str());
    return kExitNotDocked;
  }
  int used = 0;
  Json inliers = Json::array();
  for (const bool inlier : pose->inlier) {
    used += inlier;
    inliers.push_back(inlier);
  }
  json["method"] = pose->method;
  json["body_in_rover"] = PoseJson(pose->fit.X_RB, pose->fit.covariance);
  json["reprojection_px"] = pose->fit.rms_px;
  json["points_used"] = used;
  json["inlier"] = inliers;
  // Of a plane seen by one camera: the other pose that its picture allows, and by how many sigmas
  // squared it fits worse.
  json["other_branch"] = pose->other_RB ? PoseJson(*pose->other_RB, Matrix6d::Zero()) : Json();
  if (pose->other_RB) json["other_branch"]["cost_more"] = pose->other_cost - pose->fit.cost;
  if (arguments.json) {
    std::printf("%s\n", json.dump(2).c_str());
    return kExitDone;
  }
  std::printf("body (%s, %d of %zu points, %.3f px rms): %s\n", pose->method.c_str(), used,
              points.size(), pose->fit.rms_px,
              PoseText(pose->fit.X_RB, pose->fit.covariance).c_str());
  if (pose->other_RB) {
    std::printf("or, fitting worse by %.1f sigma^2: %s\n", pose->other_cost - pose->fit.cost,
                PoseText(*pose->other_RB, Matrix6d::Zero()).c_str());
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!pose->inlier[i]) std::printf("row %zu left out\n", i + 1);
  }
  return kExitDone;
}

}  // namespace

void AddPoseCommand(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<PoseArguments>();
  CLI::App* command = app.add_subcommand("pose", kHelp);
  command->add_option("POINTS", arguments->points, "a CSV file")->required();
  command->add_option("--rig", arguments->rig, "a rover's file, or a file of two cameras")
      ->required();
  command->add_option("--width", arguments->width, "of the images [px]")
      ->check(CLI::Range(64, 16384));
  command->add_option("--height", arguments->height, "of the images [px]")
      ->check(CLI::Range(64, 16384));
  command->add_flag("--json", arguments->json, "JSON on standard output");
  AddPipelineOptions(*command, arguments->pipeline);
  command->callback([arguments, &exit_code] { exit_code = Pose(*arguments); });
}

}  // namespace dockyard
