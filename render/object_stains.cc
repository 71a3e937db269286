#include "render/object_stains.h"

#include <algorithm>
#include <cmath>

#include "render/pixel_noise.h"

namespace dockyard {
namespace {

// Standard deviation of Noise: knots have a variance of 1/3, and a place between eight of them the
// cube of 26/35 of it, the mean of t^2 + (1 - t)^2 for t faded.
constexpr double kNoiseSigma = 0.3698;
// No albedo below this share of the mean.
constexpr float kDarkest = 0.1f;
// By how much a surface may be nearer or farther half a pixel aside. Only edges seen along
// themselves have more.
constexpr float kMostStep = 0.05f;

float Fade(float t) { return t * t * (3.0f - 2.0f * t); }

// Value noise: -1 to 1, one knot at each corner of a lattice of whole numbers.
float Noise(const Eigen::Vector3f& at, std::uint64_t key) {
  std::uint64_t planes[3][2];
  float fade[3];
  for (int i = 0; i < 3; ++i) {
    const float low = std::floor(at[i]);
    fade[i] = Fade(at[i] - low);
    for (int up = 0; up < 2; ++up) {
      planes[i][up] = static_cast<std::uint64_t>(static_cast<std::int64_t>(low) + up) & 0x1fffffu;
    }
  }
  float sum = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    float weight = 1.0f;
    std::uint64_t place = 0;
    for (int i = 0; i < 3; ++i) {
      const int up = corner >> i & 1;
      weight *= up ? fade[i] : 1.0f - fade[i];
      place = place << 21 | planes[i][up];
    }
    sum += weight * static_cast<float>(2.0 * HashUniform(key, place) - 1.0);
  }
  return sum;
}

}  // namespace

ObjectStains::ObjectStains(const SceneObject& object, const Pose3& X_WC) {
  const Stains& stains = object.stains;
  const Pose3 X_OC = Inverse(object.X_WO) * X_WC;
  R_OC_ = X_OC.R.cast<float>();
  p_OC_ = X_OC.p.cast<float>();
  if (stains.contrast <= 0.0) return;
  for (double cell_m = stains.largest_m; cell_m > 0.75 * stains.least_m; cell_m *= 0.5) {
    octaves_.push_back({.per_cell = static_cast<float>(1.0 / cell_m),
                        .cell_m = static_cast<float>(cell_m),
                        .amplitude = 0.0f,
                        .key = SplitMix(stains.seed, octaves_.size())});
  }
  // All sizes count alike.
  const double each = stains.contrast / kNoiseSigma / std::sqrt(octaves_.size());
  for (Octave& octave : octaves_) octave.amplitude = static_cast<float>(each);
}

float ObjectStains::At(const Place& place) const {
  const float z = 1.0f / place.inverse_depth;
  // The plane of the facet, met by the pixel's own ray.
  const Eigen::Vector3f from(place.from.x, place.from.y, 1.0f);
  const Eigen::Vector3f ray(place.ray.x, place.ray.y, 1.0f);
  const float along = place.n_C.dot(ray);
  const float ratio = along != 0.0f ? place.n_C.dot(from) / along : 1.0f;
  const float there = z * std::clamp(ratio, 1.0f - kMostStep, 1.0f + kMostStep);
  const Eigen::Vector3f p_O = p_OC_ + R_OC_ * (there * ray);
  // The side of a square as large as the pixel's area on the surface.
  constexpr float kLeastCosine = 0.1f;
  const float cosine = std::abs(along) / (place.n_C.norm() * ray.norm());
  const float footprint_m = 2.0f * place.half_pixel * z / std::sqrt(std::max(cosine, kLeastCosine));
  float albedo = 1.0f;
  for (const Octave& octave : octaves_) {
    // Cells narrower than a pixel average out; those of two pixels are all there.
    const float share = std::clamp(octave.cell_m / footprint_m - 1.0f, 0.0f, 1.0f);
    if (share <= 0.0f) break;
    albedo += share * octave.amplitude * Noise(octave.per_cell * p_O, octave.key);
  }
  return std::max(albedo, kDarkest);
}

}  // namespace dockyard
