// Stray light of a lens: what it scatters over the image, of the scene and of the sun, and ghosts
// of the sun. No GL. Equations and sources: docs/reference/images.md.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "render/pixel_row.h"
#include "render/radiance_image.h"
#include "render/scene.h"

namespace dockyard {

/// The sun for one lens.
struct SunInLens {
  Eigen::Vector3d to_sun_C{0, 0, 1};  // unit
  double share = 0.0;                 // of its disc, what the lens's pupil has in sight
  double radius_rad = 0.0;            // of its disc
};

/// The law of scattering: radiance [1/sr] per irradiance of a distant source, by the chord c = 2
/// sin(angle / 2) between the two directions. A sum of Gaussians of equal weight whose widths
/// double, from core_rad to about 32 deg: between those 1 / (2 pi ln(32 deg / core) c^2). Adds up
/// to 1 over all directions.
class ScatterLaw {
 public:
  explicit ScatterLaw(double core_rad);
  float operator()(float chord2) const;
  /// The Gaussians' widths, 1 sigma each along either axis [rad].
  const std::vector<double>& sigmas_rad() const { return sigmas_rad_; }

 private:
  std::vector<double> sigmas_rad_;
  float exponent_ = 0.0f, weight_ = 0.0f;  // of the widest: exp(-exponent chord^2)
};

/// Stray light of the sun in one view.
struct SunStray {
  std::vector<float> per_irradiance;  // radiance that each pixel gets, row by row; empty: none
  std::vector<std::size_t> disc;      // pixels that may show some of the sun itself
};
/// grid: of the camera's pixels. The sun may lie off the image, up to 90 deg off the axis.
SunStray StrayOfSun(const StrayLight& stray, const PixelGrid& grid, const SunInLens& sun);

/// Adds the stray light of scene and sun to one channel of a view. Beyond the image the scene goes
/// on as at its border. An even field stays as it is.
/// @param px_per_rad  of the lens, on its axis
/// @param irradiance  of the sun in this channel, on a surface facing it, in sight as a whole
void AddStrayLight(const StrayLight& stray, double px_per_rad, const SunStray& of_sun,
                   double irradiance, RadianceImage& image);

/// Checks that the options are a lens's.
void CheckStray(const StrayLight& stray);

}  // namespace dockyard
