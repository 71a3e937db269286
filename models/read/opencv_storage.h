// OpenCV's FileStorage as a tree: its XML, and what its YAML has beyond our subset.
#pragma once

#include <string>

#include "models/read/yaml_tree.h"

namespace dockyard {

/// Blanks the directive "%YAML:1.0" and the tags "!!opencv-matrix", which say nothing that the keys
/// do not say. All else keeps its line and column.
void BlankOpenCvMarks(std::string& text);

/// The tree of <opencv_storage>: an element with elements is a mapping, of elements "_" a list; an
/// element with several words is a list, with one a scalar. Throws ConfigError.
YamlNode ParseOpenCvXml(const std::string& text, const std::string& file);

/// Whether the file's keys are those of one or two cameras as OpenCV's programs name them.
bool HasOpenCvCamera(const YamlNode& root);
/// Puts the keys of stereo_calib's extrinsics.yml to those of its intrinsics.yml, and back.
YamlNode MergedOpenCvFiles(const YamlNode& one, const YamlNode& other);

}  // namespace dockyard
