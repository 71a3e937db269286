#include "controller/raposa/colour_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "controller/base/median.h"

namespace dockyard::raposa {
namespace {

// Linear light of the read noise, so that dark pixels have no colour. Assumed, 0.004-0.01.
constexpr float kDark = 0.007f;
// Paint is so much redder, or bluer, than all but a few hundredths of the view. Orange paint that
// fills half a pixel is redder than grey floor by 1.0, blue that fills 0.4 of it bluer by 0.7
// (the paints of render/spectrum.cc). Assumed, 0.3-0.6 and 0.2-0.5.
constexpr float kRedder = 0.45f, kBluer = 0.35f;
// A guide beyond 3 m is no wider than the blur, and stands out by less. Assumed, 0.15-0.35.
constexpr float kFaintRedder = 0.15f;
// Shares of the view that are redder and bluer than its ground and sky. The guide fills a sixth at
// 0.2 m. Assumed, 0.18-0.3 and 0.1-0.2.
constexpr double kRedShare = 0.22, kBlueShare = 0.15;
// Of the hole, left out, and in which a spot is cut by it, at kLimitsFocal_px. Assumed, 1-4, 4-6.
constexpr double kRim_px = 2.0, kCut_px = 5.0;
// A rim as built lies so near to where it is told, at kLimitsFocal_px, of a hole of 84 px; it is
// looked for by rings of a pixel. Assumed, 5-8 px.
constexpr double kRimSearch_px = 6.0;
constexpr int kLeastPairs = 2;          // assumed, 2-4
constexpr double kLeastStrength = 1.2;  // noise of dark grass makes spots of 1 to 1.3; assumed, 1-2
constexpr double kFaintStrength = 0.3;  // such a spot counts with its blue alone; assumed, 0.3-0.6

// An orange region is ground in warmer light, such as the shade of a sun that is bluer than the
// sky, where it is larger than this and longer, or emptier, than a guide: that is 1.7 times as long
// as wide and fills 0.7 of its box. Assumed, 30-100 pairs at kLimitsFocal_px, 2-3, 0.35-0.5.
constexpr double kGroundPairs = 50.0;
constexpr double kGroundLonger = 2.5, kGroundFill = 0.4;

float RedBlue(const Eigen::Vector3f& c) { return std::log((c[0] + kDark) / (c[2] + kDark)); }

/// The pairs of one tint that touch each other, from one of them; marks them as taken.
struct Region {
  std::vector<Eigen::Vector2i> pairs;
};
Region Grow(const TintMap& map, int i0, int j0, std::vector<std::uint8_t>* taken) {
  Region region{{{i0, j0}}};
  (*taken)[map.Index(i0, j0)] = 1;
  for (std::size_t next = 0; next < region.pairs.size(); ++next) {
    const Eigen::Vector2i at = region.pairs[next];
    for (int j = std::max(0, at.y() - 1); j <= std::min(map.light.height - 1, at.y() + 1); ++j) {
      for (int i = std::max(0, at.x() - 1); i <= std::min(map.light.width - 1, at.x() + 1); ++i) {
        const std::size_t k = map.Index(i, j);
        if ((*taken)[k] || map.tints[k] != Tint::kOrange) continue;
        (*taken)[k] = 1;
        region.pairs.emplace_back(i, j);
      }
    }
  }
  return region;
}

bool IsGround(const Region& region, double finer) {
  if (static_cast<double>(region.pairs.size()) < kGroundPairs * finer * finer) return false;
  Eigen::Vector2i low = region.pairs.front(), high = low;
  for (const Eigen::Vector2i& at : region.pairs) {
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  const double wide_px = 2.0 * (high.x() - low.x() + 1), tall_px = high.y() - low.y() + 1;
  const double area_px2 = 2.0 * static_cast<double>(region.pairs.size());
  return std::max(wide_px, tall_px) > kGroundLonger * std::min(wide_px, tall_px) ||
         area_px2 < kGroundFill * wide_px * tall_px;
}

/// Within ground in warmer light orange is what is redder than that.
void LeaveWarmGround(TintMap* map, float redder_by) {
  std::vector<std::uint8_t> taken(map->tints.size(), 0);
  for (int j = 0; j < map->light.height; ++j) {
    for (int i = 0; i < map->light.width; ++i) {
      const std::size_t k = map->Index(i, j);
      if (map->tints[k] != Tint::kOrange || taken[k]) continue;
      const Region region = Grow(*map, i, j, &taken);
      if (!IsGround(region, map->finer)) continue;
      std::vector<float> values;
      for (const Eigen::Vector2i& at : region.pairs) {
        values.push_back(map->red_blue[map->Index(at.x(), at.y())]);
      }
      const float redder = Median(std::move(values)) + redder_by;
      for (const Eigen::Vector2i& at : region.pairs) {
        const std::size_t n = map->Index(at.x(), at.y());
        if (map->red_blue[n] <= redder) map->tints[n] = Tint::kPlain;
      }
    }
  }
}

/// Its area, as if sharp: the sum of the orange over what a whole pixel of it would have. A small
/// disc's peak is 1 - exp(-r^2 / 2 sigma^2) of that.
double SharpArea(double sum, double peak) {
  double area = sum / peak;
  for (int i = 0; i < 20; ++i) {
    const double radius2 = area / kPi;
    area = sum / peak * (1.0 - std::exp(-0.5 * radius2 / (kImageBlur_px * kImageBlur_px)));
    area = std::max(area, 1.0);
  }
  return area;
}

std::optional<OrangeSpot> SpotOf(const TintMap& map, const Region& region, float level) {
  if (static_cast<int>(region.pairs.size()) < kLeastPairs) return std::nullopt;
  OrangeSpot spot{.left = 1 << 20, .right = -1, .top = 1 << 20, .bottom = -1};
  for (const Eigen::Vector2i& at : region.pairs) {
    spot.left = std::min(spot.left, at.x());
    spot.right = std::max(spot.right, at.x());
    spot.top = std::min(spot.top, at.y());
    spot.bottom = std::max(spot.bottom, at.y());
    spot.strength += map.red_blue[map.Index(at.x(), at.y())] - level;
    spot.clipped = spot.clipped || map.Inside(at.x(), at.y()) < kCut_px * map.finer;
  }
  if (spot.strength < (map.spots == Spots::kFaint ? kFaintStrength : kLeastStrength))
    return std::nullopt;
  const auto ground = GroundAbout(map, spot.left, spot.right, spot.top, spot.bottom);
  if (!ground) return std::nullopt;
  double sum = 0.0, sum_u = 0.0, sum_v = 0.0;
  std::vector<float> core;
  const int margin = 2;
  for (int j = std::max(0, spot.top - margin);
       j <= std::min(map.light.height - 1, spot.bottom + margin); ++j) {
    for (int i = std::max(0, spot.left - 1); i <= std::min(map.light.width - 1, spot.right + 1);
         ++i) {
      if (map.tints[map.Index(i, j)] == Tint::kUnseen) continue;
      const Eigen::Vector3f& c = map.light.At(i, j);
      const double orange = (c[0] - ground->red_green * c[1]) - (c[2] - ground->blue_green * c[1]);
      const bool in = map.tints[map.Index(i, j)] == Tint::kOrange;
      if (in) core.push_back(static_cast<float>(orange));
      if (!in && orange <= 0.0) continue;
      const double weight = std::max(orange, 0.0);
      sum += weight;
      sum_u += weight * (2.0 * i + 0.5);
      sum_v += weight * j;
    }
  }
  if (!(sum > 0.0)) return std::nullopt;
  std::ranges::sort(core);
  // A large guide is lit unevenly; of a small one only the middle is all orange.
  const double peak =
      core[core.size() - 1 - (core.size() > 20 ? core.size() * 2 / 5 : core.size() / 8)];
  if (!(peak > 0.0)) return std::nullopt;
  spot.centre_px = {sum_u / sum, sum_v / sum};
  spot.area_px2 = SharpArea(2.0 * sum, peak);
  return spot;
}

/// Radius at which the view is half as bright as a little further in: its rim, seen. The told one
/// where the picture shows none.
double RimOf(const PairImage& light, const Eigen::Vector2d& middle_px, double told_px,
             double finer) {
  constexpr int kInner = 4;
  const double search_px = std::round(kRimSearch_px * finer);
  const double from_px = told_px - search_px - kInner;
  const auto rings = static_cast<std::size_t>(2.0 * search_px) + kInner + 1;
  std::vector<double> sum(rings, 0.0), count(rings, 0.0);
  for (int j = 0; j < light.height; ++j) {
    for (int i = 0; i < light.width; ++i) {
      const double r_px = (Eigen::Vector2d(2.0 * i + 0.5, j) - middle_px).norm();
      const double ring = std::floor(r_px - from_px);
      if (ring < 0.0 || ring >= static_cast<double>(rings)) continue;
      sum[static_cast<std::size_t>(ring)] += light.At(i, j)[1];
      count[static_cast<std::size_t>(ring)] += 1.0;
    }
  }
  double inner = 0.0;
  for (std::size_t k = 0; k < kInner; ++k) {
    if (count[k] == 0.0) return told_px;
    inner += sum[k] / count[k] / kInner;
  }
  double before = inner;
  for (std::size_t k = kInner; k < rings && count[k] > 0.0; ++k) {
    const double now = sum[k] / count[k];
    if (now < 0.5 * inner) {
      const double share = (before - 0.5 * inner) / std::max(before - now, 1e-12);
      return from_px + static_cast<double>(k) - 0.5 + share;
    }
    before = now;
  }
  return told_px;
}

}  // namespace

double TintMap::Inside(int i, int j) const {
  return hole_px - (Eigen::Vector2d(2.0 * i + 0.5, j) - middle_px).norm();
}

TintMap TintsOf(const RgbImage& image, const Nominal& nominal, Spots spots) {
  TintMap map;
  map.spots = spots;
  map.light = ToLinearPairs(image);
  map.middle_px = nominal.camera.centre_px();
  map.finer = nominal.camera.focal_px().x() / kLimitsFocal_px;
  map.hole_px = RimOf(map.light, map.middle_px,
                      nominal.camera.focal_px().x() * std::tan(nominal.half_view_rad), map.finer);
  map.red_blue.assign(map.light.pairs.size(), 0.0f);
  map.tints.assign(map.light.pairs.size(), Tint::kUnseen);
  std::vector<float> seen;
  for (int j = 1; j + 1 < map.light.height; ++j) {
    for (int i = 0; i < map.light.width; ++i) {
      if (map.Inside(i, j) < kRim_px * map.finer) continue;
      const std::size_t k = map.Index(i, j);
      map.red_blue[k] = RedBlue(0.25f * (map.light.At(i, j - 1) + map.light.At(i, j + 1)) +
                                0.5f * map.light.At(i, j));
      map.tints[k] = Tint::kPlain;
      seen.push_back(map.red_blue[k]);
    }
  }
  if (seen.empty()) return map;
  const auto share = [&](double s) {
    const auto at =
        seen.begin() + static_cast<std::ptrdiff_t>(s * static_cast<double>(seen.size() - 1));
    std::nth_element(seen.begin(), at, seen.end());
    return *at;
  };
  const float redder_by = spots == Spots::kFaint ? kFaintRedder : kRedder;
  const float redder = share(1.0 - kRedShare) + redder_by, bluer = share(kBlueShare) - kBluer;
  for (std::size_t k = 0; k < map.tints.size(); ++k) {
    if (map.tints[k] == Tint::kUnseen) continue;
    if (map.red_blue[k] > redder) map.tints[k] = Tint::kOrange;
    if (map.red_blue[k] < bluer) map.tints[k] = Tint::kBlue;
  }
  LeaveWarmGround(&map, redder_by);
  return map;
}

std::vector<OrangeSpot> OrangeSpots(const TintMap& map, std::size_t most) {
  std::vector<OrangeSpot> spots;
  std::vector<std::uint8_t> taken(map.tints.size(), 0);
  float level = 0.0f;
  {
    std::vector<float> plain;
    for (std::size_t k = 0; k < map.tints.size(); ++k) {
      if (map.tints[k] == Tint::kPlain) plain.push_back(map.red_blue[k]);
    }
    if (plain.empty()) return {};
    level = Median(std::move(plain));
  }
  for (int j = 0; j < map.light.height; ++j) {
    for (int i = 0; i < map.light.width; ++i) {
      const std::size_t k = map.Index(i, j);
      if (map.tints[k] != Tint::kOrange || taken[k]) continue;
      if (auto spot = SpotOf(map, Grow(map, i, j, &taken), level)) spots.push_back(*spot);
    }
  }
  std::ranges::stable_sort(
      spots, [](const OrangeSpot& a, const OrangeSpot& b) { return a.strength > b.strength; });
  if (spots.size() > most) spots.resize(most);
  return spots;
}

std::optional<GroundColour> GroundAbout(const TintMap& map, int left, int right, int top,
                                        int bottom) {
  const int margin = 6 + (bottom - top) / 2;
  std::vector<float> red, blue, green;
  for (int j = std::max(0, (top + bottom) / 2);
       j <= std::min(map.light.height - 1, bottom + margin); ++j) {
    for (int i = std::max(0, left - margin); i <= std::min(map.light.width - 1, right + margin);
         ++i) {
      // A margin to the marks, whose blur is in their neighbours.
      const bool about = i < left - 2 || i > right + 2 || j > bottom + 2;
      if (!about || map.tints[map.Index(i, j)] != Tint::kPlain) continue;
      const Eigen::Vector3f& c = map.light.At(i, j);
      red.push_back(c[0]);
      green.push_back(c[1]);
      blue.push_back(c[2]);
    }
  }
  if (red.size() < 12) return std::nullopt;
  GroundColour ground;
  ground.green = std::max(Median(std::move(green)), 1e-4f);
  ground.red_green = Median(std::move(red)) / ground.green;
  ground.blue_green = Median(std::move(blue)) / ground.green;
  return ground;
}

}  // namespace dockyard::raposa
