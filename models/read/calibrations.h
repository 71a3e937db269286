// Calibrations as other programs write them: ROS's camera_info, Kalibr's chains, OpenCV's storage.
// docs/reference/cameras.md describes them.
#pragma once

#include <string>
#include <vector>

#include "models/read/load_cameras.h"
#include "models/read/number_grid.h"
#include "models/read/read_lens.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

enum class CalibrationForm { kOurs, kRos, kKalibr, kOpenCv };

/// By its keys.
CalibrationForm FormOf(const YamlNode& root);
/// "a camera_info of ROS", for messages.
const char* NameOf(CalibrationForm form);

/// The tree of a camera's file: YAML, JSON, or OpenCV's storage as YAML or XML. Throws ConfigError.
YamlNode LoadCameraTree(const std::string& file);

/// Each throws ConfigError.
PlacedCamera ReadRosCamera(const YamlNode& root);
/// In the frame of the chain's first camera.
std::vector<PlacedCamera> ReadKalibrChain(const YamlNode& root);
/// One, or two named left and right in the frame of the left.
std::vector<PlacedCamera> ReadOpenCvCameras(const YamlNode& root);

/// The camera `left` or `right` of our own rig: its keys, or the name of a file with it.
PlacedCamera ReadSide(const YamlReader& rig, const std::string& side);
/// `calibration_error_px` of our own camera or rig.
double ReadCalibrationError(const YamlReader& in);
/// Of the keys of our own rig.
YamlReader RigReader(const YamlNode& root);

// Parts that the readers share.

/// Of [fx 0 cx; 0 fy cy; 0 0 1].
FocalNumbers ReadFocalMatrix(const NumberGrid& K);
/// The lens of OpenCV's pinhole with 0, 4, 5, 8, 12 or 14 coefficients, k1 k2 p1 p2 k3 ...; `d`
/// null: none.
Lens PinholeOf(const FocalNumbers& focal, const NumberGrid* d);
/// Of OpenCV's fisheye module, and ROS's and Kalibr's equidistant: k1 k2 k3 k4, or none.
Lens FisheyeOf(const FocalNumbers& focal, const NumberGrid* d);
/// Of OpenCV's omnidir module and Kalibr's omni: k1 k2 p1 p2, or none.
Lens OmniOf(const FocalNumbers& focal, double xi, const NumberGrid* d);
/// The first key of these that the mapping has, or null.
const YamlNode* FindFirst(const YamlNode& root, const std::vector<std::string>& keys,
                          std::string* found = nullptr);
/// A whole number from 1 to 16384 pixels.
int PixelCount(const YamlNode& node, const std::string& path);
[[noreturn]] void RefuseNode(const YamlNode& node, const std::string& path,
                             const std::string& expected);

}  // namespace dockyard
