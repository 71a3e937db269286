// Friction that differs from place to place: square patches in G, each with a factor of its own.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/base/random.h"

namespace dockyard {

struct FrictionPatches {
  double scatter = 0.0;  // the factors are uniform in 1 -+ this; 0: none
  double patch_m = 0.2;
  std::uint64_t seed = 0;
};

/// A patch's factor depends on its place and the seed alone.
inline double FrictionFactor(const FrictionPatches& patches, double x_m, double y_m) {
  if (patches.scatter == 0.0) return 1.0;
  const double per_patch = 1.0 / patches.patch_m;
  const auto index = [&](double at_m) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(at_m * per_patch)));
  };
  const std::uint64_t key = WorldSeed(patches.seed, index(x_m), index(y_m));
  return RandomStream(key).Uniform(1.0 - patches.scatter, 1.0 + patches.scatter);
}

}  // namespace dockyard
