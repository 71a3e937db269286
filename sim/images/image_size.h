// The format and the size that an image file states in its header, before anything is decoded: 0.9
// MB of PNG can be an image of 900 megapixels.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace dockyard {

/// Twice the 20 megapixels of the Mars rovers' engineering cameras. The search for a board holds
/// about 15 bytes a pixel, 0.6 GB of the largest.
inline constexpr std::int64_t kMaxImagePixels = 40'000'000;

struct ImageSize {
  std::int64_t width = 0, height = 0;

  /// Whether it has pixels, and not too many.
  bool usable() const {
    return width > 0 && height > 0 && width <= kMaxImagePixels && height <= kMaxImagePixels / width;
  }
};

/// The formats that are read. Pnm: PGM and PPM, as text or binary (P2, P3, P5, P6).
enum class ImageFormat { kPng, kJpeg, kPnm, kWebp };

/// By the first bytes; none for other files.
std::optional<ImageFormat> FormatOf(std::string_view bytes);

/// Of a file in one of the formats; none for other bytes and where the header ends before it says.
std::optional<ImageSize> StatedImageSize(std::string_view bytes);

}  // namespace dockyard
