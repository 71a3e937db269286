// Pictures of the pyramid's marks for tests of the controller: polygons and a solid of revolution
// through the camera's own lens, with clutter and noise. Nothing of render/ is in it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

/// RAPOSA with round numbers: raposa.md 3 and 5.1. The camera is at the robot's turning centre
/// unless lever_m says how far behind it.
Nominal TestNominal(double lever_m = 0.0);

using Colour = std::array<double, 3>;  // linear, 0 to 255

/// A convex polygon in the image.
struct Clutter {
  std::vector<Eigen::Vector2d> corners_px;
  Colour colour;
  bool in_front = false;  // of the marks
};
Clutter Box(double left_px, double top_px, double right_px, double bottom_px, const Colour& colour,
            bool in_front = false);

inline constexpr Colour kOrange{181, 31, 5}, kBlue{8, 46, 173}, kGrey{70, 70, 70};

struct Scene {
  Colour orange = kOrange, blue = kBlue, background = kGrey;
  bool pyramid = true;
  double strip_m = 0.01;     // width of the square's blue edges, on front and sides; 0: all blue
  double camera_up_m = 0.0;  // above the guide's middle
  double pitch_rad = 0.0;    // of the camera, down
  double noise = 0.0;        // 1 sigma of each channel
  std::uint64_t seed = 1;
  std::vector<Clutter> clutter{};
};

/// What the camera sees from X_PC (P: the guide's middle, x out along its axis; the pose's x axis
/// points along the view). Beyond half_view_rad of the nominal parameters all is dark.
RgbImage Draw(const Nominal& nominal, const Pose2& X_PC, const Scene& scene);

/// The camera's pose at r, alpha about the guide, which lies right of the view's middle by the
/// bearing.
Pose2 CameraAt(double r_m, double alpha_rad, double bearing_rad = 0.0);

}  // namespace dockyard::raposa
