#include "models/read/load_cameras.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr int kMostPixels = 16384;
const Range kVector = Between(-1e6, 1e6);

/// The place of the file's (0, 0), in pixels from the first pixel's centre.
double FirstPixel(const YamlReader& in) {
  const std::vector<std::string> words{"centre", "corner", "one"};
  const double of_words[] = {0.0, -0.5, -1.0};
  return of_words[in.Choice("pixel_zero", words)];
}

/// x forward, y left, z up -> z along the view, x right, y down, turned by the file's angles.
Pose3 ReadPose(const YamlReader& in) {
  Eigen::Matrix3d R_level;
  R_level.col(0) = -Eigen::Vector3d::UnitY();
  R_level.col(1) = -Eigen::Vector3d::UnitZ();
  R_level.col(2) = Eigen::Vector3d::UnitX();
  const double yaw = in.DegreesOr("yaw_deg", 0.0, Between(-180, 180));
  const double pitch = in.DegreesOr("pitch_deg", 0.0, Between(-90, 90));
  const double roll = in.DegreesOr("roll_deg", 0.0, Between(-180, 180));
  return {RotZ(yaw) * RotY(pitch) * RotX(roll) * R_level,
          in.Vector3("position_m", Between(-100, 100))};
}

template <typename L>
void ReadFocal(const YamlReader& in, L& lens) {
  lens.fx = in.Number("fx_px", Positive(1e6));
  lens.fy = in.Number("fy_px", Positive(1e6));
  lens.cx = in.Number("cx_px", Between(-1e6, 1e6));
  lens.cy = in.Number("cy_px", Between(-1e6, 1e6));
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

/// Models with a focal length, placed by position and angles.
bool HasFocalLength(const std::string& model) {
  return model == "kannala_brandt" || model == "brown" || model == "pinhole";
}

/// The keys that a camera of this model may have.
std::vector<std::string> KeysOf(const std::string& model) {
  std::vector<std::string> keys{"name",     "source",    "model",        "pixel_zero",
                                "width_px", "height_px", "scaled_to_px", "calibration_error_px"};
  const auto know = [&](const std::vector<std::string>& more) {
    keys.insert(keys.end(), more.begin(), more.end());
  };
  if (HasFocalLength(model)) {
    know({"fx_px", "fy_px", "cx_px", "cy_px", "position_m", "yaw_deg", "pitch_deg", "roll_deg"});
    if (model == "brown") know({"k1", "k2", "k3", "p1", "p2"});
    if (model == "kannala_brandt") know({"k"});
  } else {
    know({"C", "A", "H", "V"});
    if (model != "cahv") know({"O", "R"});
    if (model != "cahv" && model != "cahvor") know({"E", "linearity"});
  }
  return keys;
}

BrownPinhole ReadBrown(const YamlReader& in) {
  BrownPinhole lens;
  ReadFocal(in, lens);
  lens.k1 = in.Number("k1", kVector);
  lens.k2 = in.Number("k2", kVector);
  lens.k3 = in.NumberOr("k3", 0.0, kVector);
  lens.p1 = in.NumberOr("p1", 0.0, kVector);
  lens.p2 = in.NumberOr("p2", 0.0, kVector);
  return lens;
}

KannalaBrandt ReadKannalaBrandt(const YamlReader& in) {
  KannalaBrandt lens;
  ReadFocal(in, lens);
  const YamlNode& list = in.List("k", 4, 4);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!ParseNumber(list.items[i].scalar, lens.k[i])) in.Refuse("k", "a list of 4 numbers");
  }
  return lens;
}

/// A lens about a principal point, placed by position and angles.
PlacedCamera ReadFocalCamera(const YamlReader& in, const std::string& model, int width,
                             int height) {
  PlacedCamera placed;
  placed.camera = {.width = width, .height = height, .lens = {}};
  if (model == "pinhole") {
    BrownPinhole lens;  // without distortion
    ReadFocal(in, lens);
    placed.camera.lens = lens;
  } else if (model == "brown") {
    placed.camera.lens = ReadBrown(in);
  } else {
    placed.camera.lens = ReadKannalaBrandt(in);
  }
  if (in.Has("position_m")) placed.X_FC = ReadPose(in);
  for (const char* key : {"yaw_deg", "pitch_deg", "roll_deg"}) {
    if (in.Has(key) && !in.Has("position_m")) in.Refuse(key, "a position_m beside it");
  }
  return placed;
}

double ReadCalibrationError(const YamlReader& in) {
  return in.NumberOr("calibration_error_px", 0.0, NonNegative(10.0));
}

/// The camera at the size that `scaled_to_px` says.
Camera ScaledAsSaid(const YamlReader& in, const Camera& camera) {
  if (!in.Has("scaled_to_px")) return camera;
  const YamlNode& size = in.List("scaled_to_px", 2, 2);
  double to[2] = {};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool number = ParseNumber(size.items[i].scalar, to[i]);
    if (!number || to[i] < 1 || to[i] > kMostPixels || to[i] != std::floor(to[i])) {
      in.Refuse("scaled_to_px", "a list of 2 whole numbers");
    }
  }
  return Resized(camera, static_cast<int>(to[0]), static_cast<int>(to[1]));
}

PlacedCamera ReadOurs(const YamlNode& node, const std::string& path) {
  const std::vector<std::string> models{"kannala_brandt", "brown",  "pinhole",
                                        "cahv",           "cahvor", "cahvore"};
  // Which other keys are known depends on the model: read that first.
  std::vector<std::string> written{"model"};
  for (const YamlNode::Key& key : node.keys) written.push_back(key.name);
  const std::string model = models[YamlReader(node, path, written).Choice("model", models)];
  const YamlReader in(node, path, KeysOf(model));
  const int width = in.Integer("width_px", 1, kMostPixels);
  const int height = in.Integer("height_px", 1, kMostPixels);
  PlacedCamera placed;
  if (HasFocalLength(model)) {
    placed = ReadFocalCamera(in, model, width, height);
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
  PlacedCamera placed =
      Placed(lens, model.Integer("width", 1, kMostPixels), model.Integer("height", 1, kMostPixels));
  placed.name = in.TextOr("name", "");
  return placed;
}

bool IsRig(const YamlNode& root) { return root.Find("left") || root.Find("right"); }

PlacedCamera ReadOne(const YamlNode& node, const std::string& path) {
  const YamlNode* model = node.Find("model");
  const bool nasa = model && model->kind == YamlNode::Kind::kMapping;
  return nasa ? ReadNasa(node, path) : ReadOurs(node, path);
}

YamlReader RigReader(const YamlNode& root) {
  return {root, "", {"name", "source", "in_rover", "left", "right", "calibration_error_px"}};
}

/// JSON is YAML but for the tabs that indent it.
YamlNode LoadTree(const std::string& file) {
  std::string text = ReadText(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && (text[first] == '{' || text[first] == '[')) {
    std::replace(text.begin(), text.end(), '\t', ' ');
  }
  return ParseYaml(text, file);
}

std::string Names(const std::vector<PlacedCamera>& cameras) {
  std::string text;
  for (const PlacedCamera& placed : cameras) text += (text.empty() ? "" : ", ") + placed.name;
  return text;
}

}  // namespace

std::vector<PlacedCamera> LoadCameras(const std::string& file) {
  const YamlNode root = LoadTree(file);
  std::vector<PlacedCamera> cameras;
  if (root.kind == YamlNode::Kind::kSequence) {
    for (std::size_t i = 0; i < root.items.size(); ++i) {
      cameras.push_back(ReadOne(root.items[i], YamlReader::PathOf("", i)));
    }
    if (cameras.empty()) throw ConfigError(root.place.Text() + ": expected cameras, found none");
  } else if (IsRig(root)) {
    const YamlReader in = RigReader(root);
    for (const char* side : {"left", "right"}) {
      cameras.push_back(ReadOne(in.Child(side), side));
      cameras.back().name = side;
    }
  } else {
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

StereoRig LoadRig(const std::string& file, int width, int height) {
  const YamlNode root = LoadTree(file);
  const YamlReader in = RigReader(root);
  in.TextOr("name", "-");
  in.TextOr("source", "-");
  Pose3 X_RF;
  if (in.Has("in_rover")) {
    const YamlReader place(in.Child("in_rover"), "in_rover",
                           {"position_m", "yaw_deg", "pitch_deg", "roll_deg"});
    X_RF.R = RotZ(place.DegreesOr("yaw_deg", 0.0, Between(-180, 180))) *
             RotY(place.DegreesOr("pitch_deg", 0.0, Between(-90, 90))) *
             RotX(place.DegreesOr("roll_deg", 0.0, Between(-180, 180)));
    X_RF.p = place.Vector3("position_m", Between(-100, 100));
  }
  const auto read = [&](const char* side, Camera& camera, Pose3& X_RC) {
    const PlacedCamera placed = ReadOne(in.Child(side), side);
    camera = placed.camera;
    X_RC = X_RF * placed.X_FC;
    const std::string place = in.Child(side).place.Text() + ": " + side;
    if (width > 0) {
      const double shape = static_cast<double>(width) / height;
      if (std::abs(shape * camera.height / camera.width - 1.0) > 0.01) {
        throw ConfigError(place + ": expected a camera of the shape of images of " +
                          std::to_string(width) + " x " + std::to_string(height) + ", found '" +
                          std::to_string(camera.width) + " x " + std::to_string(camera.height) +
                          "'");
      }
      camera = Resized(camera, width, height);
    }
    RequireRays(place, camera);
  };
  StereoRig rig;
  read("left", rig.left, rig.X_RL);
  read("right", rig.right, rig.X_RQ);
  if (rig.baseline_m() < 0.01) {
    throw ConfigError(root.place.Text() + ": expected cameras at least 0.01 m apart, found '" +
                      NumberText(rig.baseline_m()) + "'");
  }
  return rig;
}

double LoadCalibrationError(const std::string& file) {
  const YamlNode root = LoadTree(file);
  double error_px = 0.0;
  if (IsRig(root)) error_px = ReadCalibrationError(RigReader(root));
  for (const PlacedCamera& placed : LoadCameras(file)) {
    error_px = std::max(error_px, placed.calibration_error_px);
  }
  return error_px;
}

void RequireRays(const std::string& place, const Camera& camera) {
  constexpr int kParts = 64;  // of each side
  for (int i = 0; i <= kParts; ++i) {
    const double u = camera.width * (i / double(kParts)) - 0.5;
    const double v = camera.height * (i / double(kParts)) - 0.5;
    for (const Eigen::Vector2d& pixel :
         {Eigen::Vector2d(u, -0.5), Eigen::Vector2d(u, camera.height - 0.5),
          Eigen::Vector2d(-0.5, v), Eigen::Vector2d(camera.width - 0.5, v)}) {
      if (camera.HasRay(pixel)) continue;
      throw ConfigError(place + ": expected a lens that gives every pixel a ray, found none for '" +
                        NumberText(pixel.x()) + " " + NumberText(pixel.y()) + "'");
    }
  }
}

}  // namespace dockyard
