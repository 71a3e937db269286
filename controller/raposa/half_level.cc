#include "controller/raposa/half_level.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "controller/base/median.h"
#include "controller/vision/linear_colour.h"

namespace dockyard::raposa {
namespace {

// Pixels outside of a rough edge and inside that a profile has; of the first ones the colour of the
// surroundings is taken. Assumed, 4-8, 3-5 and 2-3.
constexpr int kOutside = 6, kInside = 4, kSurroundings = 3;
constexpr double kLeastContrast = 0.01;  // of linear light; assumed, 0.005-0.02
// Of surroundings from the usual ones, as a share of the contrast. Assumed, 0.2-0.4.
constexpr double kOther = 0.3;
constexpr double kOutermost = 0.1;  // share of a side's profiles; assumed, 0.05-0.2

/// Pixels along a line across an edge, from outside inwards, as whole steps from its first.
struct Across {
  Eigen::Vector2i first, step, next;  // next: to the next line
};

/// Mean linear light of three neighbouring lines.
std::optional<std::vector<Eigen::Vector3d>> ProfileOf(const RgbImage& image, const Across& line) {
  std::vector<Eigen::Vector3d> profile;
  for (int k = 0; k < kOutside + kInside; ++k) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int aside : {-1, 0, 1}) {
      const Eigen::Vector2i at = line.first + k * line.step + aside * line.next;
      if (at.x() < 0 || at.y() < 0 || at.x() >= image.width || at.y() >= image.height) {
        return std::nullopt;
      }
      sum += LinearAt(image, at.x(), at.y()).cast<double>();
    }
    profile.push_back(sum / 3.0);
  }
  return profile;
}

Eigen::Vector3d SurroundingsOf(const std::vector<Eigen::Vector3d>& profile) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < kSurroundings; ++k) sum += profile[k];
  return sum / kSurroundings;
}

Eigen::Vector3d Middle(const std::vector<Eigen::Vector3d>& colours) {
  Eigen::Vector3d middle;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> channel;
    for (const Eigen::Vector3d& colour : colours) channel.push_back(colour[c]);
    middle[c] = Median(std::move(channel));
  }
  return middle;
}

/// The colours on either side of an edge, in the middle of all profiles across it.
struct Sides {
  Eigen::Vector3d surroundings{0, 0, 0}, mark{0, 0, 0};
};
Sides SidesOf(const std::vector<std::vector<Eigen::Vector3d>>& profiles) {
  std::vector<Eigen::Vector3d> surroundings, marks;
  for (const auto& profile : profiles) {
    surroundings.push_back(SurroundingsOf(profile));
    const auto distance = [&](const Eigen::Vector3d& colour) {
      return (colour - surroundings.back()).squaredNorm();
    };
    marks.push_back(*std::ranges::max_element(profile, {}, distance));
  }
  return {Middle(surroundings), Middle(marks)};
}

/// Steps from the first pixel's centre to the half level.
std::optional<double> HalfLevel(const std::vector<Eigen::Vector3d>& profile,
                                const Eigen::Vector3d& mark) {
  const Eigen::Vector3d outside = SurroundingsOf(profile), contrast = mark - outside;
  if (contrast.norm() < kLeastContrast) return std::nullopt;
  const auto level = [&](std::size_t k) {
    return (profile[k] - outside).dot(contrast) / contrast.squaredNorm();
  };
  for (std::size_t k = kSurroundings; k < profile.size(); ++k) {
    const double before = level(k - 1), now = level(k);
    if (now < 0.5) continue;
    return static_cast<double>(k) - (before < 0.5 ? (now - 0.5) / (now - before) : 0.5);
  }
  return std::nullopt;
}

/// How far outside of the rough edge the half level lies.
std::optional<double> Beyond(const RgbImage& image, Across line, int lines) {
  std::vector<std::vector<Eigen::Vector3d>> profiles;
  for (int i = 0; i < lines; ++i, line.first += line.next) {
    auto profile = ProfileOf(image, line);
    if (!profile) return std::nullopt;
    profiles.push_back(std::move(*profile));
  }
  if (profiles.empty()) return std::nullopt;
  const Sides sides = SidesOf(profiles);
  const double most_other = kOther * (sides.mark - sides.surroundings).norm();
  std::vector<double> beyond;
  for (const auto& profile : profiles) {
    // Another thing touches the mark here, such as its rod.
    if ((SurroundingsOf(profile) - sides.surroundings).norm() > most_other) continue;
    // The rough edge lies half a pixel before the first pixel inside.
    if (const auto at = HalfLevel(profile, sides.mark)) beyond.push_back(kOutside - 0.5 - *at);
  }
  if (beyond.empty()) return std::nullopt;
  std::ranges::sort(beyond, std::greater());
  return beyond[static_cast<std::size_t>(kOutermost * static_cast<double>(beyond.size()))];
}

}  // namespace

std::optional<BlobBounds> HalfLevelBounds(const RgbImage& image, const BlobBounds& rough) {
  const int left = static_cast<int>(std::lround(rough.left_px + 0.5));
  const int top = static_cast<int>(std::lround(rough.top_px + 0.5));
  const int right = static_cast<int>(std::lround(rough.right_px - 0.5));
  const int bottom = static_cast<int>(std::lround(rough.bottom_px - 0.5));
  const int columns = right - left - 1, rows = bottom - top - 1;
  const auto on_left = Beyond(image, {{left - kOutside, top + 1}, {1, 0}, {0, 1}}, rows);
  const auto on_right = Beyond(image, {{right + kOutside, top + 1}, {-1, 0}, {0, 1}}, rows);
  const auto above = Beyond(image, {{left + 1, top - kOutside}, {0, 1}, {1, 0}}, columns);
  const auto below = Beyond(image, {{left + 1, bottom + kOutside}, {0, -1}, {1, 0}}, columns);
  if (!on_left || !on_right || !above || !below) return std::nullopt;
  return BlobBounds{.left_px = left - 0.5 - *on_left,
                    .top_px = top - 0.5 - *above,
                    .right_px = right + 0.5 + *on_right,
                    .bottom_px = bottom + 0.5 + *below};
}

}  // namespace dockyard::raposa
