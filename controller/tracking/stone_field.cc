#include "controller/tracking/stone_field.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/geometry/pose.h"
#include "controller/tracking/stones_in_map.h"

namespace dockyard {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

// Of a stone's middle, along the line of sight and across, near by and at 1 m (docs/rocky7.md,
// FindStone on rendered pairs). It grows as the distance's square and as the distance.
constexpr double kAlong_m = 0.003, kAlongAt1_m = 0.009, kAcross_m = 0.002, kAcrossAt1_m = 0.004;
// Of a height: the same table, and what a stone shows of itself from another side.
constexpr double kHeight_m = 0.002, kHeightAt1_m = 0.0025;
constexpr double kHeightShare = 0.15;  // assumed, 0.1-0.3
// What stands out by few sigmas of the ground about it is noise; where a patch is matched wrongly,
// it is by about a pixel. Chances that grow from kLeastReal to kMostReal. Assumed: 3-4 and 5-8
// sigmas, 0.3-0.7 and 1.3-2 px.
constexpr double kNoise = 3.0, kReal = 6.0, kNoise_px = 0.5, kReal_px = 1.5;
constexpr double kLeastReal = 0.1, kMostReal = 0.9;
constexpr double kUp_m = 0.0005, kUpAt1_m = 0.0015;  // of a map's height (docs/rocky7.md, merged)
// Behind a stone's hidden back its edge is smeared: low things so near to it are it. Assumed,
// 0.4-0.7 of its height and 1.5-2.5 of a stone.
constexpr double kSmear = 0.6, kSmears = 1.8;
// The circle's outermost stones are seen by halves. Assumed, 0-3 cm.
constexpr double kBorder_m = 0.01;

Matrix2d SpreadAt(const Vector2d& p_E, const Eigen::Vector3d& p_EC) {
  const Vector2d away = p_E - p_EC.head<2>();
  const double r = away.norm();
  const Vector2d along = r > 0.0 ? Vector2d(away / r) : Vector2d::UnitX();
  const double a = kAlong_m + kAlongAt1_m * r * r, b = kAcross_m + kAcrossAt1_m * r;
  return a * a * along * along.transpose() +
         b * b * (Matrix2d::Identity() - along * along.transpose());
}

double LogNormal(const Vector2d& off, const Matrix2d& spread) {
  return -std::log(2.0 * kPi) - 0.5 * std::log(spread.determinant()) -
         0.5 * off.dot(spread.inverse() * off);
}

// How much likelier it is that the seen one is the remembered one than that it is another stone.
double Gain(const FieldStone& was, const FieldStone& is, const FieldMatch& so_far,
            const FieldSettings& with) {
  const Vector2d off = is.p - was.p - so_far.shift_m;
  const double place = LogNormal(off, so_far.spread_m2 + was.spread_m2 + is.spread_m2);
  const double sigma_m = std::hypot(was.height_sigma_m, is.height_sigma_m);
  const double height_off = (is.height_m - was.height_m) / sigma_m;
  const double height = std::log(with.clutter_height_m / (sigma_m * std::sqrt(2.0 * kPi))) -
                        0.5 * height_off * height_off;
  const double others_m2 = with.clutter_m2 + (1.0 - is.real) * with.noise_m2;
  return place - std::log(others_m2) + std::max(height, -with.height_price) +
         std::log(with.seen_again * was.real);
}

double Missed(const FieldStone& was, const FieldSettings& with) {
  return std::log(1.0 - with.seen_again * was.real);
}

void Take(const FieldStone& was, const FieldStone& is, FieldMatch& match) {
  const Vector2d off = is.p - was.p - match.shift_m;
  const Matrix2d sum = match.spread_m2 + was.spread_m2 + is.spread_m2;
  const Matrix2d gain = match.spread_m2 * sum.inverse();
  match.shift_m += gain * off;
  match.spread_m2 = ((Matrix2d::Identity() - gain) * match.spread_m2).eval();
}

// All others as they fit best, once one is given; odds is the whole's log likelihood meanwhile.
FieldMatch MatchFrom(std::size_t first_was, std::size_t first_is,
                     const std::vector<FieldStone>& remembered, const std::vector<FieldStone>& seen,
                     const Matrix2d& spread, const FieldSettings& with) {
  FieldMatch match{.spread_m2 = spread, .seen = std::vector<int>(remembered.size(), -1)};
  std::vector<bool> used(seen.size(), false);
  const auto pair = [&](std::size_t i, std::size_t j) {
    Take(remembered[i], seen[j], match);
    match.seen[i] = static_cast<int>(j);
    used[j] = true;
    ++match.matched;
  };
  match.odds += Gain(remembered[first_was], seen[first_is], match, with);
  pair(first_was, first_is);
  for (std::size_t i = 0; i < remembered.size(); ++i) {
    if (i == first_was) continue;
    double best = Missed(remembered[i], with);
    int best_j = -1;
    for (std::size_t j = 0; j < seen.size(); ++j) {
      if (used[j]) continue;
      const double gain = Gain(remembered[i], seen[j], match, with);
      if (gain <= best) continue;
      best = gain;
      best_j = static_cast<int>(j);
    }
    match.odds += best;
    if (best_j >= 0) pair(i, static_cast<std::size_t>(best_j));
  }
  return match;
}

Vector2d TargetOf(const FieldMatch& match, const std::vector<FieldStone>& remembered,
                  const std::vector<FieldStone>& seen) {
  const int j = match.seen.front();
  if (j >= 0) return seen[static_cast<std::size_t>(j)].p;
  return remembered.front().p + match.shift_m;
}

}  // namespace

std::vector<FieldStone> StonesAbout(const ElevationMap& map, const Vector2d& p_E,
                                    const Eigen::Vector3d& p_EC, const FieldSettings& settings) {
  // A curve through fewer cells bends to the stones.
  constexpr std::size_t kLeastCells = 100;
  const std::vector<MapCell> cells = CellsAbout(map, p_E, settings.radius_m);
  if (cells.size() < kLeastCells) return {};
  const GroundFit ground = FitGround(cells, p_E, GroundShape::kCurved);
  std::vector<FieldStone> stones;
  std::vector<StoneTop> tops = TopsAbout(cells, ground, p_E, settings.radius_m, {});
  std::sort(tops.begin(), tops.end(),
            [](const StoneTop& a, const StoneTop& b) { return a.top_m > b.top_m; });
  for (const StoneTop& top : tops) {
    if ((top.p_E - p_E).norm() > settings.radius_m - kBorder_m) continue;
    if (top.top_m > settings.tallest_m) continue;
    if (top.p_E.x() < p_EC.x() + settings.wheels_ahead_m &&
        std::abs(top.p_E.y() - p_EC.y()) > settings.wheels_aside_m) {
      continue;
    }
    const bool part = std::any_of(stones.begin(), stones.end(), [&](const FieldStone& stone) {
      const double away_m = (stone.p - top.p_E).norm();
      const bool low = top.top_m < kSmear * stone.height_m;
      return away_m < settings.one_stone_m || (low && away_m < kSmears * settings.one_stone_m);
    });
    if (part) continue;
    const double r = (top.p_E - p_EC.head<2>()).norm();
    const double sigmas = top.top_m / std::max(kUp_m + kUpAt1_m * r * r, ground.sigma_m);
    // Up a pixel's ray by a height is towards the cameras by its share of theirs; they look down by
    // about 45 deg.
    const double depth_m = std::sqrt(0.5) * (r + p_EC.z());
    const double px = settings.focal_baseline_px_m * top.top_m / (depth_m * p_EC.z());
    const double real =
        std::min((sigmas - kNoise) / (kReal - kNoise), (px - kNoise_px) / (kReal_px - kNoise_px));
    stones.push_back({top.p_E, SpreadAt(top.p_E, p_EC), top.top_m,
                      kHeight_m + kHeightAt1_m * r * r + kHeightShare * top.top_m,
                      ground.Height(top.p_E), std::clamp(real, kLeastReal, kMostReal)});
  }
  return stones;
}

FieldMatch MatchField(const std::vector<FieldStone>& remembered,
                      const std::vector<FieldStone>& seen, const Matrix2d& shift_spread_m2,
                      const FieldSettings& settings) {
  // In a noisy map there is more to be taken for a stone.
  FieldSettings with = settings;
  with.clutter_m2 =
      std::max(settings.clutter_m2,
               static_cast<double>(seen.size()) / (kPi * settings.radius_m * settings.radius_m));
  std::vector<FieldMatch> ways;
  FieldMatch none{.spread_m2 = shift_spread_m2, .seen = std::vector<int>(remembered.size(), -1)};
  for (const FieldStone& stone : remembered) none.odds += Missed(stone, with);
  ways.push_back(none);
  for (std::size_t i = 0; i < remembered.size(); ++i) {
    for (std::size_t j = 0; j < seen.size(); ++j) {
      if (Gain(remembered[i], seen[j], none, with) < Missed(remembered[i], with)) continue;
      ways.push_back(MatchFrom(i, j, remembered, seen, shift_spread_m2, with));
    }
  }
  FieldMatch best = *std::max_element(ways.begin(), ways.end(),
                                      [](const auto& a, const auto& b) { return a.odds < b.odds; });
  const Vector2d target = TargetOf(best, remembered, seen);
  double rival = -std::numeric_limits<double>::infinity();
  for (const FieldMatch& other : ways) {
    const bool same = (other.seen.front() >= 0) == (best.seen.front() >= 0) &&
                      (TargetOf(other, remembered, seen) - target).norm() < with.apart_m;
    if (!same) rival = std::max(rival, other.odds);
  }
  best.odds -= rival;
  return best;
}

}  // namespace dockyard
