#include "sim/app/stereo_truth.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <vector>

#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "sim/app/stereo_files.h"
#include "sim/images/deep_png.h"
#include "sim/images/pfm.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostTruthBytes = std::size_t{256}
                                        << 20;  // 40 megapixels of floats have 160 MB

std::optional<Disparities> FromPng(const std::string& bytes) {
  const auto image = DeepFromPng(bytes);
  if (!image) return std::nullopt;
  Disparities truth{image->width, image->height, {}};
  const double per_px = image->bits == 16 ? kDisparityNumbers : 1.0;
  for (const std::uint16_t number : image->pixels) {
    truth.px.push_back(static_cast<float>(number / per_px));
  }
  return truth;
}

std::optional<Disparities> FromPfm(const std::string& bytes) {
  auto image = DecodePfm(bytes);
  if (!image) return std::nullopt;
  return Disparities{image->width, image->height, std::move(image->pixels)};
}

std::string PixelsText(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height) + " px";
}

}  // namespace

Disparities LoadTruth(const std::string& file, int width, int height) {
  const std::string bytes = ReadBytes(file, kMostTruthBytes);
  auto truth = bytes.starts_with("Pf") ? FromPfm(bytes) : FromPng(bytes);
  if (!truth) {
    throw ConfigError(file +
                      ": expected true disparities, a grey PNG of 8 or 16 bits or a whole grey PFM "
                      "(Pf), found something else");
  }
  if (truth->width != width || truth->height != height) {
    throw ConfigError(file + ": expected the size of the left rectified image, " +
                      PixelsText(width, height) + ", found " +
                      PixelsText(truth->width, truth->height));
  }
  for (float& px : truth->px) {
    if (!(px > 0.0F) || std::isinf(px)) px = std::numeric_limits<float>::quiet_NaN();
  }
  return std::move(*truth);
}

StereoScore ScoreOf(const Disparities& found, const Disparities& truth) {
  StereoScore score;
  std::vector<double> off;
  double squares = 0.0;
  for (std::size_t i = 0; i < truth.px.size(); ++i) {
    if (std::isnan(truth.px[i])) continue;
    ++score.truths;
    if (std::isnan(found.px[i])) continue;
    off.push_back(std::abs(static_cast<double>(found.px[i]) - static_cast<double>(truth.px[i])));
    squares += off.back() * off.back();
  }
  score.matched = static_cast<long>(off.size());
  if (off.empty()) return score;
  const double count = static_cast<double>(off.size());
  const auto Beyond = [&](double px) {
    return static_cast<double>(
               std::count_if(off.begin(), off.end(), [&](double each) { return each > px; })) /
           count;
  };
  score.bad_1 = Beyond(1.0);
  score.bad_2 = Beyond(2.0);
  score.bad_4 = Beyond(4.0);
  score.rms_px = std::sqrt(squares / count);
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  score.median_px = *middle;
  return score;
}

Json ToJson(const StereoScore& score) {
  return {{"pixels", score.truths},
          {"density", score.density()},
          {"bad_1px_share", score.bad_1},
          {"bad_2px_share", score.bad_2},
          {"bad_4px_share", score.bad_4},
          {"rms_px", score.rms_px},
          {"median_error_px", score.median_px}};
}

std::string TextOf(const StereoScore& score) {
  char text[320];
  std::snprintf(text, sizeof text,
                "of %ld pixels with a true disparity %.1f %% are matched\n"
                "of these %.2f, %.2f, %.2f %% are off by more than 1, 2, 4 px; rms %.3f px, median "
                "%.3f px\n",
                score.truths, 100.0 * score.density(), 100.0 * score.bad_1, 100.0 * score.bad_2,
                100.0 * score.bad_4, score.rms_px, score.median_px);
  return text;
}

std::string NothingScored(const std::string& file, const StereoScore& score) {
  return file +
         (score.truths == 0 ? ": no pixel has a true disparity (0, negative numbers, "
                              "infinity and NaN are unknown)"
                            : ": no pixel with a true disparity is matched") +
         ": nothing is scored";
}

}  // namespace dockyard
