#include "controller/raposa/square_sought.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

constexpr double kFrom_rad = Radians(-110.0), kStep_rad = Radians(20.0);
constexpr double kWithin_m = 1.2;    // assumed, 0.8-1.5
constexpr double kAbout_px = 2.0;    // of a strip, at kLimitsFocal_px; assumed, 1-3
constexpr double kInView = 0.7;      // of the strips; assumed, 0.5-0.9
constexpr double kLeastBlue = 0.15;  // of the strips' area; assumed, 0.1-0.3

double AreaOf(const ConvexPolygon& polygon) {
  double sum = 0.0;
  for (int i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d& a = polygon.corners[static_cast<std::size_t>(i)];
    const Eigen::Vector2d& b = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
    sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  return std::abs(sum);
}

/// Pairs of pixels about strips.
struct Tally {
  int all = 0, in_view = 0, blue = 0;
};
void CountAbout(const TintMap& map, const ConvexPolygon& strip, Tally* tally) {
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int i = 0; i < strip.count; ++i) {
    low = low.cwiseMin(strip.corners[static_cast<std::size_t>(i)]);
    high = high.cwiseMax(strip.corners[static_cast<std::size_t>(i)]);
  }
  const double about_px = kAbout_px * map.finer;
  const int i0 = static_cast<int>(std::floor(0.5 * (low.x() - about_px)));
  const int i1 = static_cast<int>(std::ceil(0.5 * (high.x() + about_px)));
  const int j0 = static_cast<int>(std::floor(low.y() - about_px));
  const int j1 = static_cast<int>(std::ceil(high.y() + about_px));
  tally->all += (i1 - i0 + 1) * (j1 - j0 + 1);
  for (int j = std::max(0, j0); j <= std::min(map.light.height - 1, j1); ++j) {
    for (int i = std::max(0, i0); i <= std::min(map.light.width - 1, i1); ++i) {
      const Tint tint = map.tints[map.Index(i, j)];
      tally->in_view += tint != Tint::kUnseen;
      tally->blue += tint == Tint::kBlue;
    }
  }
}

bool Lacks(const TintMap& map, const MarksInImage& marks) {
  Tally tally;
  double area_px2 = 0.0;
  for (const ConvexPolygon& strip : marks.strips) {
    if (strip.count < 3) continue;
    CountAbout(map, strip, &tally);
    area_px2 += AreaOf(strip);
  }
  return tally.in_view > kInView * tally.all && 2.0 * tally.blue < kLeastBlue * area_px2;
}

}  // namespace

std::size_t AngleIndex(double alpha_rad) {
  const double index = std::round((alpha_rad - kFrom_rad) / kStep_rad);
  return static_cast<std::size_t>(
      std::clamp(index, 0.0, static_cast<double>(Angles().size()) - 1.0));
}

Angles AnglesWithoutSquare(const Nominal& nominal, const TintMap& map, const PyramidPlace& guide) {
  Angles without;
  const Pose2& X_VD = guide.X_VD;
  if (std::hypot(X_VD.x, X_VD.y) > kWithin_m) return without;
  const double bearing_rad = std::atan2(X_VD.y, X_VD.x);
  for (std::size_t i = 0; i < without.size(); ++i) {
    PyramidPlace place = guide;
    const double alpha_rad = kFrom_rad + static_cast<double>(i) * kStep_rad;
    place.X_VD.heading = WrapPi(bearing_rad + kPi - alpha_rad);
    const auto marks = ProjectMarks(nominal, place);
    without[i] = marks && Lacks(map, *marks);
  }
  return without;
}

}  // namespace dockyard::raposa
