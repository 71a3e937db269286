// What `dockyard check` says about files of cameras.
#pragma once

#include <string>

#include "models/read/yaml_tree.h"
#include "sim/run/system.h"

namespace dockyard {

/// Whether the tree is a calibration of another program: of ROS, Kalibr or OpenCV.
bool IsCalibration(const YamlNode& root);

/// One camera or several. Throws ConfigError.
FileCheck CheckCameras(const std::string& file);
/// A pair. Warns of pixels without a ray, and of a right camera that is not on the right.
FileCheck CheckRig(const std::string& file);
/// Either, of another program.
FileCheck CheckCalibration(const std::string& file);

}  // namespace dockyard
