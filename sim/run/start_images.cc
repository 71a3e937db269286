#include "sim/run/start_images.h"

#include <algorithm>
#include <cstdint>
#include <exception>
#include <numeric>
#include <variant>
#include <vector>

#include "sim/base/hash.h"
#include "sim/plant/renderer.h"

namespace dockyard {
namespace {

/// Empty for a robot without cameras. Throws std::runtime_error where nothing can be drawn.
std::string Draw(const System& system, const Scenario& scenario) {
  const ReadyRun ready = system.make_ready(scenario);
  if (ready.camera_count == 0) return "";
  std::vector<int> cameras(static_cast<std::size_t>(ready.camera_count));
  std::iota(cameras.begin(), cameras.end(), 0);
  ready.plant->Sense();
  std::uint64_t hash = kHashSeed;
  const std::vector<CameraImage> images = ready.plant->TakeImages(cameras, 0.0);
  if (images.empty()) return "none: no camera gives an image";
  for (const CameraImage& image : images) {
    const std::vector<std::uint8_t>& pixels =
        std::visit([](const auto& any) -> const std::vector<std::uint8_t>& { return any.pixels; },
                   image.pixels);
    if (std::all_of(pixels.begin(), pixels.end(), [&](int value) { return value == pixels[0]; })) {
      return "none: the image of camera " + std::to_string(image.camera) + " shows nothing";
    }
    hash = HashBits(hash, static_cast<std::uint64_t>(image.camera));
    for (const std::uint8_t pixel : pixels) hash = HashByte(hash, pixel);
  }
  return HexText(hash);
}

}  // namespace

std::string StartImages(const System& system, const Scenario& scenario) {
  return AskInChild([&] {
    try {
      return Draw(system, scenario);
    } catch (const std::exception& error) {
      return "none: " + std::string(error.what());
    }
  });
}

}  // namespace dockyard
