// Files of points and their pixels for the command pose.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/vision/pose_refine.h"

namespace dockyard {

/// What is seen at one time.
struct PointFrame {
  std::string name;  // the cell of the column `frame`; empty without it
  std::vector<PointPixel> points;
  std::vector<int> rows;  // of the file, the first below the header is 1
};

/// The columns camera, u_px, v_px, x_m, y_m, z_m; optional are frame, survey_error_m,
/// disc_diameter_m, where an empty cell is as no column. Further columns are left alone, unless
/// their name is a slip of the pen of an optional one. Frames in the order in which they first
/// appear; their rows may be mixed. Throws ConfigError.
/// @param sequence  false: more than one frame is an error; true: a file without frames is
std::vector<PointFrame> LoadPointFrames(const std::string& file, bool sequence);

/// Default of the survey's error: 1 mm for each metre of the longest side of the box, along the
/// axes of the body, about all its points [m].
double DefaultSurveyError(const std::vector<PointFrame>& frames);

}  // namespace dockyard
