// A cheap colour camera's sensor and electronics: from light to the picture that a controller gets.
// Equations and sources: docs/reference/images.md.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "controller/geometry/image.h"
#include "render/colour_view.h"

namespace dockyard {

struct ColourSensorOptions {
  double blur_sigma_px = 1.0;   // Gaussian, lens and pixel together; assumed, 0.7-1.5
  double full_well_e = 8000.0;  // of each colour; assumed, 4000-15000
  double read_noise_e = 12.0;   // assumed, 5-25
  // Automatic exposure: the mean green of the lit part goes to this share of the full well.
  double target_level = 0.18;    // assumed, 0.12-0.25
  double exposure_lag_s = 0.3;   // of the logarithm; 0: at once; assumed, 0.1-1
  double most_exposure_e = 2e6;  // electrons of radiance 1: the limit in the dark; assumed, 5e5-1e7
  double fixed_exposure_e = 0.0;  // electrons of radiance 1; 0: automatic
  // Automatic white balance: the mean colour of the lit part goes to grey.
  bool auto_balance = true;
  double balance_lag_s = 1.0;        // of the logarithm; 0: at once; assumed, 0.3-3
  double most_balance = 2.5;         // either way from balance; assumed, 2-4
  Eigen::Vector3d balance{1, 1, 1};  // gains of red, green, blue; where the automatic one is off
  bool halve_colour = true;          // two pixels side by side share their colour (4:2:2)
  bool gamma = true;                 // the transfer curve of IEC 61966-2-1 (sRGB)
};

/// What the camera remembers from picture to picture; a new one has seen none, and exposes its
/// first picture as if it had settled.
struct ColourSensorState {
  double exposure_e = 0.0;           // electrons of radiance 1
  Eigen::Vector3d balance{0, 0, 0};  // gains

  bool operator==(const ColourSensorState&) const = default;
};

/// Takes a picture, and lets exposure and balance follow what it shows for the next. since_s: since
/// the last picture. key: stream of this picture's noise. A pure function of its arguments. Throws
/// std::invalid_argument for a blur over 1.5 px. Values are linear without the gamma.
RgbImage ExposeColourView(const ColourRadiance& light, const ColourSensorOptions& options,
                          double since_s, std::uint64_t key, ColourSensorState& state);

}  // namespace dockyard
