#include "sim/page/pictures.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>

#include "sim/images/decode.h"
#include "sim/images/png.h"
#include "sim/images/webp.h"

namespace dockyard {
namespace {

constexpr double kQuality = 50.0;
constexpr int kWidest_px = 640;  // wider ones are halved

int Channels(const GrayImage&) { return 1; }
int Channels(const RgbImage&) { return 3; }

/// Each square of four pixels, averaged.
template <class Image>
Image Halved(const Image& image) {
  const int channels = Channels(image), row = channels * image.width;
  Image half{image.width / 2, image.height / 2, {}};
  half.pixels.reserve(static_cast<std::size_t>(channels) * half.width * half.height);
  for (int y = 0; y < half.height; ++y) {
    const std::uint8_t* above = &image.pixels[2 * static_cast<std::size_t>(y) * row];
    const std::uint8_t* below = above + row;
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < channels; ++c) {
        const int left = 2 * channels * x + c, right = left + channels;
        half.pixels.push_back(static_cast<std::uint8_t>(
            (above[left] + above[right] + below[left] + below[right] + 2) / 4));
      }
    }
  }
  return half;
}

template <class Image>
Image Small(Image image) {
  while (image.width > kWidest_px && image.height > 1) image = Halved(image);
  return image;
}

std::string SmallPicture(const std::string& bytes) {
  if (auto gray = DecodePng<GrayImage>(bytes)) {
    return EncodeWebp(AsColour(Small(std::move(*gray))), kQuality);
  }
  if (auto rgb = DecodeColour(bytes)) return EncodeWebp(Small(std::move(*rgb)), kQuality);
  return "";
}

}  // namespace

std::vector<std::string> SmallPictures(const std::vector<const LoggedImage*>& images) {
  std::vector<std::string> pictures(images.size());
  std::vector<std::exception_ptr> faults(images.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < images.size(); i = next++) {
      if (images[i] == nullptr) continue;
      try {
        pictures[i] = SmallPicture(images[i]->bytes);
      } catch (...) {
        faults[i] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> helpers;
    const std::size_t processors = std::max(1u, std::thread::hardware_concurrency());
    for (std::size_t i = 1; i < std::min(processors, images.size()); ++i)
      helpers.emplace_back(work);
    work();
  }
  for (const std::exception_ptr& fault : faults) {
    if (fault) std::rethrow_exception(fault);
  }
  return pictures;
}

}  // namespace dockyard
