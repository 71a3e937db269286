// Files of points and their pixels for the command pose.
#pragma once

#include <string>
#include <vector>

#include "controller/vision/pose_refine.h"

namespace dockyard {

/// The points of one frame.
struct PointFrame {
  std::string name;  // the cell of the column `frame`; empty without it
  std::vector<PointPixel> points;
  std::vector<int> rows;  // of the file, the first below the header is 1
  int not_detected = 0;   // further rows, whose pixel is empty or NaN
};

/// The columns are camera, u_px, v_px, x_m, y_m, z_m. Optional are frame, survey_error_m and
/// disc_diameter_m; an empty cell there counts as a missing column. Other columns are ignored,
/// unless the name nearly spells an optional one or a missing one. Frames come in the order in
/// which they first appear; their rows may be mixed. A row whose u_px or v_px is empty or NaN is a
/// point that was not detected: it is counted and left out. Throws ConfigError.
/// @param sequence  false: more than one frame is an error; true: a missing column `frame` is one
/// @param rig  given: a pixel outside its camera's image is an error
std::vector<PointFrame> LoadPointFrames(const std::string& file, bool sequence,
                                        const StereoRig* rig = nullptr);

/// Default survey error [m]: 1 mm for each metre of the longest side of the box about all points;
/// the box lies along the axes of the body.
double DefaultSurveyError(const std::vector<PointFrame>& frames);

}  // namespace dockyard
