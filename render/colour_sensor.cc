#include "render/colour_sensor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "controller/base/check.h"
#include "controller/base/two_widths.h"
#include "render/optics.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

// Of 8 bits, the curve's steepest part takes 13 levels a step of 1/255: finer linear steps than
// these would not show.
constexpr int kCurveSteps = 8192;
// A sum of Poisson and normal numbers that is less skew than this is drawn as normal.
constexpr float kLeastSkew = 0.14f;
constexpr double kDarkest = 1e-9;  // radiance

void RequireSound(const ColourSensorOptions& o) {
  if (!(o.blur_sigma_px >= 0.0 && o.blur_sigma_px <= 1.5)) {
    throw std::invalid_argument("colour sensor: blur must lie in 0 to 1.5 px");
  }
  DOCKYARD_CHECK(o.full_well_e > 0.0 && std::isfinite(o.full_well_e));
  DOCKYARD_CHECK(o.read_noise_e >= 0.0 && std::isfinite(o.read_noise_e));
  DOCKYARD_CHECK(o.target_level > 0.0 && o.target_level <= 1.0);
  DOCKYARD_CHECK(o.exposure_lag_s >= 0.0 && o.balance_lag_s >= 0.0);
  DOCKYARD_CHECK(o.fixed_exposure_e >= 0.0 && o.most_exposure_e > 0.0);
  DOCKYARD_CHECK(o.most_balance >= 1.0);
  DOCKYARD_CHECK(o.balance.allFinite() && o.balance.minCoeff() > 0.0);
}

// Means of red, green and blue over the part that the hole leaves.
Eigen::Vector3d MeanLight(const ColourRadiance& light) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t lit = 0;
  for (std::size_t i = 0; i < light.part[1].values.size(); ++i) {
    if (light.part[1].values[i] <= 0.0f) continue;
    ++lit;
    for (int c = 0; c < 3; ++c) sum[c] += light.part[c].values[i];
  }
  return lit == 0 ? sum : sum / static_cast<double>(lit);
}

double Toward(double from, double to, double since_s, double lag_s) {
  const double share = lag_s > 0.0 ? 1.0 - std::exp(-since_s / lag_s) : 1.0;
  return from * std::pow(to / from, share);
}

// Where exposure and balance want to be for a picture with these means.
ColourSensorState Settled(const Eigen::Vector3d& mean, const ColourSensorOptions& o) {
  ColourSensorState wanted{.exposure_e = o.fixed_exposure_e, .balance = o.balance};
  if (o.fixed_exposure_e == 0.0) {
    wanted.exposure_e =
        std::min(o.target_level * o.full_well_e / std::max(mean.y(), kDarkest), o.most_exposure_e);
  }
  if (o.auto_balance && mean.minCoeff() > kDarkest) {
    for (int c = 0; c < 3; ++c) {
      wanted.balance[c] = std::clamp(mean.y() / mean[c], 1.0 / o.most_balance, o.most_balance);
    }
  }
  return wanted;
}

// Whether Poisson and read noise together are too skew for a normal law: skewness e / s^3, where
// s^2 = e + r^2 is the variance. It is largest at e = 2 r^2.
bool TooSkew(float electrons, float read_variance) {
  const float variance = electrons + read_variance;
  return electrons > kLeastSkew * variance * std::sqrt(variance);
}

using Row = std::array<std::vector<float>, 3>;

// From light to shares of the full well, with noise; first: place of the row's first pixel.
DOCKYARD_TWO_WIDTHS
void ReadRow(float gain_e, const ColourSensorOptions& o, std::uint64_t key, std::size_t first,
             Row& row) {
  const auto read = static_cast<float>(o.read_noise_e), read_variance = read * read;
  const auto per_well = static_cast<float>(1.0 / o.full_well_e);
  const bool may_be_skew = TooSkew(2.0f * read_variance, read_variance) || read == 0.0f;
  const std::size_t count = row[0].size();
  float *r = row[0].data(), *g = row[1].data(), *b = row[2].data();
  const auto noisy = [&](float light, float normal) {
    const float electrons = gain_e * light;
    return electrons + std::sqrt(electrons + read_variance) * normal;
  };
  const auto cut = [&](float electrons) {
    return std::min(std::max(electrons * per_well, 0.0f), 1.0f);
  };
  if (may_be_skew) {
    for (int c = 0; c < 3; ++c) {
      const std::uint64_t own = SplitMix(key, static_cast<std::uint64_t>(c));
      for (std::size_t x = 0; x < count; ++x) {
        const float electrons = gain_e * row[c][x], normal = HashNormal(own, first + x);
        row[c][x] = cut(TooSkew(electrons, read_variance)
                            ? DrawPoisson(electrons, own, first + x) + read * normal
                            : noisy(row[c][x], normal));
      }
    }
    return;
  }
  for (std::size_t x = 0; x < count; ++x) {
    const ThreeNormals n = HashNormals(key, first + x);
    r[x] = cut(noisy(r[x], n.a));
    g[x] = cut(noisy(g[x], n.b));
    b[x] = cut(noisy(b[x], n.c));
  }
}

// 0 to 255 of linear 0 to 1.
std::vector<float> TransferCurve(bool gamma) {
  std::vector<float> curve;
  for (int i = 0; i <= kCurveSteps; ++i) {
    const double v = static_cast<double>(i) / kCurveSteps;
    const double coded = !gamma           ? v
                         : v <= 0.0031308 ? 12.92 * v
                                          : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
    curve.push_back(static_cast<float>(255.0 * coded));
  }
  return curve;
}

const std::vector<float>& CurveOf(bool gamma) {
  static const std::vector<float> straight = TransferCurve(false), bent = TransferCurve(true);
  return gamma ? bent : straight;
}

void Develop(const Eigen::Vector3d& balance, const std::vector<float>& curve, Row& row) {
  const float* levels = curve.data();
  for (int c = 0; c < 3; ++c) {
    const auto gain = static_cast<float>(balance[c]) * kCurveSteps;
    for (float& value : row[c]) {
      value = levels[static_cast<int>(std::min(value * gain + 0.5f, float{kCurveSteps}))];
    }
  }
}

// Brightness of each pixel, colour of each pair: differences from the brightness (ITU-R BT.601)
// are averaged.
void HalveColour(Row& row) {
  float *red = row[0].data(), *green = row[1].data(), *blue = row[2].data();
  for (std::size_t x = 0; x + 1 < row[0].size(); x += 2) {
    const float a = 0.299f * red[x] + 0.587f * green[x] + 0.114f * blue[x];
    const float b = 0.299f * red[x + 1] + 0.587f * green[x + 1] + 0.114f * blue[x + 1];
    const float to_red = 0.5f * ((red[x] - a) + (red[x + 1] - b));
    const float to_blue = 0.5f * ((blue[x] - a) + (blue[x + 1] - b));
    const float to_green = -(0.299f * to_red + 0.114f * to_blue) * (1.0f / 0.587f);
    red[x] = a + to_red;
    red[x + 1] = b + to_red;
    green[x] = a + to_green;
    green[x + 1] = b + to_green;
    blue[x] = a + to_blue;
    blue[x + 1] = b + to_blue;
  }
}

void Interleave(const Row& row, std::uint8_t* __restrict out) {
  const float *r = row[0].data(), *g = row[1].data(), *b = row[2].data();
  const auto byte = [](float level) {
    return static_cast<std::uint8_t>(
        static_cast<int>(std::min(std::max(level + 0.5f, 0.0f), 255.0f)));
  };
  const std::size_t count = row[0].size();
  for (std::size_t x = 0; x < count; ++x) {
    out[3 * x] = byte(r[x]);
    out[3 * x + 1] = byte(g[x]);
    out[3 * x + 2] = byte(b[x]);
  }
}

}  // namespace

RgbImage ExposeColourView(const ColourRadiance& light, const ColourSensorOptions& options,
                          double since_s, std::uint64_t key, ColourSensorState& state) {
  RequireSound(options);
  const ColourSensorState wanted = Settled(MeanLight(light), options);
  if (state.exposure_e <= 0.0) state = wanted;
  if (options.fixed_exposure_e > 0.0) state.exposure_e = wanted.exposure_e;
  if (!options.auto_balance) state.balance = wanted.balance;
  const ColourSensorState now = state;
  std::array<RadianceImage, 3> part = light.part;
  for (RadianceImage& channel : part) Blur(options.blur_sigma_px, channel);
  RgbImage picture{.width = light.width, .height = light.height, .pixels = {}};
  picture.pixels.resize(3 * static_cast<std::size_t>(light.width) * light.height);
  const std::vector<float>& curve = CurveOf(options.gamma);
  Row row;
  for (std::vector<float>& channel : row) channel.resize(static_cast<std::size_t>(light.width));
  std::uint8_t* out = picture.pixels.data();
  for (int y = 0; y < light.height; ++y) {
    const int line = y - light.y0;
    for (int c = 0; c < 3; ++c) {
      std::fill(row[c].begin(), row[c].end(), 0.0f);
      if (line < 0 || line >= part[c].height) continue;
      const float* from = &part[c].values[static_cast<std::size_t>(line) * part[c].width];
      std::copy(from, from + part[c].width, row[c].begin() + light.x0);
    }
    ReadRow(static_cast<float>(now.exposure_e), options, key,
            static_cast<std::size_t>(y) * light.width, row);
    Develop(now.balance, curve, row);
    if (options.halve_colour) HalveColour(row);
    Interleave(row, out);
    out += 3 * static_cast<std::size_t>(light.width);
  }
  state.exposure_e = Toward(now.exposure_e, wanted.exposure_e, since_s, options.exposure_lag_s);
  for (int c = 0; c < 3; ++c) {
    state.balance[c] = Toward(now.balance[c], wanted.balance[c], since_s, options.balance_lag_s);
  }
  return picture;
}

}  // namespace dockyard
