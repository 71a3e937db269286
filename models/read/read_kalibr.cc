// Kalibr's camchain.yaml, and the sensor.yaml of ASL's data sets with the same keys.
#include <algorithm>
#include <charconv>
#include <optional>

#include "controller/base/number_text.h"
#include "models/read/calibrations.h"
#include "models/read/camera_pose.h"
#include "models/read/config_error.h"
#include "models/read/read_lens.h"

namespace dockyard {
namespace {

/// A camera's mapping and the dotted path before its keys.
struct Link {
  const YamlNode* node;
  std::string name, path;  // "cam0", "cam0."

  const YamlNode& Need(const char* key) const {
    const YamlNode* found = node->Find(key);
    if (found) return *found;
    throw ConfigError(node->place.Text() + (name.empty() ? "" : ": " + name) + ": missing key '" +
                      key + "'");
  }
  NumberGrid Numbers(const char* key, std::size_t count) const {
    const NumberGrid grid = ReadGrid(Need(key), path + key);
    grid.RequireCount(count);
    return grid;
  }
  std::optional<Pose3> Transform(const char* key) const {
    const YamlNode* found = node->Find(key);
    if (!found || found->kind == YamlNode::Kind::kNull) return std::nullopt;
    const NumberGrid grid = ReadGrid(*found, path + key);
    grid.RequireShape(4, 4);
    const Eigen::Matrix4d T = grid.matrix<4, 4>();
    for (std::size_t i = 12; i < 16; ++i) {
      const double wanted = i == 15 ? 1.0 : 0.0;
      if (grid.values[i] != wanted) grid.Refuse(i, NumberText(wanted) + " in the last row 0 0 0 1");
    }
    return Pose3{NearestRotation(T.topLeftCorner<3, 3>(), grid.Place()), T.topRightCorner<3, 1>()};
  }
};

enum class Distortion { kNone, kRadtan, kEquidistant, kFov };

Distortion ReadDistortionModel(const Link& link) {
  const YamlNode* node = link.node->Find("distortion_model");
  if (!node || node->kind == YamlNode::Kind::kNull) return Distortion::kNone;
  const std::pair<const char*, Distortion> words[] = {{"none", Distortion::kNone},
                                                      {"radtan", Distortion::kRadtan},
                                                      {"radial-tangential", Distortion::kRadtan},
                                                      {"plumb_bob", Distortion::kRadtan},
                                                      {"equidistant", Distortion::kEquidistant},
                                                      {"equi", Distortion::kEquidistant},
                                                      {"fov", Distortion::kFov}};
  for (const auto& [word, model] : words) {
    if (node->scalar == word) return model;
  }
  RefuseNode(*node, link.path + "distortion_model", "one of radtan, equidistant, fov, none");
}

std::optional<NumberGrid> ReadCoefficients(const Link& link) {
  std::string key;
  const YamlNode* node = FindFirst(
      *link.node, {"distortion_coeffs", "distortion_coefficients", "distortion_parameters"}, &key);
  if (!node || node->kind == YamlNode::Kind::kNull) return std::nullopt;
  return ReadGrid(*node, link.path + key);
}

FocalNumbers FocalAt(const NumberGrid& in, std::size_t first) {
  for (std::size_t i = first; i < first + 2; ++i) {
    if (!(in.values[i] > 0.0 && in.values[i] <= 1e6)) in.Refuse(i, "a focal length > 0 px");
  }
  return {in.values[first], in.values[first + 1], in.values[first + 2], in.values[first + 3]};
}

double Checked(const NumberGrid& in, std::size_t index, const Range& range) {
  const double value = in.values[index];
  const bool low = range.open_low ? value > range.low : value >= range.low;
  if (!low || !(value <= range.high)) in.Refuse(index, Describe(range, low));
  return value;
}

[[noreturn]] void RefusePair(const Link& link, const char* model, const char* expected) {
  RefuseNode(*link.node->Find("distortion_model"), link.path + "distortion_model",
             std::string(expected) + " with camera_model " + model);
}

Lens KalibrPinhole(const Link& link, Distortion model, const std::optional<NumberGrid>& d) {
  const FocalNumbers focal = FocalAt(link.Numbers("intrinsics", 4), 0);
  const NumberGrid* numbers = d ? &*d : nullptr;
  switch (model) {
    case Distortion::kEquidistant:
      return FisheyeOf(focal, numbers);
    case Distortion::kFov: {
      if (!d) throw ConfigError(link.node->place.Text() + ": missing key 'distortion_coeffs'");
      d->RequireCount(1);
      return WithFocal(FovPinhole{.w_rad = Checked(*d, 0, kWidthOfFov_rad)}, focal);
    }
    case Distortion::kNone:
      return PinholeOf(focal, nullptr);
    case Distortion::kRadtan:
      break;
  }
  return PinholeOf(focal, numbers);
}

Lens KalibrOmni(const Link& link, Distortion model, const std::optional<NumberGrid>& d) {
  const NumberGrid in = link.Numbers("intrinsics", 5);
  const double xi = Checked(in, 0, NonNegative(100.0));
  if (model != Distortion::kNone && model != Distortion::kRadtan) {
    RefusePair(link, "omni", "radtan or none");
  }
  return OmniOf(FocalAt(in, 1), xi, model == Distortion::kRadtan && d ? &*d : nullptr);
}

Lens KalibrLens(const Link& link) {
  const YamlNode& model = link.Need("camera_model");
  const Distortion distortion = ReadDistortionModel(link);
  const std::optional<NumberGrid> d = ReadCoefficients(link);
  const bool bent = d && std::any_of(d->values.begin(), d->values.end(),
                                     [](double value) { return value != 0.0; });
  if (bent && distortion == Distortion::kNone) {
    throw ConfigError(d->Place() + ": expected zeros without a distortion_model, found others");
  }
  if (model.scalar == "pinhole") return KalibrPinhole(link, distortion, d);
  if (model.scalar == "omni") return KalibrOmni(link, distortion, d);
  if (model.scalar != "ds" && model.scalar != "eucm") {
    RefuseNode(model, link.path + "camera_model", "one of pinhole, omni, ds, eucm");
  }
  if (bent) RefusePair(link, model.scalar.c_str(), "none");
  const NumberGrid in = link.Numbers("intrinsics", 6);
  const FocalNumbers focal = FocalAt(in, 2);
  if (model.scalar == "ds") {
    return WithFocal(
        DoubleSphere{.xi = Checked(in, 0, kXiOfSpheres), .alpha = Checked(in, 1, NonNegative(1.0))},
        focal);
  }
  return WithFocal(
      Eucm{.alpha = Checked(in, 0, NonNegative(1.0)), .beta = Checked(in, 1, Positive(100.0))},
      focal);
}

Camera KalibrCamera(const Link& link) {
  const YamlNode& size = link.Need("resolution");
  const std::string path = link.path + "resolution";
  if (size.kind != YamlNode::Kind::kSequence || size.items.size() != 2) {
    RefuseNode(size, path, "a list of 2, width and height");
  }
  return {.width = PixelCount(size.items[0], path),
          .height = PixelCount(size.items[1], path),
          .lens = KalibrLens(link)};
}

/// The cameras camN by their numbers.
std::vector<Link> LinksOf(const YamlNode& root) {
  std::vector<std::pair<int, Link>> numbered;
  for (std::size_t i = 0; i < root.keys.size(); ++i) {
    const std::string& name = root.keys[i].name;
    int number = 0;
    const char* end = name.data() + name.size();
    if (name.rfind("cam", 0) != 0) continue;
    const auto [stop, error] = std::from_chars(name.data() + 3, end, number);
    if (error != std::errc() || stop != end) continue;
    numbered.push_back({number, Link{&root.items[i], name, name + "."}});
  }
  std::sort(numbered.begin(), numbered.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Link> links;
  for (auto& [number, link] : numbered) links.push_back(link);
  return links;
}

/// The camera in the one before it.
Pose3 StepTo(const Link& link, const Link& before) {
  if (const auto X_cn_cnm1 = link.Transform("T_cn_cnm1")) return Inverse(*X_cn_cnm1);
  const auto X_ci = link.Transform("T_cam_imu"), X_bi = before.Transform("T_cam_imu");
  if (X_ci && X_bi) return *X_bi * Inverse(*X_ci);
  throw ConfigError(link.node->place.Text() + ": " + link.name +
                    ": missing key 'T_cn_cnm1', the transform from " + before.name + " to " +
                    link.name);
}

}  // namespace

std::vector<PlacedCamera> ReadKalibrChain(const YamlNode& root) {
  const std::vector<Link> links = LinksOf(root);
  if (links.empty()) {  // one camera by itself
    const Link link{&root, "", ""};
    return {{.name = "", .camera = KalibrCamera(link), .X_FC = {}, .X_PC = {}}};
  }
  std::vector<PlacedCamera> cameras;
  for (std::size_t i = 0; i < links.size(); ++i) {
    PlacedCamera placed{
        .name = links[i].name, .camera = KalibrCamera(links[i]), .X_FC = {}, .X_PC = {}};
    if (i > 0) placed.X_FC = cameras.back().X_FC * StepTo(links[i], links[i - 1]);
    cameras.push_back(placed);
  }
  return cameras;
}

}  // namespace dockyard
