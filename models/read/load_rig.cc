#include <algorithm>
#include <cmath>
#include <filesystem>

#include "models/read/calibrations.h"
#include "models/read/camera_pose.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "models/read/opencv_storage.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr double kLeastBaseline_m = 0.01;

/// Two cameras in one frame F, and where errors about them point.
struct Pair {
  PlacedCamera left, right;
  Pose3 X_RF;
  std::string place, left_place, right_place;
  double calibration_error_px = 0.0;
};

/// Two cameras of files of their own. The frame is the left camera's.
void PlaceByRectified(Pair& pair) {
  if (!pair.left.X_PC || !pair.right.X_PC) return;
  pair.right.X_FC = Inverse(*pair.left.X_PC) * *pair.right.X_PC;
  pair.left.X_FC = Pose3{};
}

[[noreturn]] void RefuseSingle(const YamlNode& root, const std::string& found) {
  throw ConfigError(root.place.Text() + ": expected a pair of cameras, found " + found +
                    "; give two files as LEFT,RIGHT, or a file of left: {file: ...} and right: "
                    "{file: ...} (docs/reference/cameras.md)");
}

Pair OfOurs(const YamlNode& root) {
  const YamlReader in = RigReader(root);
  in.TextOr("name", "-");
  in.TextOr("source", "-");
  Pair pair;
  if (in.Has("in_rover")) {
    pair.X_RF = ReadBodyPose(YamlReader(in.Child("in_rover"), "in_rover", PoseKeys()));
  }
  pair.left = ReadSide(in, "left");
  pair.right = ReadSide(in, "right");
  PlaceByRectified(pair);
  pair.calibration_error_px = ReadCalibrationError(in);
  pair.place = root.place.Text();
  pair.left_place = in.Child("left").place.Text() + ": left";
  pair.right_place = in.Child("right").place.Text() + ": right";
  return pair;
}

/// Of the two cameras of another program's file.
Pair OfTwo(const YamlNode& root, const std::vector<PlacedCamera>& cameras) {
  if (cameras.size() != 2) {
    std::string names;
    for (const PlacedCamera& placed : cameras) names += (names.empty() ? "" : ", ") + placed.name;
    RefuseSingle(root, std::string(NameOf(FormOf(root))) + " with " +
                           (cameras.size() == 1 ? "one camera" : "the cameras " + names));
  }
  const std::string place = root.place.Text();
  return {cameras[0],
          cameras[1],
          {},
          place,
          place + ": " + cameras[0].name,
          place + ": " + cameras[1].name};
}

Pair OfTwoFiles(const std::string& left, const std::string& right) {
  const YamlNode one = LoadCameraTree(left), other = LoadCameraTree(right);
  const bool camera = FormOf(one) != CalibrationForm::kOurs || one.Find("model");
  const bool other_camera = FormOf(other) != CalibrationForm::kOurs || other.Find("model");
  if (camera != other_camera) {  // stereo_calib's intrinsics.yml and extrinsics.yml
    const YamlNode merged = MergedOpenCvFiles(one, other);
    if (FormOf(merged) == CalibrationForm::kOpenCv) {
      return OfTwo(merged, ReadOpenCvCameras(merged));
    }
  }
  Pair pair{LoadCamera(left), LoadCamera(right), {}, right, left, right};
  PlaceByRectified(pair);
  if (!pair.left.X_PC != !pair.right.X_PC) {
    throw ConfigError(
        (pair.left.X_PC ? right : left) +
        ": expected a projection_matrix and rectification_matrix, as the other file has them");
  }
  if (!pair.left.X_PC && pair.left.X_FC.p == pair.right.X_FC.p) {
    throw ConfigError(right +
                      ": expected the place of the right camera, found nothing about it; write a "
                      "rig with left: {file: ...} and right: {file: ..., position_m: ..., "
                      "rotation: ...} (docs/reference/cameras.md)");
  }
  return pair;
}

/// The two files that `--rig` names; empty: it names one.
std::vector<std::string> TwoFilesOf(const std::string& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) {
    for (const char* end : {".yaml", ".yml"}) {
      const fs::path left = fs::path(file) / (std::string("left") + end);
      const fs::path right = fs::path(file) / (std::string("right") + end);
      if (fs::exists(left, error) && fs::exists(right, error)) {
        return {left.string(), right.string()};
      }
    }
    return {};
  }
  const std::size_t comma = file.find(',');
  if (comma == std::string::npos || fs::exists(file, error)) return {};
  return {file.substr(0, comma), file.substr(comma + 1)};
}

Pair LoadPair(const std::string& file) {
  const std::vector<std::string> files = TwoFilesOf(file);
  if (!files.empty()) return OfTwoFiles(files[0], files[1]);
  std::error_code error;
  if (fs::is_directory(file, error)) {
    throw ConfigError(file + ": expected left.yaml and right.yaml in this folder, found none");
  }
  const YamlNode root = LoadCameraTree(file);
  switch (FormOf(root)) {
    case CalibrationForm::kRos:
      RefuseSingle(root, "a camera_info of ROS with one camera");
    case CalibrationForm::kKalibr:
      return OfTwo(root, ReadKalibrChain(root));
    case CalibrationForm::kOpenCv:
      return OfTwo(root, ReadOpenCvCameras(root));
    case CalibrationForm::kOurs:
      break;
  }
  if (root.Find("model")) RefuseSingle(root, "one camera");
  return OfOurs(root);
}

void RequireMiddleRay(const std::string& place, const Camera& camera) {
  const Eigen::Vector2d middle(0.5 * (camera.width - 1), 0.5 * (camera.height - 1));
  if (camera.HasRay(middle)) return;
  throw ConfigError(place + ": expected a lens that gives the image's middle a ray, found none");
}

/// The first place on the outer edge of the image that no ray reaches.
std::optional<Eigen::Vector2d> RaylessBorder(const Camera& camera) {
  constexpr int kParts = 64;  // of each side
  for (int i = 0; i <= kParts; ++i) {
    const double u = camera.width * (i / double(kParts)) - 0.5;
    const double v = camera.height * (i / double(kParts)) - 0.5;
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(u, -0.5), Eigen::Vector2d(u, camera.height - 0.5),
          Eigen::Vector2d(-0.5, v), Eigen::Vector2d(camera.width - 0.5, v)}) {
      if (!camera.HasRay(pixel)) return pixel;
    }
  }
  return std::nullopt;
}

bool IsWhole(const Camera& camera, int u, int v) {
  for (const double du : {-0.5, 0.5}) {
    for (const double dv : {-0.5, 0.5}) {
      if (!camera.HasRay({u + du, v + dv})) return false;
    }
  }
  return true;
}

/// How many pixels next to the middle one of a row have rays, to its right (1) or left (-1). Rays
/// end outside a curve about the axis, so that those without lie at the end: halved to it.
long WholeFrom(const Camera& camera, int middle, int v, int side) {
  int whole = 0, beyond = (side > 0 ? camera.width - 1 - middle : middle) + 1;
  while (beyond - whole > 1) {
    const int at = (whole + beyond) / 2;
    (IsWhole(camera, middle + side * at, v) ? whole : beyond) = at;
  }
  return whole;
}

}  // namespace

bool NamesTwoFiles(const std::string& file) { return !TwoFilesOf(file).empty(); }

StereoRig LoadRig(const std::string& file, int width, int height, Rays rays) {
  const Pair pair = LoadPair(file);
  StereoRig rig;
  rig.left = Sized(pair.left_place, pair.left.camera, width, height);
  rig.right = Sized(pair.right_place, pair.right.camera, width, height);
  rig.X_RL = pair.X_RF * pair.left.X_FC;
  rig.X_RQ = pair.X_RF * pair.right.X_FC;
  const auto check = rays == Rays::kEverywhere ? RequireRays : RequireMiddleRay;
  check(pair.left_place, rig.left);
  check(pair.right_place, rig.right);
  if (rig.baseline_m() < kLeastBaseline_m) {
    throw ConfigError(pair.place + ": expected cameras at least 0.01 m apart, found '" +
                      NumberText(rig.baseline_m()) + "'");
  }
  return rig;
}

double LoadCalibrationError(const std::string& file) {
  const Pair pair = LoadPair(file);
  return std::max(
      {pair.calibration_error_px, pair.left.calibration_error_px, pair.right.calibration_error_px});
}

Camera Sized(const std::string& place, const Camera& camera, int width, int height) {
  if (width == 0) return camera;
  const double shape = static_cast<double>(width) / height;
  if (std::abs(shape * camera.height / camera.width - 1.0) > 0.01) {
    throw ConfigError(place + ": expected a camera of the shape of images of " +
                      std::to_string(width) + " x " + std::to_string(height) + ", found '" +
                      std::to_string(camera.width) + " x " + std::to_string(camera.height) + "'");
  }
  return Resized(camera, width, height);
}

void RequireRays(const std::string& place, const Camera& camera) {
  const std::optional<Eigen::Vector2d> at = RaylessBorder(camera);
  if (!at) return;
  throw ConfigError(place + ": expected a lens that gives every pixel a ray, found none for '" +
                    NumberText(at->x()) + " " + NumberText(at->y()) + "'");
}

RaylessPixels CountRayless(const Camera& camera) {
  RaylessPixels rayless{.at = RaylessBorder(camera)};
  if (!rayless.at) return rayless;
  const int middle = static_cast<int>(
      std::clamp(camera.centre_px().x(), 0.0, static_cast<double>(camera.width - 1)));
  for (int v = 0; v < camera.height; ++v) {
    rayless.count += camera.width;
    if (!IsWhole(camera, middle, v)) continue;
    rayless.count -= 1 + WholeFrom(camera, middle, v, 1) + WholeFrom(camera, middle, v, -1);
  }
  return rayless;
}

}  // namespace dockyard
