#include "models/read/load_cameras.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "models/read/calibrations.h"
#include "models/read/camera_pose.h"
#include "models/read/config_error.h"
#include "models/read/read_lens.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

const Range kVector = Between(-1e6, 1e6);

/// The place of the file's (0, 0), in pixels from the first pixel's centre.
double FirstPixel(const YamlReader& in) {
  const std::vector<std::string> words{"centre", "corner", "one"};
  const double of_words[] = {0.0, -0.5, -1.0};
  return of_words[in.Choice("pixel_zero", words)];
}

Eigen::Vector3d Unit(const YamlReader& in, const char* key) {
  Eigen::Vector3d v = in.Vector3(key, Between(-2.0, 2.0));
  if (std::abs(v.norm() - 1.0) > 1e-3) in.Refuse(key, "a vector of length 1 within 0.001");
  return v;
}

/// Not given, or given as null.
bool Absent(const YamlReader& in, const char* key) {
  return !in.Has(key) || in.Child(key).kind == YamlNode::Kind::kNull;
}

enum class CahvKind { kCahv, kCahvor, kCahvore };
const std::vector<std::string> kCahvWords{"cahv", "cahvor", "cahvore"};

/// The vectors that the kind needs; it leaves the others alone.
Cahvore ReadCahv(const YamlReader& in, CahvKind kind) {
  Cahvore lens;
  lens.C = in.Vector3("C", kVector);
  lens.A = Unit(in, "A");
  lens.H = in.Vector3("H", kVector);
  lens.V = in.Vector3("V", kVector);
  if (std::abs(lens.A.dot(lens.V.cross(lens.H))) < 1.0) {
    in.Refuse("V", "a vector that spans the image together with A and H");
  }
  lens.O = lens.A.normalized();
  if (kind == CahvKind::kCahv) return lens;
  lens.O = Unit(in, "O").normalized();
  lens.R = in.Vector3("R", kVector);
  if (kind == CahvKind::kCahvore) lens.E = in.Vector3("E", Between(-10.0, 10.0));
  return lens;
}

PlacedCamera Placed(const Cahvore& lens_F, int width, int height) {
  PlacedCamera placed;
  placed.X_FC = CameraFrameOf(lens_F);
  placed.camera = {.width = width, .height = height, .lens = InFrame(lens_F, placed.X_FC)};
  return placed;
}

/// The keys that a camera of this model may have.
std::vector<std::string> KeysOf(const std::string& model) {
  std::vector<std::string> keys{"name",     "source",    "model",        "pixel_zero",
                                "width_px", "height_px", "scaled_to_px", "calibration_error_px"};
  const auto know = [&](const std::vector<std::string>& more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  if (IsFocalModel(model)) {
    know(FocalModelKeys(model));
    know(PoseKeys());
  } else {
    know({"C", "A", "H", "V"});
    if (model != "cahv") know({"O", "R"});
    if (model != "cahv" && model != "cahvor") know({"E", "linearity"});
  }
  return keys;
}

/// Where the file places a camera; none: it does not say.
std::optional<Pose3> ReadCameraPlace(const YamlReader& in) {
  if (in.Has("position_m")) return ReadCameraPose(in);
  for (const std::string& key : PoseKeys()) {
    if (in.Has(key)) in.Refuse(key, "a position_m next to it");
  }
  return std::nullopt;
}

/// The camera at the size that `scaled_to_px` says.
Camera ScaledAsSaid(const YamlReader& in, const Camera& camera) {
  if (!in.Has("scaled_to_px")) return camera;
  const YamlNode& size = in.List("scaled_to_px", 2, 2);
  double to[2] = {};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool number = ParseNumber(size.items[i].scalar, to[i]);
    if (!number || to[i] < 1 || to[i] > kMostImagePixels || to[i] != std::floor(to[i])) {
      in.Refuse("scaled_to_px", "a list of 2 whole numbers");
    }
  }
  return Resized(camera, static_cast<int>(to[0]), static_cast<int>(to[1]));
}

PlacedCamera ReadOurs(const YamlNode& node, const std::string& path) {
  std::vector<std::string> models = FocalModelNames();
  models.insert(models.end(), kCahvWords.begin(), kCahvWords.end());
  // Which other keys are known depends on the model: read that first.
  std::vector<std::string> written{"model"};
  for (const YamlNode::Key& key : node.keys) written.push_back(key.name);
  const std::string model = models[YamlReader(node, path, written).Choice("model", models)];
  const YamlReader in(node, path, KeysOf(model));
  const int width = in.Integer("width_px", 1, kMostImagePixels);
  const int height = in.Integer("height_px", 1, kMostImagePixels);
  PlacedCamera placed;
  if (IsFocalModel(model)) {
    placed.camera = {.width = width, .height = height, .lens = ReadFocalLens(in, model)};
    placed.X_FC = ReadCameraPlace(in).value_or(Pose3{});
  } else {
    const auto kind = std::find(kCahvWords.begin(), kCahvWords.end(), model) - kCahvWords.begin();
    Cahvore lens = ReadCahv(in, static_cast<CahvKind>(kind));
    if (model == "cahvore") lens.linearity = in.Number("linearity", Between(-1.0, 1.0));
    placed = Placed(lens, width, height);
  }
  placed.name = in.TextOr("name", "");
  in.TextOr("source", "-");
  placed.calibration_error_px = ReadCalibrationError(in);
  const double first = FirstPixel(in);
  placed.camera = ScaledAsSaid(in, Adjusted(placed.camera, 1.0, {first, first}));
  return placed;
}

/// An element of NASA's m2020-camera-models.json. It does not state the pixels' zero: the centre of
/// the first pixel, as Vision Workbench and mrcal take it.
PlacedCamera ReadNasa(const YamlNode& node, const std::string& path) {
  const YamlReader in(node, path, {"type", "name", "frame", "model"});
  const YamlReader model(
      in.Child("model"), in.PathOf("model"),
      {"type", "C", "A", "H", "V", "O", "R", "E", "pupilType", "linearity", "width", "height"});
  const YamlReader& typed = model.Has("type") ? model : in;
  // JPL's own camera files write the names in capitals.
  const std::vector<std::string> words{"cahv", "cahvor", "cahvore", "CAHV", "CAHVOR", "CAHVORE"};
  const auto kind = static_cast<CahvKind>(typed.Choice("type", words) % 3);
  Cahvore lens = ReadCahv(model, kind);
  if (kind == CahvKind::kCahvore) {
    const int pupil = Absent(model, "pupilType") ? 3 : model.Integer("pupilType", 1, 3);
    // Type 1 is the perspective pupil, type 2 the fish-eye's, type 3 between them.
    lens.linearity = pupil == 1   ? 1.0
                     : pupil == 2 ? 0.0
                                  : model.Number("linearity", Between(-1.0, 1.0));
  }
  PlacedCamera placed = Placed(lens, model.Integer("width", 1, kMostImagePixels),
                               model.Integer("height", 1, kMostImagePixels));
  placed.name = in.TextOr("name", "");
  return placed;
}

/// A camera of its own, by our keys or NASA's.
PlacedCamera ReadOne(const YamlNode& node, const std::string& path) {
  const YamlNode* model = node.Find("model");
  const bool nasa = model && model->kind == YamlNode::Kind::kMapping;
  return nasa ? ReadNasa(node, path) : ReadOurs(node, path);
}

std::string Names(const std::vector<PlacedCamera>& cameras) {
  std::string text;
  for (const PlacedCamera& placed : cameras) text += (text.empty() ? "" : ", ") + placed.name;
  return text;
}

}  // namespace

double ReadCalibrationError(const YamlReader& in) {
  return in.NumberOr("calibration_error_px", 0.0, NonNegative(10.0));
}

PlacedCamera ReadSide(const YamlReader& rig, const std::string& side) {
  const YamlNode& node = rig.Child(side);
  if (node.kind != YamlNode::Kind::kMapping || !node.Find("file")) return ReadOne(node, side);
  std::vector<std::string> keys{"file", "name"};
  keys.insert(keys.end(), PoseKeys().begin(), PoseKeys().end());
  const YamlReader in(node, side, keys);
  const std::string file = in.File("file");
  const YamlNode root = LoadCameraTree(file);
  if (root.Find("left") || root.Find("right")) {
    in.Refuse("file", "a file of cameras that is no rig itself");
  }
  PlacedCamera placed = LoadCamera(file, in.TextOr("name", ""));
  if (const std::optional<Pose3> X_FC = ReadCameraPlace(in)) {
    placed.X_FC = *X_FC;
    placed.X_PC = std::nullopt;
  }
  return placed;
}

YamlReader RigReader(const YamlNode& root) {
  return {root, "", {"name", "source", "in_rover", "left", "right", "calibration_error_px"}};
}

std::vector<PlacedCamera> LoadCameras(const std::string& file) {
  const YamlNode root = LoadCameraTree(file);
  switch (FormOf(root)) {
    case CalibrationForm::kRos:
      return {ReadRosCamera(root)};
    case CalibrationForm::kKalibr:
      return ReadKalibrChain(root);
    case CalibrationForm::kOpenCv:
      return ReadOpenCvCameras(root);
    case CalibrationForm::kOurs:
      break;
  }
  std::vector<PlacedCamera> cameras;
  if (root.kind == YamlNode::Kind::kSequence) {
    for (std::size_t i = 0; i < root.items.size(); ++i) {
      cameras.push_back(ReadOne(root.items[i], YamlReader::PathOf("", i)));
    }
    if (cameras.empty()) throw ConfigError(root.place.Text() + ": expected cameras, found none");
  } else if (root.Find("left") || root.Find("right")) {
    const YamlReader in = RigReader(root);
    for (const char* side : {"left", "right"}) {
      cameras.push_back(ReadSide(in, side));
      cameras.back().name = side;
    }
  } else {
    if (root.kind == YamlNode::Kind::kMapping && !root.Find("model")) {
      throw ConfigError(root.place.Text() +
                        ": missing key 'model' of a camera, or the keys of a calibration of ROS, "
                        "Kalibr or OpenCV (docs/reference/cameras.md)");
    }
    cameras.push_back(ReadOne(root, ""));
  }
  return cameras;
}

PlacedCamera LoadCamera(const std::string& file, const std::string& name) {
  const std::vector<PlacedCamera> cameras = LoadCameras(file);
  if (name.empty()) {
    if (cameras.size() == 1) return cameras[0];
    throw ConfigError(file + ": expected the name of one of its cameras: " + Names(cameras));
  }
  for (const PlacedCamera& placed : cameras) {
    if (placed.name == name) return placed;
  }
  throw ConfigError(file + ": expected a camera '" + name + "', found " + Names(cameras));
}

}  // namespace dockyard
