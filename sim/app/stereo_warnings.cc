#include "sim/app/stereo_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/app/image_files.h"

namespace dockyard {
namespace {

constexpr int kFewCorners = 20;  // too few to judge by
// Corners found: a number, a share of all, a share of those found there and back. Rendered yards,
// boards and noise: of two scenes 0-10, 0.00-0.18, 0.2-0.4; of pairs 14-180, 0.3-0.9, 0.6-1.0.
constexpr double kLeastFound = 8, kShareFound = 0.08, kAgree = 0.3;
constexpr double kLeastSlope = 12, kShareSlope = 0.15, kAgreeSlope = 0.5;
constexpr double kLevel = 4.0;        // pixels by which rows go apart
constexpr double kFinest = 0.5;       // of a pixel of the smaller images, for slopes of rows
constexpr double kRowsOff_px = 1.0;   // what the matchers bear
constexpr double kBehind_px = 1.0;    // a disparity so far below that of points far away
constexpr double kStill_px = 0.25;    // no disparity
constexpr double kBeyondShare = 0.9;  // of corners beyond the search: hardly a match is right
constexpr int kStep = 16;             // of --disparities

template <typename... Numbers>
std::string Worded(const char* format, Numbers... numbers) {
  char text[320];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// Whether enough corners agree on their rows. Any few agree on rows that are tilted enough, so
/// such rows need more: up to 10 corners of two scenes did, half of those found there and back.
bool HasEnough(const PairCheck& check) {
  const double found = static_cast<double>(check.found.size());
  const double slope_px = std::max(std::abs(check.across_px), std::abs(check.down_px));
  const bool is_level = slope_px <= kLevel * check.pixel_px;
  return found >= (is_level ? kLeastFound : kLeastSlope) &&
         found >= (is_level ? kShareFound : kShareSlope) * check.corners &&
         found >= (is_level ? kAgree : kAgreeSlope) * check.both_ways;
}

GrayImage Mirrored(const GrayImage& image) {
  GrayImage mirrored = image;
  for (int y = 0; y < image.height; ++y) {
    const auto row = mirrored.pixels.begin() + static_cast<std::ptrdiff_t>(y) * image.width;
    std::reverse(row, row + image.width);
  }
  return mirrored;
}

/// Why hardly any corner was found.
std::string NoPair(const Rectifier& rectifier, const StereoImages& images, const PairCheck& check) {
  const std::string found = Worded("%zu of %d corners of the left image are found in the right one",
                                   check.found.size(), check.corners);
  if (HasEnough(CheckPair(rectifier, {images.left, UpsideDown(images.right)}))) {
    return found + "; with one image turned upside down they are: turn it back";
  }
  if (HasEnough(CheckPair(rectifier, {images.left, Mirrored(images.right)}))) {
    return found + "; with one image mirrored they are: mirror it back";
  }
  return found + Worded(": do they show two different scenes? (Rows were tried up to %g px off.)",
                        check.farthest_row_px);
}

std::size_t CountWhere(const PairCheck& check, bool (*holds)(const FoundCorner&, double),
                       double number) {
  return static_cast<std::size_t>(
      std::count_if(check.found.begin(), check.found.end(),
                    [&](const FoundCorner& corner) { return holds(corner, number); }));
}

void JudgeRows(const PairCheck& check, std::vector<std::string>& warnings) {
  const std::size_t count = check.found.size();
  const double off_px = std::max(kRowsOff_px, kFinest * check.pixel_px);
  if (std::abs(check.lower_px) > off_px) {
    warnings.push_back(
        Worded("the right image is %.1f rows %s than the left one (median of %zu corners): do the "
               "images belong to this file of cameras?",
               std::abs(check.lower_px), check.lower_px > 0.0 ? "lower" : "higher", count));
  }
  if (std::abs(check.across_px) > 2.0 * off_px) {
    warnings.push_back(Worded(
        "from left to right the rows of the two images go apart by %.1f px (%zu corners): one "
        "is turned by %.2f deg against the other",
        std::abs(check.across_px), count, Degrees(std::abs(check.turn_rad))));
  }
  if (std::abs(check.down_px) > 2.0 * off_px) {
    warnings.push_back(Worded(
        "from top to bottom the rows of the two images go apart by %.1f px (%zu corners): the "
        "right one's scale is %.2f %% off",
        std::abs(check.down_px), count, 100.0 * check.scale));
  }
}

void JudgeSides(const PairCheck& check, double far_px, int most_px,
                std::vector<std::string>& warnings) {
  const std::size_t count = check.found.size();
  const std::size_t behind = CountWhere(
      check, [](const FoundCorner& corner, double px) { return corner.disparity_px < px; },
      far_px - kBehind_px);
  if (2 * behind > count) {
    warnings.push_back(Worded(
        "%zu of %zu corners lie further to the right in the right image, as none can: are the "
        "images exchanged, or both upside down?",
        behind, count));
    return;
  }
  const std::size_t still = CountWhere(
      check,
      [](const FoundCorner& corner, double px) {
        return std::hypot(corner.disparity_px - px, corner.lower_px) < kStill_px;
      },
      0.0);
  if (10 * still > 9 * count) {
    warnings.push_back(Worded(
        "%zu of %zu corners have no disparity: is it the same image twice, or a scene too far "
        "away for the baseline?",
        still, count));
    return;
  }
  double largest_px = 0.0;
  std::size_t beyond = 0;
  for (const FoundCorner& corner : check.found) {
    if (most_px <= 0 || corner.disparity_px <= most_px) continue;
    ++beyond;
    largest_px = std::max(largest_px, corner.disparity_px);
  }
  if (static_cast<double>(beyond) > kBeyondShare * static_cast<double>(count)) {
    warnings.push_back(
        Worded("%zu of %zu corners have a larger disparity than the %d px that are "
               "tried, up to %.0f px: --disparities %d",
               beyond, count, most_px, largest_px,
               kStep * (1 + static_cast<int>(std::ceil(largest_px / kStep)))));
  }
}

}  // namespace

PairVerdict JudgePair(const Rectifier& rectifier, const StereoImages& images, int most_px) {
  if (images.left == images.right) {
    return {{}, {"left and right are the same image"}};
  }
  PairVerdict verdict{CheckPair(rectifier, images), {}};
  const PairCheck& check = verdict.check;
  if (check.corners < kFewCorners) {
    const bool is_small = std::min(images.left.width, images.left.height) < 100;
    if (!is_small) {
      verdict.warnings.push_back(
          Worded("the left image has %d corners: too few to tell whether the "
                 "images match",
                 check.corners));
    }
    return verdict;
  }
  if (!HasEnough(check)) {
    verdict.warnings.push_back(NoPair(rectifier, images, check));
    return verdict;
  }
  JudgeSides(check, -rectifier.pair().doffs_px, most_px, verdict.warnings);
  JudgeRows(check, verdict.warnings);
  return verdict;
}

Json ToJson(const PairCheck& check) {
  const bool any = !check.found.empty();
  return {{"corners", check.corners},
          {"found_both_ways", check.both_ways},
          {"found", check.found.size()},
          {"right_lower_px", any ? Json(check.lower_px) : Json()},
          {"apart_across_px", any ? Json(check.across_px) : Json()},
          {"apart_down_px", any ? Json(check.down_px) : Json()}};
}

}  // namespace dockyard
