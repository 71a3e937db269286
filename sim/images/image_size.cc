#include "sim/images/image_size.h"

#include <algorithm>
#include <charconv>

#include "sim/images/bytes.h"

namespace dockyard {
namespace {

using Size = std::optional<ImageSize>;

/// ITU-T T.81, B.1: segments with their lengths; the frame header SOFn holds the size.
Size OfJpeg(std::string_view bytes) {
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    if (Big(bytes, at, 1) != 0xff) return std::nullopt;
    const std::int64_t marker = Big(bytes, at + 1, 1);
    if (marker == 0xff) {  // a fill byte
      ++at;
      continue;
    }
    const bool frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame) return ImageSize{Big(bytes, at + 7, 2), Big(bytes, at + 5, 2)};
    const std::int64_t length = Big(bytes, at + 2, 2);
    if (length < 2) return std::nullopt;
    at += 2 + static_cast<std::size_t>(length);
  }
  return std::nullopt;
}

/// Netpbm: the kind, the width and the height, with white space and comments between them.
Size OfPnm(std::string_view bytes) {
  std::int64_t numbers[2] = {0, 0};
  std::size_t at = 2;
  for (std::int64_t& number : numbers) {
    for (at = bytes.find_first_not_of(" \t\r\n", at);
         at != std::string_view::npos && bytes[at] == '#';
         at = bytes.find_first_not_of(" \t\r\n", at)) {
      at = std::min(bytes.find('\n', at), bytes.size());
    }
    if (at == std::string_view::npos) return std::nullopt;
    const auto [end, error] =
        std::from_chars(bytes.data() + at, bytes.data() + bytes.size(), number);
    if (error != std::errc()) return std::nullopt;
    at = static_cast<std::size_t>(end - bytes.data());
  }
  return ImageSize{numbers[0], numbers[1]};
}

/// RFC 9649: lossy, lossless or extended.
Size OfWebp(std::string_view bytes) {
  const std::string_view kind = bytes.substr(12, 4);
  if (kind == "VP8 ") {
    return ImageSize{Little(bytes, 26, 2) & 0x3fff, Little(bytes, 28, 2) & 0x3fff};
  }
  if (kind == "VP8L") {
    const std::int64_t bits = Little(bytes, 21, 4);
    return ImageSize{(bits & 0x3fff) + 1, ((bits >> 14) & 0x3fff) + 1};
  }
  if (kind == "VP8X") return ImageSize{Little(bytes, 24, 3) + 1, Little(bytes, 27, 3) + 1};
  return std::nullopt;
}

}  // namespace

std::optional<ImageFormat> FormatOf(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return ImageFormat::kPng;
  if (bytes.starts_with("\xff\xd8")) return ImageFormat::kJpeg;
  if (bytes.starts_with("RIFF") && bytes.size() > 16 && bytes.substr(8, 4) == "WEBP") {
    return ImageFormat::kWebp;
  }
  for (const char* kind : {"P2", "P3", "P5", "P6"}) {
    if (bytes.starts_with(kind)) return ImageFormat::kPnm;
  }
  return std::nullopt;
}

std::optional<ImageSize> StatedImageSize(std::string_view bytes) {
  const std::optional<ImageFormat> format = FormatOf(bytes);
  if (!format) return std::nullopt;
  switch (*format) {
    case ImageFormat::kPng:
      return ImageSize{Big(bytes, 16, 4), Big(bytes, 20, 4)};
    case ImageFormat::kJpeg:
      return OfJpeg(bytes);
    case ImageFormat::kPnm:
      return OfPnm(bytes);
    case ImageFormat::kWebp:
      return OfWebp(bytes);
  }
  return std::nullopt;
}

}  // namespace dockyard
