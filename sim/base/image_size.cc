#include "sim/base/image_size.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

namespace dockyard {
namespace {

/// A whole number in bytes, 0 beyond the end: no image has that size.
std::int64_t Number(std::string_view bytes, std::size_t at, std::size_t count, bool big_endian) {
  if (at > bytes.size() || bytes.size() - at < count) return 0;
  std::int64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[at + (big_endian ? i : count - 1 - i)]);
    value = 256 * value + byte;
  }
  return value;
}
std::int64_t Big(std::string_view bytes, std::size_t at, std::size_t count) {
  return Number(bytes, at, count, true);
}
std::int64_t Little(std::string_view bytes, std::size_t at, std::size_t count) {
  return Number(bytes, at, count, false);
}

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

/// A negative height says that the rows run downwards.
Size OfBmp(std::string_view bytes) {
  if (Little(bytes, 14, 4) == 12) return ImageSize{Little(bytes, 18, 2), Little(bytes, 20, 2)};
  const auto height = static_cast<std::int32_t>(Little(bytes, 22, 4));
  return ImageSize{Little(bytes, 18, 4), std::abs(static_cast<std::int64_t>(height))};
}

/// TIFF 6.0, section 2: the first directory's ImageWidth (256) and ImageLength (257), short or
/// long.
Size OfTiff(std::string_view bytes) {
  const bool big_endian = bytes[0] == 'M';
  const auto directory = static_cast<std::size_t>(Number(bytes, 4, 4, big_endian));
  const std::int64_t entries = Number(bytes, directory, 2, big_endian);
  ImageSize size;
  for (std::int64_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * static_cast<std::size_t>(i);
    const std::int64_t tag = Number(bytes, at, 2, big_endian);
    const std::size_t wide = Number(bytes, at + 2, 2, big_endian) == 3 ? 2 : 4;
    const std::int64_t value = Number(bytes, at + 8, wide, big_endian);
    // Of a tag given twice the larger one counts.
    if (tag == 256) size.width = std::max(size.width, value);
    if (tag == 257) size.height = std::max(size.height, value);
  }
  return size;
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

std::optional<ImageSize> StatedImageSize(std::string_view bytes) {
  const auto starts = [&](std::string_view with) { return bytes.substr(0, with.size()) == with; };
  if (starts("\x89PNG\r\n\x1a\n")) return ImageSize{Big(bytes, 16, 4), Big(bytes, 20, 4)};
  if (starts("\xff\xd8")) return OfJpeg(bytes);
  if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '6') {
    return OfPnm(bytes);
  }
  if (starts("BM")) return OfBmp(bytes);
  if (starts({"II*\0", 4}) || starts({"MM\0*", 4})) return OfTiff(bytes);
  if (starts("RIFF") && bytes.size() > 16 && bytes.substr(8, 4) == "WEBP") return OfWebp(bytes);
  return std::nullopt;
}

}  // namespace dockyard
