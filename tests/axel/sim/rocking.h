// How a reeled rover rocks on its paddles: roll and heading over time, and their spectra.
#pragma once

#include <vector>

#include "models/parts/soil_model.h"

namespace dockyard::axel {

/// Sampled every kRockingSample_s while the rover is reeled in at 0.06 m/s on free wheels.
struct Rocking {
  std::vector<double> roll_deg, heading_deg;
};
inline constexpr double kRockingSample_s = 0.02;
/// Frequency with which the paddles' tips take the ground: 12 of them, 0.06 m/s over 0.30 m.
inline constexpr double kPaddles_hz = 0.2 * 12.0 / (2.0 * 3.14159265358979);

/// 40 s from 4.5 m, the right wheel's paddles this far before the left one's.
Rocking ReelOver(const SoilModel& soil, double right_phase_rad);

/// Power of a signal less its mean and trend, by frequency; all of it adds up to the square of the
/// signal's rms.
struct Spectrum {
  std::vector<double> hertz, power;
  /// Within 12.5 % of a frequency.
  double PowerNear(double at_hz) const;
};
Spectrum SpectrumOf(const std::vector<double>& signal, double highest_hz);

/// Spectra over runs at four phases of the paddles, half of their pitch apart on average, as a
/// scenario draws them; and the largest departure from the mean and trend.
struct RockingSpectra {
  Spectrum roll, heading;
  double most_roll_deg = 0.0, most_heading_deg = 0.0;
};
RockingSpectra MeanSpectra(const SoilModel& soil);

}  // namespace dockyard::axel
