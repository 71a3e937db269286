#include "render/board_wear.h"

#include <algorithm>
#include <cmath>

#include "controller/base/split_mix.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

constexpr float kPitch_m = 0.002f;  // mean size of a patch; assumed, 1-4 mm

struct Streams {
  std::uint64_t x, y, flaked;
};

bool Flaked(const Streams& streams, double wear, const Eigen::Vector2f& p_B) {
  const Eigen::Vector2f at = p_B / kPitch_m;
  const int column = static_cast<int>(std::floor(at.x()));
  const int row = static_cast<int>(std::floor(at.y()));
  float nearest = 1e9f;
  std::uint64_t patch = 0;
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      const std::uint64_t place =
          std::uint64_t{static_cast<std::uint32_t>(j)} << 32 | static_cast<std::uint32_t>(i);
      const float dx = static_cast<float>(i + HashUniform(streams.x, place)) - at.x();
      const float dy = static_cast<float>(j + HashUniform(streams.y, place)) - at.y();
      const float squared = dx * dx + dy * dy;
      if (squared >= nearest) continue;
      nearest = squared;
      patch = place;
    }
  }
  return HashUniform(streams.flaked, patch) < wear;
}

}  // namespace

float FlakedShare(const BoardView& board, const std::array<Eigen::Vector2f, 4>& footprint_B) {
  if (board.wear <= 0.0) return 0.0f;
  const auto& [a, b, c, d] = footprint_B;
  const float span = std::max((c - a).cwiseAbs().maxCoeff(), (d - b).cwiseAbs().maxCoeff());
  constexpr int kLeast = 3, kMost = 8;
  constexpr float kApart_m = 0.0005f;  // a quarter of a patch
  const int parts =
      static_cast<int>(std::clamp(std::ceil(span / kApart_m), 1.0f * kLeast, 1.0f * kMost));
  const Streams streams{.x = SplitMix(board.wear_seed, 0),
                        .y = SplitMix(board.wear_seed, 1),
                        .flaked = SplitMix(board.wear_seed, 2)};
  int flaked = 0;
  for (int j = 0; j < parts; ++j) {
    const float v = (static_cast<float>(j) + 0.5f) / static_cast<float>(parts);
    for (int i = 0; i < parts; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(parts);
      const Eigen::Vector2f p = (1 - v) * ((1 - u) * a + u * b) + v * ((1 - u) * d + u * c);
      flaked += Flaked(streams, board.wear, p);
    }
  }
  return static_cast<float>(flaked) / static_cast<float>(parts * parts);
}

}  // namespace dockyard
