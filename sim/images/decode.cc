#include "sim/images/decode.h"

#include "sim/images/exif.h"
#include "sim/images/formats.h"
#include "sim/images/image_size.h"

namespace dockyard {
namespace {

std::optional<GrayImage> Decoded(ImageFormat format, std::string_view bytes) {
  switch (format) {
    case ImageFormat::kPng:
      return GrayFromPng(bytes);
    case ImageFormat::kJpeg:
      return GrayFromJpeg(bytes);
    case ImageFormat::kPnm:
      return GrayFromPnm(bytes);
    case ImageFormat::kWebp:
      return GrayFromWebp(bytes);
  }
  return std::nullopt;
}

}  // namespace

std::optional<GrayImage> DecodeGray(std::string_view bytes) {
  const std::optional<ImageSize> size = StatedImageSize(bytes);
  if (!size || !size->usable()) return std::nullopt;
  std::optional<GrayImage> image = Decoded(*FormatOf(bytes), bytes);
  if (!image) return std::nullopt;
  return Upright(std::move(*image), OrientationOf(bytes));
}

}  // namespace dockyard
