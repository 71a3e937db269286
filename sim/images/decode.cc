#include "sim/images/decode.h"

#include "sim/images/exif.h"
#include "sim/images/formats.h"
#include "sim/images/image_size.h"

namespace dockyard {
namespace {

template <class Image>
struct Decoder {
  std::optional<Image> (*png)(std::string_view), (*jpeg)(std::string_view),
      (*pnm)(std::string_view), (*webp)(std::string_view);
};

template <class Image>
std::optional<Image> Decode(const Decoder<Image>& decoder, std::string_view bytes) {
  const std::optional<ImageSize> size = StatedImageSize(bytes);
  if (!size || !size->usable()) return std::nullopt;
  std::optional<Image> image;
  switch (*FormatOf(bytes)) {
    case ImageFormat::kPng:
      image = decoder.png(bytes);
      break;
    case ImageFormat::kJpeg:
      image = decoder.jpeg(bytes);
      break;
    case ImageFormat::kPnm:
      image = decoder.pnm(bytes);
      break;
    case ImageFormat::kWebp:
      image = decoder.webp(bytes);
      break;
  }
  if (!image) return std::nullopt;
  return Upright(std::move(*image), OrientationOf(bytes));
}

}  // namespace

std::optional<GrayImage> DecodeGray(std::string_view bytes) {
  return Decode<GrayImage>({GrayFromPng, GrayFromJpeg, GrayFromPnm, GrayFromWebp}, bytes);
}

std::optional<RgbImage> DecodeColour(std::string_view bytes) {
  return Decode<RgbImage>({RgbFromPng, RgbFromJpeg, RgbFromPnm, RgbFromWebp}, bytes);
}

GrayImage GrayOf(const RgbImage& image) {
  GrayImage grey{.width = image.width, .height = image.height, .pixels = {}};
  grey.pixels.reserve(image.pixels.size() / 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    grey.pixels.push_back(GrayOf(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]));
  }
  return grey;
}

}  // namespace dockyard
