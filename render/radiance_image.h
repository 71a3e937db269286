// The light of one channel in an image, before any sensor.
#pragma once

#include <cstddef>
#include <vector>

namespace dockyard {

/// Linear radiance of one ideal view: exact lens geometry, no sensor.
struct RadianceImage {
  int width = 0, height = 0;
  std::vector<float> values;           // one channel, row by row from the top left
  std::vector<float> inverse_depth{};  // 1/z of what each pixel shows [1/m]; empty: not asked for
  float at(int x, int y) const { return values[static_cast<std::size_t>(y) * width + x]; }
};

}  // namespace dockyard
