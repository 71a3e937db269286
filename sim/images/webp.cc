#include "sim/images/webp.h"

#include <webp/decode.h>
#include <webp/encode.h>

#include "controller/base/check.h"
#include "sim/images/formats.h"
#include "sim/images/image_size.h"

namespace dockyard {

std::optional<RgbImage> RgbFromWebp(std::string_view bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK) return std::nullopt;
  if (!ImageSize{features.width, features.height}.usable()) return std::nullopt;
  RgbImage image{.width = features.width, .height = features.height, .pixels = {}};
  image.pixels.resize(3 * static_cast<std::size_t>(image.width) * image.height);
  if (WebPDecodeRGBInto(data, bytes.size(), image.pixels.data(), image.pixels.size(),
                        3 * image.width) == nullptr) {
    return std::nullopt;
  }
  return image;
}

std::optional<GrayImage> GrayFromWebp(std::string_view bytes) {
  const std::optional<RgbImage> image = RgbFromWebp(bytes);
  return image ? std::optional(GrayOf(*image)) : std::nullopt;
}

std::string EncodeWebp(const RgbImage& image, double quality) {
  DOCKYARD_CHECK(image.width > 0 && image.height > 0);
  WebPConfig config;
  WebPPicture picture;
  DOCKYARD_CHECK(WebPConfigInit(&config) && WebPPictureInit(&picture));
  config.quality = static_cast<float>(quality);
  config.method = 2;  // a third of the default's time for a tenth more bytes
  picture.width = image.width;
  picture.height = image.height;
  WebPMemoryWriter memory;
  WebPMemoryWriterInit(&memory);
  picture.writer = WebPMemoryWrite;
  picture.custom_ptr = &memory;
  const bool whole = WebPPictureImportRGB(&picture, image.pixels.data(), 3 * image.width) &&
                     WebPEncode(&config, &picture);
  std::string bytes;
  if (whole) bytes.assign(reinterpret_cast<const char*>(memory.mem), memory.size);
  WebPPictureFree(&picture);
  WebPMemoryWriterClear(&memory);
  return bytes;
}

}  // namespace dockyard
