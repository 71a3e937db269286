// ROS's sensor_msgs/CameraInfo: the file that camera_calibration writes, or an echoed message.
#include <optional>

#include "models/read/calibrations.h"
#include "models/read/camera_pose.h"
#include "models/read/config_error.h"

namespace dockyard {
namespace {

std::optional<NumberGrid> RosGrid(const YamlNode& root, const std::vector<std::string>& keys) {
  std::string key;
  const YamlNode* node = FindFirst(root, keys, &key);
  return node ? std::optional(ReadGrid(*node, key)) : std::nullopt;
}

int RosSize(const YamlNode& root, const std::vector<std::string>& keys) {
  std::string key;
  const YamlNode* node = FindFirst(root, keys, &key);
  if (!node) throw ConfigError(root.place.Text() + ": missing key '" + keys.front() + "'");
  return PixelCount(*node, key);
}

Lens RosLens(const YamlNode& root, const FocalNumbers& focal) {
  const std::optional<NumberGrid> d = RosGrid(root, {"distortion_coefficients", "D", "d"});
  const NumberGrid* numbers = d ? &*d : nullptr;
  const YamlNode* model = root.Find("distortion_model");
  if (!model || model->kind == YamlNode::Kind::kNull) return PinholeOf(focal, numbers);
  const std::string& name = model->scalar;
  for (const char* pinhole : {"plumb_bob", "rational_polynomial", "pinhole", "none", ""}) {
    if (model->kind == YamlNode::Kind::kScalar && name == pinhole) {
      return PinholeOf(focal, numbers);
    }
  }
  for (const char* fisheye : {"equidistant", "fisheye", "kannala_brandt", "kannala_brandt4"}) {
    if (name == fisheye) return FisheyeOf(focal, numbers);
  }
  RefuseNode(*model, "distortion_model",
             "one of plumb_bob, rational_polynomial, equidistant, fisheye");
}

int CountOr(const YamlNode& node, const std::string& path, const char* key, int fallback) {
  const YamlNode* found = node.Find(key);
  if (!found || found->kind != YamlNode::Kind::kScalar || found->scalar == "0") return fallback;
  return PixelCount(*found, path + key);
}

/// The images that come: the part `roi` of the sensor, binned. K holds for the whole sensor.
Camera AsDelivered(const YamlNode& root, Camera camera) {
  if (const YamlNode* roi = root.Find("roi"); roi && roi->kind == YamlNode::Kind::kMapping) {
    const int left = CountOr(*roi, "roi.", "x_offset", 0),
              top = CountOr(*roi, "roi.", "y_offset", 0);
    const int width = CountOr(*roi, "roi.", "width", camera.width - left);
    const int height = CountOr(*roi, "roi.", "height", camera.height - top);
    if (width < 1 || height < 1 || left + width > camera.width || top + height > camera.height) {
      RefuseNode(*roi, "roi",
                 "a part of the image of " + std::to_string(camera.width) + " x " +
                     std::to_string(camera.height));
    }
    camera = Adjusted(camera, 1.0, {-left, -top});
    camera.width = width;
    camera.height = height;
  }
  const int across = CountOr(root, "", "binning_x", 1), down = CountOr(root, "", "binning_y", 1);
  if (across == 1 && down == 1) return camera;
  if (camera.width < across || camera.height < down) {
    RefuseNode(*root.Find(camera.width < across ? "binning_x" : "binning_y"), "binning",
               "a number up to the image's size");
  }
  return Resized(camera, camera.width / across, camera.height / down);
}

/// The camera in the frame of its pair's rectified images: P shifts the points by P(0..1, 3) / f.
std::optional<Pose3> ReadRectified(const YamlNode& root) {
  const std::optional<NumberGrid> P = RosGrid(root, {"projection_matrix", "P", "p"});
  if (!P) return std::nullopt;
  P->RequireShape(3, 4);
  const double fx = P->values[0], fy = P->values[5];
  if (!(fx > 0.0 && fy > 0.0)) return std::nullopt;  // a camera that was never rectified
  Pose3 X_PC;
  X_PC.p = {-P->values[3] / fx, -P->values[7] / fy, 0.0};
  if (const std::optional<NumberGrid> R = RosGrid(root, {"rectification_matrix", "R", "r"})) {
    R->RequireShape(3, 3);
    if (R->matrix<3, 3>().isZero(0.0)) return std::nullopt;  // drivers leave it so
    X_PC.R = NearestRotation(R->matrix<3, 3>(), R->Place());
  }
  return X_PC;
}

}  // namespace

PlacedCamera ReadRosCamera(const YamlNode& root) {
  PlacedCamera placed;
  const YamlNode* name = root.Find("camera_name");
  if (name && name->kind == YamlNode::Kind::kScalar) placed.name = name->scalar;
  placed.camera.width = RosSize(root, {"image_width", "width"});
  placed.camera.height = RosSize(root, {"image_height", "height"});
  const std::optional<NumberGrid> K = RosGrid(root, {"camera_matrix", "K", "k"});
  if (!K) throw ConfigError(root.place.Text() + ": missing key 'camera_matrix'");
  placed.camera.lens = RosLens(root, ReadFocalMatrix(*K));
  placed.camera = AsDelivered(root, placed.camera);
  placed.X_PC = ReadRectified(root);
  return placed;
}

}  // namespace dockyard
