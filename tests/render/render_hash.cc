// Prints a hash of one noisy stereo pair. For the test on threads.
#include <cinttypes>
#include <cstdio>

#include "render/scene_samples.h"

int main() {
  using namespace dockyard;
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const StereoImages pair =
      StereoRenderer().Render(yard->scene, SampleRig(320, 240), yard->X_WR, {.noise_key = 1});
  std::uint64_t hash = 14695981039346656037ull;  // FNV-1a
  for (const GrayImage* image : {&pair.left, &pair.right}) {
    for (const std::uint8_t p : image->pixels) hash = (hash ^ p) * 1099511628211ull;
  }
  std::printf("%016" PRIx64 "\n", hash);
}
