#include "render/soil_texture.h"

#include <algorithm>
#include <cmath>

#include "render/pixel_noise.h"

namespace dockyard {
namespace {

constexpr double kTexel_m = kSoilTile_m / kSoilSide;

// The appearance, all assumed: a raked yard of sand with some gravel.
constexpr int kPebbles = 2600;
constexpr double kPebbleMin_m = 0.0025, kPebbleMax_m = 0.022;
constexpr double kPebbleSlopeLimit = 1.2;

struct Field {
  std::vector<float> height_m = std::vector<float>(kSoilSide * kSoilSide, 0.0f);
  std::vector<float> tone = std::vector<float>(kSoilSide * kSoilSide, 0.0f);
};

int Wrap(int i) { return (i % kSoilSide + kSoilSide) % kSoilSide; }

float Fade(float t) { return t * t * (3.0f - 2.0f * t); }

// Adds smooth value noise with `cells` knots a side, periodic over the tile.
void AddOctave(std::vector<float>& plane, std::uint64_t key, int cells, float amplitude) {
  const int step = kSoilSide / cells;
  const auto knot = [&](int ix, int iy) {
    const auto at = static_cast<std::uint64_t>((iy % cells) * cells + ix % cells);
    return static_cast<float>(2.0 * HashUniform(key, at) - 1.0);
  };
  for (int cy = 0; cy < cells; ++cy) {
    for (int cx = 0; cx < cells; ++cx) {
      const float k00 = knot(cx, cy), k10 = knot(cx + 1, cy);
      const float k01 = knot(cx, cy + 1), k11 = knot(cx + 1, cy + 1);
      for (int y = 0; y < step; ++y) {
        const float v = Fade(static_cast<float>(y) / step);
        const float left = k00 + v * (k01 - k00), right = k10 + v * (k11 - k10);
        float* row = &plane[(cy * step + y) * kSoilSide + cx * step];
        for (int x = 0; x < step; ++x) {
          row[x] += amplitude * (left + Fade(static_cast<float>(x) / step) * (right - left));
        }
      }
    }
  }
}

// A half-buried flattened stone; where stones overlap the higher one shows.
void AddPebble(Field& field, std::uint64_t key, int index, double largest_m) {
  const auto uniform = [&](int k) { return HashUniform(key, 8u * index + k); };
  // Sizes fall as a power of -1.9, so that small ones abound as on real gravel fans.
  const double ratio = kPebbleMax_m / kPebbleMin_m;
  const double exponent = -0.9;
  const double radius_m =
      kPebbleMin_m * std::pow(1.0 + uniform(0) * (std::pow(ratio, exponent) - 1.0), 1.0 / exponent);
  const double stretch = 1.0 + 0.7 * uniform(1), angle = 3.14159265 * uniform(2);
  if (radius_m * stretch > largest_m) return;
  const double c = std::cos(angle), s = std::sin(angle);
  const double x0 = kSoilSide * uniform(3), y0 = kSoilSide * uniform(4);
  const double top_m = radius_m * (0.35 + 0.35 * uniform(5));
  const double tone = 0.45 * (uniform(6) - 0.55);
  const int reach = static_cast<int>(std::ceil(radius_m * stretch / kTexel_m));
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double px = (std::floor(x0) + dx - x0) * kTexel_m;
      const double py = (std::floor(y0) + dy - y0) * kTexel_m;
      const double a = (c * px + s * py) / (radius_m * stretch);
      const double b = (c * py - s * px) / radius_m;
      const double inside = 1.0 - a * a - b * b;
      if (inside <= 0.0) continue;
      const int at = Wrap(static_cast<int>(y0) + dy) * kSoilSide + Wrap(static_cast<int>(x0) + dx);
      const auto height = static_cast<float>(top_m * std::sqrt(inside));
      if (height <= field.height_m[at]) continue;
      field.height_m[at] = height;
      field.tone[at] = static_cast<float>(tone);
    }
  }
}

std::uint8_t Byte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(128.0 + 127.0 * value), 0l, 255l));
}

Field MakeField(std::uint64_t seed, double largest_pebble_m) {
  Field field;
  const auto key = [&](std::uint64_t k) { return MixBits(seed * 64 + k); };
  AddOctave(field.height_m, key(0), 8, 0.006f);
  AddOctave(field.height_m, key(1), 16, 0.005f);
  AddOctave(field.height_m, key(2), 64, 0.0016f);
  AddOctave(field.height_m, key(3), 128, 0.0010f);
  AddOctave(field.height_m, key(4), 256, 0.0005f);
  AddOctave(field.tone, key(5), 8, 0.07f);
  AddOctave(field.tone, key(6), 32, 0.06f);
  AddOctave(field.tone, key(7), 256, 0.10f);
  AddOctave(field.tone, key(8), 512, 0.12f);
  for (int i = 0; i < kPebbles; ++i) AddPebble(field, key(9), i, largest_pebble_m);
  return field;
}

}  // namespace

std::vector<std::uint8_t> SoilTexture(std::uint64_t seed, double largest_pebble_m) {
  if (seed == 0) return std::vector<std::uint8_t>(4u * kSoilSide * kSoilSide, 128);
  const Field field = MakeField(seed, largest_pebble_m);
  std::vector<std::uint8_t> texels(4u * kSoilSide * kSoilSide);
  const auto height = [&](int x, int y) { return field.height_m[Wrap(y) * kSoilSide + Wrap(x)]; };
  const auto slope = [](double rise_m) {
    return std::clamp(rise_m / (2.0 * kTexel_m), -kPebbleSlopeLimit, kPebbleSlopeLimit) /
           kSoilSlopeFull;
  };
  for (int y = 0; y < kSoilSide; ++y) {
    for (int x = 0; x < kSoilSide; ++x) {
      std::uint8_t* texel = &texels[4u * (y * kSoilSide + x)];
      texel[0] = Byte(field.tone[y * kSoilSide + x]);
      texel[1] = Byte(slope(height(x + 1, y) - height(x - 1, y)));
      texel[2] = Byte(slope(height(x, y + 1) - height(x, y - 1)));
      texel[3] = Byte(height(x, y) / 0.03);
    }
  }
  return texels;
}

std::vector<std::uint8_t> SoilLumps(const std::vector<std::uint8_t>& soil) {
  constexpr int kStep = kSoilSide / kLumpSide;
  std::vector<std::uint8_t> lumps(4u * kLumpSide * kLumpSide);
  for (int y = 0; y < kLumpSide; ++y) {
    for (int x = 0; x < kLumpSide; ++x) {
      for (int channel = 0; channel < 4; ++channel) {
        int sum = 0;
        for (int dy = 0; dy < kStep; ++dy) {
          for (int dx = 0; dx < kStep; ++dx) {
            sum += soil[4u * ((y * kStep + dy) * kSoilSide + x * kStep + dx) + channel];
          }
        }
        lumps[4u * (y * kLumpSide + x) + channel] =
            static_cast<std::uint8_t>((sum + kStep * kStep / 2) / (kStep * kStep));
      }
    }
  }
  return lumps;
}

}  // namespace dockyard
