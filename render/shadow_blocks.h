// How high casters are over a plane, block by block of a shadow map's texels. No GL.
#pragma once

#include <cstddef>
#include <vector>

namespace dockyard {

/// Bounds that are found when they are first asked for, and kept: of a wall all pixels ask for
/// those of one plane's rises, and many for one block's.
class ShadowBlocks {
 public:
  static constexpr int kSide = 4;    // texels
  static constexpr int kMargin = 2;  // texels on each side that the bounds cover as well
  static constexpr float kNoCaster = -1e9f;

  /// depth: row by row, 0 at top_m, 1 at range_m below it and without a caster.
  struct Map {
    const float* depth;
    int width;
    float top_m, range_m;
  };
  /// A surface's rise from texel to texel, towards the sun.
  struct Rises {
    float x, y;
    bool operator==(const Rises&) const = default;
  };
  /// Casters' heights over a plane through the block's first corner at height 0 [m].
  struct Bounds {
    float lowest, highest;
  };

  ShadowBlocks() : kept_(kPlaces) {}

  /// For a new map.
  void Clear();
  /// Whether the last surface asked about had these rises: bounds pay where many places share them.
  bool Repeats(const Rises& rises) {
    if (rises == last_) return true;
    last_ = rises;
    return false;
  }
  /// Of the block whose first texel this is, a multiple of kSide. The margin lies in the map.
  Bounds Over(const Map& map, int column, int row, const Rises& rises) {
    const int block = (row / kSide) * kMostAcross + column / kSide;
    Kept& kept = kept_[static_cast<std::size_t>(block) % kPlaces];
    if (kept.block != block || !(kept.rises == rises)) {
      kept = {block, rises, Find(map, column, row, rises)};
    }
    return kept.bounds;
  }

 private:
  static constexpr int kMostAcross = 1 << 12;       // blocks; more than any map has
  static constexpr std::size_t kPlaces = 1u << 12;  // of several rows of blocks
  struct Kept {
    int block = -1;
    Rises rises{};
    Bounds bounds{};
  };
  static Bounds Find(const Map& map, int column, int row, const Rises& rises);

  std::vector<Kept> kept_;
  Rises last_{};
};

}  // namespace dockyard
