// Bands of hue, saturation and value: what a robot is told of a colour.
#pragma once

#include <cstdint>

namespace dockyard {

/// One interval for each of hue, saturation and value, ends included. Hue in half degrees, 0 to
/// 179, saturation and value 0 to 255; a hue interval whose lower end is above its upper one passes
/// through 0.
struct HsvBand {
  std::uint8_t hue_from = 0, hue_to = 179;
  std::uint8_t saturation_from = 0, saturation_to = 255;
  std::uint8_t value_from = 0, value_to = 255;

  bool operator==(const HsvBand&) const = default;
};

}  // namespace dockyard
