// What is behind a camera's lens, and how far a built lens may be off its design.
#pragma once

namespace dockyard {

/// How the images' exposure is set.
enum class ExposureRule { kAutomatic, kFixed, kBracketed };
/// Which image sets an exposure that is not fixed: the same one, or the one before it.
enum class ExposureBy { kSame, kBefore };
struct ExposureModel {
  ExposureRule rule = ExposureRule::kAutomatic;
  ExposureBy by = ExposureBy::kSame;
  double percent = 5.0;        // automatic: this share of the pixels exceeds ...
  double level = 0.49;         // ... this share of the full well
  double fixed_e = 0.0;        // fixed: electrons of radiance 1
  double bracket_stops = 2.0;  // bracketed: images in turn at 0, less, more
};

/// Thin lens; all is sharp when distance_m is 0.
struct FocusModel {
  double focal_length_m = 0.0, f_number = 0.0, distance_m = 0.0, pixel_pitch_m = 0.0;
};

/// How a video camera exposes its lines. Interlaced: all even lines, then all odd ones.
enum class VideoFields { kProgressive, kInterlaced };
/// A field of 525-line video lasts 1/60 s (EIA RS-170, monochrome).
inline constexpr double kFieldPeriod_s = 1.0 / 60.0;

/// What an image undergoes as analogue video from the sensor to a frame grabber. None by default.
struct VideoModel {
  double noise_share = 0.0;     // added to the signal, 1 sigma, of full scale
  double line_jitter_px = 0.0;  // of each line's start along the row, 1 sigma
  VideoFields fields = VideoFields::kProgressive;
};

/// Pixels that do not measure light as the others do. None by default.
struct DefectModel {
  double hot_share = 0.0;         // of the pixels: their dark signal is high
  double hot_rate_e_per_s = 0.0;  // its mean while the shutter is open; exponential
  double hot_offset_e = 0.0;      // mean of what some of them add in every image; exponential
  double dead_share = 0.0;        // of the pixels: they get no light
};

struct SensorModel {
  double full_well_e = 0.0, read_noise_e = 0.0;
  double vignetting_exponent = 0.0;  // irradiance falls as cos^n of the angle off axis
  double blur_sigma_px = 0.0;        // lens and pixel together
  double response_sigma = 0.0;       // of pixels among each other
  double shutter_s = 0.0;            // open for so long; 0: a moving camera is sharp, too
  double readout_s = 0.0;            // from the first row's exposure to the last's; 0: all at once
  int bits = 8;                      // of a pixel; the controller gets the upper eight
  ExposureModel exposure;
  FocusModel focus;
  VideoModel video{};
  DefectModel defects{};
};

/// 1 sigma each, but for the ripple.
struct LensErrors {
  double focal_sigma = 0.0;  // relative
  double centre_sigma_px = 0.0;
  double radial_sigma_px = 0.0;  // lens's radial term, at the middle of the image's left edge
  double ripple_px = 0.0;        // rms over the image of what no parameter of the model takes up
};

}  // namespace dockyard
