// A stereo pair of a scene, as the rover's cameras would deliver it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "render/scene.h"

namespace dockyard {

/// Linear radiance of one ideal view: exact lens geometry, no sensor.
struct RadianceImage {
  int width = 0, height = 0;
  std::vector<float> values;  // one grey channel, row by row from the top left
  float at(int x, int y) const { return values[static_cast<std::size_t>(y) * width + x]; }
};

/// The sensor behind the lens.
struct SensorOptions {
  double full_well_e = 20000.0;
  double read_noise_e = 15.0;
  double vignetting_exponent = 0.0;
  double blur_sigma_px = 0.0;  // Gaussian, lens and pixel together
  // Automatic exposure: the radiance that this share of pixels exceeds is put at target_level.
  double exposure_percent = 5.0;  // MSL navcam practice: 5 % of pixels above the cut
  double target_level = 0.49;     // 2000 of 4095
  std::uint64_t noise_key = 0;    // stream of this picture
};

enum class GlBackend { kOsMesa, kEglSurfaceless };

class StereoRenderer {
 public:
  /// Throws std::runtime_error with the reason when no context can be had.
  explicit StereoRenderer(GlBackend backend = GlBackend::kOsMesa);
  ~StereoRenderer();
  StereoRenderer(const StereoRenderer&) = delete;
  StereoRenderer& operator=(const StereoRenderer&) = delete;

  /// Both ideal views. X_WR: rover body in the world; the rig is the world's, not the calibration.
  std::array<RadianceImage, 2> RenderRadiance(const Scene& scene, const StereoRig& rig,
                                              const Pose3& X_WR);
  /// Both views through the sensor; one exposure for the pair.
  StereoImages Render(const Scene& scene, const StereoRig& rig, const Pose3& X_WR,
                      const SensorOptions& sensor);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Exposure, noise and quantisation of a pair of ideal views; pure function of its arguments.
StereoImages ExposeStereo(const std::array<RadianceImage, 2>& radiance, const StereoRig& rig,
                          const SensorOptions& sensor);

}  // namespace dockyard
