#include "models/read/calibrations.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/opencv_storage.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

constexpr double kMost_px = 1e6;

bool IsKalibrCamera(const YamlNode& node) {
  return node.kind == YamlNode::Kind::kMapping &&
         (node.Find("camera_model") || node.Find("intrinsics"));
}

/// `rostopic echo` ends each message with a line of three dashes, which begins an empty document.
void BlankLastSeparator(std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos || end < 3 || text.compare(end - 2, 3, "---") != 0) return;
  if (text[end - 3] != '\n') return;
  for (std::size_t i = end - 2; i <= end; ++i) text[i] = ' ';
}

}  // namespace

CalibrationForm FormOf(const YamlNode& root) {
  if (root.kind != YamlNode::Kind::kMapping) return CalibrationForm::kOurs;
  if (root.Find("model") || root.Find("left") || root.Find("right")) return CalibrationForm::kOurs;
  if (root.Find("camera_model") && root.Find("intrinsics")) return CalibrationForm::kKalibr;
  for (std::size_t i = 0; i < root.keys.size(); ++i) {
    const bool named = root.keys[i].name.rfind("cam", 0) == 0;
    if (named && IsKalibrCamera(root.items[i])) return CalibrationForm::kKalibr;
  }
  const auto any = [&](std::vector<std::string> keys) { return FindFirst(root, keys) != nullptr; };
  const bool matrix = any({"camera_matrix", "K", "k"});
  const bool of_ros = any({"distortion_model", "projection_matrix", "rectification_matrix",
                           "camera_name", "binning_x"});
  if (matrix && of_ros) return CalibrationForm::kRos;
  if (HasOpenCvCamera(root)) return CalibrationForm::kOpenCv;
  return CalibrationForm::kOurs;
}

const char* NameOf(CalibrationForm form) {
  switch (form) {
    case CalibrationForm::kRos:
      return "a camera_info of ROS";
    case CalibrationForm::kKalibr:
      return "a chain of Kalibr";
    case CalibrationForm::kOpenCv:
      return "a file of OpenCV";
    case CalibrationForm::kOurs:
      break;
  }
  return "a camera file";
}

YamlNode LoadCameraTree(const std::string& file) {
  std::string text = ReadText(file);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && text[first] == '<') return ParseOpenCvXml(text, file);
  // JSON is YAML but for the tabs that indent it.
  if (first != std::string::npos && (text[first] == '{' || text[first] == '[')) {
    std::replace(text.begin(), text.end(), '\t', ' ');
  }
  BlankOpenCvMarks(text);
  BlankLastSeparator(text);
  return ParseYaml(text, file);
}

void RefuseNode(const YamlNode& node, const std::string& path, const std::string& expected) {
  throw ConfigError(node.place.Text() + ": " + path + ": expected " + expected + ", found " +
                    node.Found());
}

const YamlNode* FindFirst(const YamlNode& root, const std::vector<std::string>& keys,
                          std::string* found) {
  for (const std::string& key : keys) {
    const YamlNode* node = root.Find(key);
    if (!node) continue;
    if (found) *found = key;
    return node;
  }
  return nullptr;
}

int PixelCount(const YamlNode& node, const std::string& path) {
  double value = 0.0;
  const bool whole = node.kind == YamlNode::Kind::kScalar && ParseNumber(node.scalar, value) &&
                     value >= 1.0 && value <= kMostImagePixels && value == std::floor(value);
  if (!whole) {
    RefuseNode(node, path, "a whole number from 1 to " + std::to_string(kMostImagePixels));
  }
  return static_cast<int>(value);
}

FocalNumbers ReadFocalMatrix(const NumberGrid& K) {
  K.RequireShape(3, 3);
  for (const std::size_t i : {std::size_t{0}, std::size_t{4}}) {
    if (!(K.values[i] > 0.0 && K.values[i] <= kMost_px)) {
      K.Refuse(i, "a focal length > 0 px (a camera without a calibration has 0)");
    }
  }
  for (const std::size_t i : {std::size_t{3}, std::size_t{6}, std::size_t{7}}) {
    if (K.values[i] != 0.0) K.Refuse(i, "0 in [fx 0 cx; 0 fy cy; 0 0 1]");
  }
  if (K.values[1] != 0.0) K.Refuse(1, "0: no lens here has skewed pixels");
  if (K.values[8] != 1.0) K.Refuse(8, "1 in [fx 0 cx; 0 fy cy; 0 0 1]");
  for (const std::size_t i : {std::size_t{2}, std::size_t{5}}) {
    if (!(std::abs(K.values[i]) <= kMost_px)) K.Refuse(i, "a principal point within 1e6 px");
  }
  return {K.values[0], K.values[4], K.values[2], K.values[5]};
}

Lens PinholeOf(const FocalNumbers& focal, const NumberGrid* d) {
  std::array<double, 8> c{};
  if (d) {
    const std::size_t counts[] = {0, 4, 5, 8, 12, 14};
    const bool zero =
        std::all_of(d->values.begin(), d->values.end(), [](double value) { return value == 0.0; });
    if (!zero && std::find(std::begin(counts), std::end(counts), d->count()) == std::end(counts)) {
      throw ConfigError(d->Place() + ": expected 0, 4, 5, 8, 12 or 14 coefficients, found " +
                        std::to_string(d->count()));
    }
    for (std::size_t i = 0; i < d->count(); ++i) {
      if (i < c.size()) {
        c[i] = d->values[i];
      } else if (d->values[i] != 0.0) {
        d->Refuse(i,
                  "0: no lens here has terms of a thin prism or a tilted sensor (s1 to s4, tau)");
      }
    }
  }
  if (c[5] == 0.0 && c[6] == 0.0 && c[7] == 0.0) {
    return WithFocal(BrownPinhole{.k1 = c[0], .k2 = c[1], .k3 = c[4], .p1 = c[2], .p2 = c[3]},
                     focal);
  }
  return WithFocal(
      RationalPinhole{.k = {c[0], c[1], c[4], c[5], c[6], c[7]}, .p1 = c[2], .p2 = c[3]}, focal);
}

Lens OmniOf(const FocalNumbers& focal, double xi, const NumberGrid* d) {
  Omni lens = WithFocal(Omni{.xi = xi}, focal);
  if (!d || d->count() == 0) return lens;
  d->RequireCount(4);
  lens.k1 = d->values[0];
  lens.k2 = d->values[1];
  lens.p1 = d->values[2];
  lens.p2 = d->values[3];
  return lens;
}

Lens FisheyeOf(const FocalNumbers& focal, const NumberGrid* d) {
  KannalaBrandt lens = WithFocal(KannalaBrandt{}, focal);
  if (!d || d->count() == 0) return lens;
  const bool zero =
      std::all_of(d->values.begin(), d->values.end(), [](double value) { return value == 0.0; });
  if (zero) return lens;
  d->RequireCount(4);
  for (std::size_t i = 0; i < 4; ++i) lens.k[i] = d->values[i];
  return lens;
}

}  // namespace dockyard
