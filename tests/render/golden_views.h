// The images kept in tests/render/golden: how they are made and when another equals them.
#pragma once

#include <string>
#include <vector>

#include "render/scene_samples.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

struct GoldenView {
  const char* name;  // of its file, without .png
  Light light;
  double range_m;
};

const std::vector<GoldenView>& GoldenViews();

/// The sample yard under one of the three kinds of light, 320 x 240.
std::unique_ptr<Yard> GoldenYard(const GoldenView& view);
StereoRig GoldenRig();
/// Its left image.
GrayImage DrawGolden(const Yard& yard, const StereoRig& rig);

struct ImageDifference {
  double mean = 0.0;      // grey levels
  double beyond_4 = 0.0;  // share of the pixels
  double block = 0.0;     // largest difference of the means of 8 x 8 pixels [grey levels]

  /// Within the difference that another Mesa or processor may make.
  bool small() const { return mean < 0.5 && beyond_4 < 0.01 && block < 5.0; }
};
ImageDifference Compare(const GrayImage& a, const GrayImage& b);

/// Throws std::runtime_error when the file cannot be read or written.
GrayImage ReadPng(const std::string& path);
void WritePng(const std::string& path, const GrayImage& image);

}  // namespace dockyard
