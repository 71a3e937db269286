#include <cmath>

#include "controller/custom/sighting.h"

namespace dockyard::custom {

GrayImage GreyOf(const CameraImage& image) {
  if (const auto* grey = std::get_if<GrayImage>(&image.pixels)) return *grey;
  const RgbImage& colours = std::get<RgbImage>(image.pixels);
  GrayImage grey{.width = colours.width, .height = colours.height, .pixels = {}};
  grey.pixels.reserve(colours.pixels.size() / 3);
  for (std::size_t i = 0; i + 2 < colours.pixels.size(); i += 3) {
    // Thousandths of red, green and blue, rounded: ITU-R BT.601.
    const int sum =
        299 * colours.pixels[i] + 587 * colours.pixels[i + 1] + 114 * colours.pixels[i + 2];
    grey.pixels.push_back(static_cast<std::uint8_t>((sum + 500) / 1000));
  }
  return grey;
}

}  // namespace dockyard::custom
