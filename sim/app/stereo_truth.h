// Disparities scored by a file of true ones.
#pragma once

#include <string>

#include "controller/stereo/match.h"
#include "sim/base/json.h"

namespace dockyard {

/// Of the pixels whose true disparity the file has.
struct StereoScore {
  long truths = 0, matched = 0;  // pixels with a true disparity, and those found of them
  double bad_1 = 0.0, bad_2 = 0.0, bad_4 = 0.0;  // shares of matched, off by more px
  double rms_px = 0.0, median_px = 0.0;          // of matched; the median of the sizes

  double density() const { return truths > 0 ? 1.0 * matched / static_cast<double>(truths) : 0.0; }
};

/// True disparities of a left rectified image: a PFM; or a PNG, of 16 bits in 1/256 px, of 8 bits
/// in whole px. 0, negative numbers, infinity and NaN: unknown, and NaN in the answer. Throws
/// ConfigError, also for another size.
Disparities LoadTruth(const std::string& file, int width, int height);

StereoScore ScoreOf(const Disparities& found, const Disparities& truth);

Json ToJson(const StereoScore& score);
std::string TextOf(const StereoScore& score);
/// Why a score of no pixel says nothing.
std::string NothingScored(const std::string& file, const StereoScore& score);

}  // namespace dockyard
