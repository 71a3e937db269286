// A stereo pair of a scene, as the rover's cameras would deliver it; one view of a grey or of a
// colour camera; or one view from anywhere.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "render/kept_exposure.h"
#include "render/lens_ripple.h"
#include "render/radiance_image.h"
#include "render/scene.h"

namespace dockyard {

struct ColourRadiance;
struct ColourTable;
struct ColourView;

/// Thin lens; all is sharp when distance_m is 0.
struct Focus {
  double focal_length_m = 0.0, f_number = 0.0, distance_m = 0.0, pixel_pitch_m = 0.0;
};

/// What lies on the window before one lens: nothing by default, and then the sizes do not matter.
struct WindowOptions {
  double distance_m = 0.0;      // window to pupil
  double pupil_m = 0.0;         // diameter of the pupil
  double cover_share = 0.0;     // of the image, behind an opaque cover
  double cover_side_rad = 0.0;  // where in the image: 0 right, a quarter turn up, and so on
  double dust_share = 0.0;      // of the image, behind opaque clumps of dust
  double dust_clump_m = 0.0;    // their median diameter
  double dust_scatter = 0.0;    // share of the light on them that veils the image
  std::uint64_t dust_key = 0;   // stream of their places
};

/// A dead camera gives a picture without light, or none.
enum class EyeState { kAlive, kDark, kSilent };

/// What an image undergoes as analogue video up to a frame grabber; none by default.
struct VideoOptions {
  double noise_share = 0.0;     // added to the signal, 1 sigma, of full scale
  double line_jitter_px = 0.0;  // of each line's start along the row, 1 sigma
  bool interlaced = false;      // for ExposeVideo: odd lines are exposed a field after even ones
};

/// Pixels that do not measure light as the others do, at places drawn by the pattern's stream; none
/// by default.
struct DefectOptions {
  double hot_share = 0.0;     // of the pixels
  double hot_dark_e = 0.0;    // mean of their dark signal in this exposure; exponential
  double hot_offset_e = 0.0;  // mean of what some of them add in every image; exponential
  double dead_share = 0.0;    // of the pixels: without light
};

/// The sensor behind the lens. Equations and sources: docs/reference/images.md.
struct SensorOptions {
  double full_well_e = 20000.0;
  double read_noise_e = 15.0;
  double response_sigma = 0.0;  // of pixels among each other, 1 sigma; the same in every image
  int bits = 8;                 // 8 to 16
  double vignetting_exponent = 0.0;
  double blur_sigma_px = 0.0;  // Gaussian, lens and pixel together
  Focus focus{};
  VideoOptions video{};
  DefectOptions defects{};
  // Automatic exposure: the radiance that this share of pixels exceeds is put at target_level.
  double exposure_percent = 5.0;  // MSL navcam practice: 5 % of pixels above the cut
  double target_level = 0.49;     // 2000 of 4095
  double fixed_exposure_e = 0.0;  // electrons of radiance 1; 0: automatic
  double exposure_stops = 0.0;    // off that, as a power of two: one of a bracket
  std::uint64_t noise_key = 0;    // stream of this image
  std::uint64_t pattern_key = 0;  // stream of these cameras
  // Faults, left then right; a single camera has the first. A silent camera's image has no pixels
  // and counts for no exposure.
  std::array<WindowOptions, 2> windows{};
  std::array<EyeState, 2> eyes{EyeState::kAlive, EyeState::kAlive};
};

enum class GlBackend { kOsMesa, kEglSurfaceless };

/// What a context says of itself: GL_VENDOR, GL_RENDERER and GL_VERSION.
struct GlNames {
  std::string vendor, renderer, version;
};

class StereoRenderer {
 public:
  /// Throws std::runtime_error with the reason when no context can be had.
  explicit StereoRenderer(GlBackend backend = GlBackend::kOsMesa);
  ~StereoRenderer();
  StereoRenderer(const StereoRenderer&) = delete;
  StereoRenderer& operator=(const StereoRenderer&) = delete;

  GlNames names() const;

  /// Both ideal views. X_WR: rover body in the world; the rig is the world's, not the calibration.
  /// ripples: of the left and the right lens.
  std::array<RadianceImage, 2> RenderRadiance(const Scene& scene, const StereoRig& rig,
                                              const Pose3& X_WR, bool with_depth = false,
                                              const std::array<LensRipple, 2>& ripples = {});
  /// One ideal view of a grey camera, at about half of what a pair costs. The ground is finest
  /// under it. The left view of a pair whose body is the camera's own frame, but that a level
  /// ground is drawn as a plane and that images under 1280 px get a shadow map as coarse as their
  /// pixels.
  RadianceImage RenderGrey(const Scene& scene, const Camera& camera, const Pose3& X_WC,
                           bool with_depth = false, const LensRipple& ripple = {});
  /// Red, green and blue of both ideal views; their luminance is what RenderRadiance gives.
  std::array<std::array<RadianceImage, 3>, 2> RenderColour(
      const Scene& scene, const StereoRig& rig, const Pose3& X_WR, bool with_depth = false,
      const std::array<LensRipple, 2>& ripples = {});
  /// Red, green and blue of one ideal view from anywhere. The ground is finest about `p_W`.
  std::array<RadianceImage, 3> RenderColourFrom(const Scene& scene, const Camera& camera,
                                                const Pose3& X_WC, const Eigen::Vector3d& p_W);
  /// One view of a colour camera in spectral light, through its hole: colour_view.h. X_WC: where it
  /// stands while it exposes, one pose or several (PosesInExposure), of which it sees the mean.
  /// Throws std::invalid_argument when the scene cannot be drawn.
  ColourRadiance RenderThrough(const Scene& scene, const ColourTable& colours,
                               const ColourView& view, const std::vector<Pose3>& X_WC);
  /// Both views through the sensor; one exposure for the pair.
  StereoImages Render(const Scene& scene, const StereoRig& rig, const Pose3& X_WR,
                      const SensorOptions& sensor);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Lens, exposure, noise and quantisation of a pair of ideal views; pure functions of their
/// arguments. The views hold depths if the lens has a focus.
std::array<DeepImage, 2> ExposeDeep(std::array<RadianceImage, 2> radiance, const StereoRig& rig,
                                    const SensorOptions& sensor);
/// The same in colour: red, green, blue of each camera, exposed as the grey pair would be.
std::array<std::array<DeepImage, 3>, 2> ExposeColour(
    const std::array<std::array<RadianceImage, 3>, 2>& radiance, const StereoRig& rig,
    const SensorOptions& sensor);
/// The same of one view alone, the left one of a pair of two such views to the bit: its window, its
/// state and its streams of noise.
DeepImage ExposeOne(RadianceImage radiance, const Camera& camera, const SensorOptions& sensor);
GrayImage ExposeGrey(RadianceImage radiance, const Camera& camera, const SensorOptions& sensor);
/// The image that the controller gets: the upper eight bits. before: of a pair whose exposure is
/// set by the images before (exposure_rule.h).
StereoImages ExposeStereo(std::array<RadianceImage, 2> radiance, const StereoRig& rig,
                          const SensorOptions& sensor, KeptExposure* before = nullptr);

}  // namespace dockyard
