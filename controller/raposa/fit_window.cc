#include "controller/raposa/fit_window.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "controller/base/median.h"

namespace dockyard::raposa {
namespace {

// From the hole's rim, inwards: half the width of its shade [px], at kLimitsFocal_px. The pupil's
// diameter over the hole's distance; assumed, 2-6.
constexpr double kShade_px = 4.5;
// Sky and ground differ by this in ln green. Assumed, 0.2-0.5.
constexpr double kHorizonStep = 0.3;
constexpr double kLeastNoise = 0.01;   // of the two values, for even ground; assumed, 0.005-0.02
constexpr double kSkyClosed_px = 1.0;  // below the horizon

/// Row of the strongest step of brightness from dark below to bright above, or the other way, in
/// the columns of the window.
std::optional<double> HorizonIn(const TintMap& map, const PixelRect& rect, double lowest_px) {
  const int i0 = std::max(0, static_cast<int>(rect.left) / 2 - 5);
  const int i1 = std::min(map.light.width - 1, static_cast<int>(rect.right) / 2 + 5);
  const int j0 = std::max(1, static_cast<int>(rect.top) - 8);
  const int j1 = std::min(map.light.height - 2, static_cast<int>(lowest_px) + 3);
  std::vector<double> level;  // of ln green, by rows
  for (int j = j0; j <= j1; ++j) {
    std::vector<double> row;
    for (int i = i0; i <= i1; ++i) {
      if (map.tints[map.Index(i, j)] == Tint::kPlain && map.Inside(i, j) > kShade_px * map.finer) {
        row.push_back(std::log(map.light.At(i, j)[1] + 1e-3));
      }
    }
    if (row.size() < 4) {
      level.push_back(level.empty() ? std::nan("") : level.back());
    } else {
      level.push_back(Median(row));
    }
  }
  double best = kHorizonStep, at = -1.0;
  for (std::size_t k = 0; k + 4 < level.size(); ++k) {
    const double step = std::abs(level[k] - level[k + 4]);
    if (std::isnan(step) || step <= best) continue;
    best = step;
    // Where half of the light's step is reached, between the rows.
    const double half = 0.5 * (std::exp(level[k]) + std::exp(level[k + 4]));
    for (std::size_t m = k; m < k + 4; ++m) {
      const double a = std::exp(level[m]), b = std::exp(level[m + 1]);
      if ((a - half) * (b - half) <= 0.0 && a != b) {
        at = j0 + static_cast<double>(m) + (a - half) / (a - b);
      }
    }
  }
  if (at < 0.0 || at > lowest_px) return std::nullopt;
  return at;
}

Eigen::Vector2d ValuesOf(const Eigen::Vector3d& light, const GroundColour& ground) {
  return Eigen::Vector2d(light[0] - ground.red_green * light[1],
                         light[2] - ground.blue_green * light[1]) /
         ground.green;
}

/// The inverse root of the ground's covariance, of cells of this window's size.
std::optional<Eigen::Matrix2d> Whitener(const std::vector<Eigen::Vector2d>& ground) {
  if (ground.size() < 8) return std::nullopt;
  Eigen::Vector2d middle, spread;
  for (int c = 0; c < 2; ++c) {
    std::vector<double> values;
    for (const Eigen::Vector2d& v : ground) values.push_back(v[c]);
    middle[c] = Median(values);
    for (double& v : values) v = std::abs(v - middle[c]);
    spread[c] = std::max(1.4826 * Median(values), kLeastNoise);
  }
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  int count = 0;
  for (const Eigen::Vector2d& v : ground) {
    const Eigen::Vector2d off = v - middle;
    if (off.cwiseQuotient(spread).cwiseAbs().maxCoeff() > 3.0) continue;
    sum += off * off.transpose();
    ++count;
  }
  if (count < 6) return std::nullopt;
  Eigen::Matrix2d covariance = sum / count;
  covariance.diagonal().array() += kLeastNoise * kLeastNoise;
  const Eigen::Matrix2d lower = covariance.llt().matrixL();
  return Eigen::Matrix2d(lower.inverse());
}

}  // namespace

std::optional<FitWindow> WindowOn(const TintMap& map, const GroundColour& ground,
                                  const PixelRect& rect, int most_cells, double lowest_horizon_px) {
  FitWindow window;
  window.ground = ground;
  const int left = std::max(0, static_cast<int>(std::floor(rect.left)));
  const int top = std::max(0, static_cast<int>(std::floor(rect.top)));
  const int right = std::min(2 * map.light.width, static_cast<int>(std::ceil(rect.right)) + 1);
  const int bottom = std::min(map.light.height, static_cast<int>(std::ceil(rect.bottom)) + 1);
  if (right - left < 4 || bottom - top < 3) return std::nullopt;
  const double area = static_cast<double>(right - left) * (bottom - top);
  window.unit_px = area <= 2.0 * most_cells    ? 1
                   : area <= 4.0 * most_cells  ? 2
                   : area <= 16.0 * most_cells ? 4
                                               : 8;
  const int across = window.across_px(), down = window.unit_px;
  window.x0_px = left - left % 2;
  window.y0_px = top;
  window.columns = (right - window.x0_px) / across;
  window.rows = (bottom - top) / down;
  if (window.columns < 2 || window.rows < 2) return std::nullopt;
  const std::optional<double> horizon = HorizonIn(map, rect, lowest_horizon_px);
  std::vector<Eigen::Vector2d> values, plain;
  for (int j = 0; j < window.rows; ++j) {
    for (int i = 0; i < window.columns; ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      bool seen = true, ground_only = true, blue = false;
      for (int v = 0; v < down; ++v) {
        for (int u = 0; u < across / 2; ++u) {
          const int pair = window.x0_px / 2 + i * across / 2 + u, row = top + j * down + v;
          sum += map.light.At(pair, row).cast<double>();
          seen = seen && map.Inside(pair, row) > kShade_px * map.finer;
          const Tint tint = map.tints[map.Index(pair, row)];
          ground_only = ground_only && tint == Tint::kPlain;
          blue = blue || tint == Tint::kBlue;
        }
      }
      values.push_back(ValuesOf(sum / (down * across / 2), ground));
      const double middle_px = top + (j + 0.5) * down - 0.5;
      const double above =
          horizon ? 0.5 * std::erfc((middle_px - *horizon) / (std::sqrt(2.0) * kImageBlur_px))
                  : 0.0;
      const bool open = seen && (!horizon || middle_px > *horizon + kSkyClosed_px);
      window.blue.push_back(blue ? 1 : 0);
      window.open.push_back(open ? 1.0f : 0.0f);
      window.sky.push_back(static_cast<float>(above));
      if (open && ground_only && above < 1e-3) plain.push_back(values.back());
    }
  }
  const auto whiten = Whitener(plain);
  if (!whiten) return std::nullopt;
  window.whiten = whiten->cast<float>();
  for (const Eigen::Vector2d& v : values) window.seen.emplace_back((*whiten * v).cast<float>());
  return window;
}

}  // namespace dockyard::raposa
