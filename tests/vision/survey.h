// Many image pairs of the board over the workspace, scored against the truth.
#pragma once

#include <functional>
#include <vector>

#include "controller/vision/board/locate.h"
#include "vision/synthetic_view.h"

namespace dockyard {

struct PoseSample {
  DockingCoords at;
  double pitch_rad = 0.0;
  bool in_view = false;  // whether all eight fiducials are in at least one image
  LocateOutput out;
  int wrong_marks = 0;  // named wrongly, or nothing there
  // Of the rover in the dock.
  double range_error_m = 0.0, heading_error_rad = 0.0;
  double place_error_m = 0.0;  // over the ground
};

struct SurveyOptions {
  int width = 1024, height = 768;
  double r_min_m = 1.0, r_max_m = 6.0;
  double alpha_rad = 40.0 * kPi / 180.0, h_rad = 25.0 * kPi / 180.0;
  double pitch_rad = 10.0 * kPi / 180.0;
  bool miscalibrated = false;
  // Changes the scene of image pair i, after its pose is set.
  std::function<void(SyntheticScene&, int)> arrange{};
};

/// Image pair i of the survey, at point i of a Halton sequence over the ranges.
PoseSample TakeSample(const SurveyOptions& options, int i);

/// Takes image pairs at poses i of the sequence until count of them are in view.
std::vector<PoseSample> Survey(const SurveyOptions& options, int count);

}  // namespace dockyard
