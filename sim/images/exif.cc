#include "sim/images/exif.h"

#include <type_traits>
#include <utility>

#include "sim/images/bytes.h"
#include "sim/images/image_size.h"

namespace dockyard {
namespace {

/// The block of EXIF, itself laid out as a TIFF file; empty if there is none.
std::string_view InPng(std::string_view file) {
  for (std::size_t at = 8; at + 12 <= file.size();) {
    const auto length = static_cast<std::size_t>(Big(file, at, 4));
    if (length > file.size() - at - 12) return {};
    if (file.substr(at + 4, 4) == "eXIf") return file.substr(at + 8, length);
    at += 12 + length;
  }
  return {};
}

std::string_view InJpeg(std::string_view file) {
  constexpr std::string_view kName("Exif\0\0", 6);
  for (std::size_t at = 2; at + 4 <= file.size() && Big(file, at, 1) == 0xff;) {
    const std::int64_t marker = Big(file, at + 1, 1);
    if (marker == 0xff) {  // a fill byte
      ++at;
      continue;
    }
    const auto length = static_cast<std::size_t>(Big(file, at + 2, 2));
    if (marker == 0xda || length < 2 || length > file.size() - at - 2) return {};
    const std::string_view segment = file.substr(at + 4, length - 2);
    if (marker == 0xe1 && segment.starts_with(kName)) return segment.substr(kName.size());
    at += 2 + length;
  }
  return {};
}

/// TIFF 6.0, section 2: a short number in the first directory.
std::int64_t ShortOf(std::string_view block, std::int64_t wanted) {
  const bool big_endian = block.starts_with('M');
  const auto directory = static_cast<std::size_t>(NumberAt(block, 4, 4, big_endian));
  const std::int64_t entries = NumberAt(block, directory, 2, big_endian);
  for (std::int64_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * static_cast<std::size_t>(i);
    if (NumberAt(block, at, 2, big_endian) == wanted) {
      return NumberAt(block, at + 8, 2, big_endian);
    }
  }
  return 0;
}

template <class Image>
Image Turned(Image image, int orientation) {
  if (orientation == 1) return image;
  constexpr std::size_t kChannels = std::is_same_v<Image, RgbImage> ? 3 : 1;
  const bool across = orientation >= 5;  // rows become columns, before either flip
  const bool flip_x = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
  const bool flip_y = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
  Image turned{.width = across ? image.height : image.width,
               .height = across ? image.width : image.height,
               .pixels = {}};
  turned.pixels.reserve(image.pixels.size());
  for (int y = 0; y < turned.height; ++y) {
    for (int x = 0; x < turned.width; ++x) {
      const int u = flip_x ? turned.width - 1 - x : x, v = flip_y ? turned.height - 1 - y : y;
      const int from_x = across ? v : u, from_y = across ? u : v;
      const std::size_t at = kChannels * (static_cast<std::size_t>(from_y) * image.width +
                                          static_cast<std::size_t>(from_x));
      for (std::size_t k = 0; k < kChannels; ++k) turned.pixels.push_back(image.pixels[at + k]);
    }
  }
  return turned;
}

}  // namespace

int OrientationOf(std::string_view file) {
  const std::optional<ImageFormat> format = FormatOf(file);
  const std::string_view block = format == ImageFormat::kPng    ? InPng(file)
                                 : format == ImageFormat::kJpeg ? InJpeg(file)
                                                                : std::string_view();
  const std::int64_t stated = ShortOf(block, 274);
  return stated >= 1 && stated <= 8 ? static_cast<int>(stated) : 1;
}

GrayImage Upright(GrayImage image, int orientation) {
  return Turned(std::move(image), orientation);
}

RgbImage Upright(RgbImage image, int orientation) { return Turned(std::move(image), orientation); }

}  // namespace dockyard
