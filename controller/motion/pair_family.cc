#include "controller/motion/pair_family.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// On either side of a split at which an arc is half a circle.
constexpr double kBeside = 1e-13;
// Square of the way by both chords, in chords, below which they are too long to use.
constexpr double kShortestWay = 1e-6;

// Arc length over chord, by half the turn.
double ArcOverChord(double half_turn) {
  return std::abs(half_turn) < 1e-4 ? 1.0 + half_turn * half_turn / 6.0
                                    : half_turn / std::sin(half_turn);
}

// The arc along a signed chord, its half turn brought within a quarter of a circle either way.
Arc AlongChord(double chord_m, double half_turn) {
  const double halves = std::round(half_turn / kPi);
  if (std::fmod(std::abs(halves), 2.0) == 1.0) chord_m = -chord_m;
  half_turn -= halves * kPi;
  return {chord_m * ArcOverChord(half_turn), 2.0 * half_turn};
}

}  // namespace

PairFamily::PairFamily(const Pose2& X_RG)
    : distance_m_(std::hypot(X_RG.x, X_RG.y)),
      bearing_(std::atan2(X_RG.y, X_RG.x)),
      half_(0.5 * X_RG.heading),
      sin_half_(std::sin(half_)),
      cos_half_(std::cos(half_)),
      sin_bearing_(distance_m_ > 0.0 ? X_RG.y / distance_m_ : 0.0),
      cos_bearing_(distance_m_ > 0.0 ? X_RG.x / distance_m_ : 1.0) {}

std::optional<ArcPair> PairFamily::At(double split_rad) const {
  const double s = std::sin(split_rad), c = std::cos(split_rad);
  const double way = 1.0 + 2.0 * s * c * cos_half_;  // |s + c e^(i half)|^2
  if (distance_m_ == 0.0 || way < kShortestWay) return std::nullopt;
  const double scale_m = distance_m_ / std::sqrt(way);
  const double first_half = bearing_ - std::atan2(c * sin_half_, s + c * cos_half_);
  return ArcPair{AlongChord(scale_m * s, first_half), AlongChord(scale_m * c, half_ - first_half)};
}

std::optional<PairFamily::Sketch> PairFamily::SketchAt(double sine, double cosine) const {
  const double along = sine + cosine * cos_half_, across = cosine * sin_half_;
  const double way = along * along + across * across;
  if (distance_m_ == 0.0 || way < kShortestWay) return std::nullopt;
  const double one_over = 1.0 / std::sqrt(way);
  // Half turns as unit vectors: the bearing less that of both chords, and the rest of the half.
  const double first_cos = (cos_bearing_ * along + sin_bearing_ * across) * one_over;
  const double first_sin = (sin_bearing_ * along - cos_bearing_ * across) * one_over;
  const std::array<double, 2> cosines{first_cos, cos_half_ * first_cos + sin_half_ * first_sin};
  const std::array<double, 2> sines{first_sin, sin_half_ * first_cos - cos_half_ * first_sin};
  const std::array<double, 2> chords{distance_m_ * one_over * sine,
                                     distance_m_ * one_over * cosine};
  Sketch sketch;
  for (std::size_t i = 0; i < 2; ++i) {
    const double s = std::abs(sines[i]);
    const double over = s < 1e-4 ? 1.0 + s * s / 6.0 : std::atan2(s, std::abs(cosines[i])) / s;
    sketch.length_m[i] = (cosines[i] < 0.0 ? -chords[i] : chords[i]) * over;
    sketch.chord_m[i] = std::abs(chords[i]);
    sketch.sine[i] = s;
  }
  return sketch;
}

std::array<double, 4> PairFamily::BesideHalfCircles() const {
  const double turned = half_ - bearing_;
  std::array<double, 4> splits{};
  std::size_t next = 0;
  for (const double half_circle : {std::atan2(-std::cos(turned), std::cos(bearing_)),
                                   std::atan2(-std::cos(half_ + turned), std::cos(turned))}) {
    const double split = half_circle < 0.0 ? half_circle + kPi : half_circle;
    splits[next++] = std::max(0.0, split - kBeside);
    splits[next++] = std::min(kPi, split + kBeside);
  }
  return splits;
}

std::vector<double> PairFamily::Splits(int even) const {
  std::vector<double> splits;
  for (int i = 0; i <= even; ++i) splits.push_back(i * kPi / even);
  for (const double split : BesideHalfCircles()) splits.push_back(split);
  std::sort(splits.begin(), splits.end());
  return splits;
}

}  // namespace dockyard
