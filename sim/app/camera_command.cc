#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/read/load_cameras.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/base/json.h"

namespace dockyard {
namespace {

struct CameraArguments {
  std::string file, name;
  std::vector<double> numbers;
  bool json = false;
};

constexpr const char* kCameraHelp = R"(Points to pixels and pixels to rays, with a camera's file.

Examples:
  dockyard camera project models/cameras/navcam.yaml 2.1 0.3 0.2 --name left
  dockyard camera ray models/cameras/navcam.yaml 512 384 --name left --json
  dockyard camera project tests/models/data/m2020_cameras.json 3 0 0.5 --name HAZFLA

FILE holds one camera, a list of them or a rig: our YAML, NASA's JSON of the cameras of Mars 2020, a
camera_info of ROS, a chain of Kalibr, or YAML or XML of OpenCV (docs/reference/cameras.md). Points
and rays are in the frame of the file's numbers, in metres; pixel 0 0 is the centre of the first
pixel.)";

constexpr const char* kProjectHelp = R"(The pixel that shows a point.

Example:
  dockyard camera project models/cameras/navcam.yaml 2 0.1 0.3 --name left --json

--json: pixel [u, v], or null with the reason; in_image; warnings. A point that the camera cannot
show is no error.)";

constexpr const char* kRayHelp = R"(The points that a pixel shows: origin + s direction, s > 0.

Example:
  dockyard camera ray models/cameras/navcam.yaml 511.5 383.5 --name left --json

--json: origin [x, y, z] in metres, direction [x, y, z] of length 1, or both null with the
reason; in_image; warnings.)";

Json List(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Either form: the JSON, or "key value value" lines.
void Print(Json result, bool json) {
  if (json) {
    result["warnings"] = Json::array();
    std::printf("%s\n", result.dump().c_str());
    return;
  }
  for (const auto& [key, value] : result.items()) {
    if (value.is_array()) {
      std::printf("%-9s", key.c_str());
      for (const Json& number : value) std::printf(" %.10g", number.get<double>());
      std::printf("\n");
    } else {
      const std::string text = value.is_null()      ? "none"
                               : value.is_boolean() ? (value.get<bool>() ? "yes" : "no")
                                                    : value.get<std::string>();
      std::printf("%-9s %s\n", key.c_str(), text.c_str());
    }
  }
}

void RequireFinite(const std::vector<double>& numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw UsageError("expected finite numbers.");
  }
}

int Project(const CameraArguments& arguments) {
  RequireFinite(arguments.numbers);
  const PlacedCamera placed = LoadCamera(arguments.file, arguments.name);
  const Eigen::Vector3d p_F(arguments.numbers[0], arguments.numbers[1], arguments.numbers[2]);
  const auto pixel = placed.camera.Project(Inverse(placed.X_FC) * p_F);
  const bool shown = pixel && pixel->allFinite();  // numbers near the greatest overflow
  Json result{{"pixel", nullptr}};
  if (shown) {
    result = {{"pixel", ToJson(*pixel)}, {"in_image", placed.camera.Sees(*pixel)}};
  } else {
    result["in_image"] = false;
    result["reason"] = "the point lies behind the camera or outside the lens's field of view";
  }
  Print(std::move(result), arguments.json);
  return kExitDone;
}

int Ray(const CameraArguments& arguments) {
  RequireFinite(arguments.numbers);
  const PlacedCamera placed = LoadCamera(arguments.file, arguments.name);
  const Eigen::Vector2d pixel(arguments.numbers[0], arguments.numbers[1]);
  const bool in_image = placed.camera.Sees(pixel);
  Json result;
  if (placed.camera.HasRay(pixel)) {
    const LensRay ray = placed.camera.Ray(pixel);
    result = {{"origin", List(placed.X_FC * ray.origin)},
              {"direction", List(placed.X_FC.R * ray.direction)},
              {"in_image", in_image}};
  } else {
    result = {{"origin", nullptr},
              {"direction", nullptr},
              {"in_image", in_image},
              {"reason", "no ray reaches this pixel"}};
  }
  Print(std::move(result), arguments.json);
  return kExitDone;
}

void AddPart(CLI::App* camera, const char* name, const char* help,
             const std::vector<const char*>& numbers, int (*act)(const CameraArguments&),
             Invocation& call) {
  auto arguments = std::make_shared<CameraArguments>();
  arguments->numbers.resize(numbers.size());
  CLI::App* command = camera->add_subcommand(name, help);
  command->add_option("FILE", arguments->file, "a camera file")->required();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    command->add_option(numbers[i], arguments->numbers[i])->required();
  }
  command->add_option("--name", arguments->name, "which camera, when the file holds several");
  command->add_flag("--json", arguments->json, "the result as JSON");
  command->callback([arguments, act, &call] { call.exit_code = act(*arguments); });
}

}  // namespace

void AddCameraCommand(CLI::App& app, Invocation& call) {
  CLI::App* camera = app.add_subcommand("camera", kCameraHelp);
  camera->require_subcommand(1);
  AddPart(camera, "project", kProjectHelp, {"X", "Y", "Z"}, Project, call);
  AddPart(camera, "ray", kRayHelp, {"U", "V"}, Ray, call);
}

}  // namespace dockyard
