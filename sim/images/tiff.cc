#include "sim/images/tiff.h"

#include <tiffio.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "sim/images/image_size.h"

namespace dockyard {
namespace {

// A strip or tile may be the whole image, and a float has four bytes.
constexpr tmsize_t kMostBytes = 4 * kMaxImagePixels + (1 << 20);

struct Bytes {
  std::string_view all;
  std::size_t at = 0;
};

tmsize_t ReadBytes(thandle_t handle, void* to, tmsize_t count) {
  auto& bytes = *static_cast<Bytes*>(handle);
  const std::size_t there = bytes.all.size() - std::min(bytes.at, bytes.all.size());
  const std::size_t taken = std::min(there, static_cast<std::size_t>(count));
  if (taken > 0) std::memcpy(to, bytes.all.data() + bytes.at, taken);
  bytes.at += taken;
  return static_cast<tmsize_t>(taken);
}
tmsize_t WriteNothing(thandle_t, void*, tmsize_t) { return 0; }
toff_t SeekBytes(thandle_t handle, toff_t offset, int whence) {
  auto& bytes = *static_cast<Bytes*>(handle);
  const std::size_t from = whence == SEEK_SET   ? 0
                           : whence == SEEK_CUR ? bytes.at
                                                : bytes.all.size();
  return bytes.at = from + static_cast<std::size_t>(offset);
}
int CloseBytes(thandle_t) { return 0; }
toff_t SizeBytes(thandle_t handle) { return static_cast<Bytes*>(handle)->all.size(); }
int Ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff Open(Bytes& bytes) {
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
      TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMostBytes);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), Ignore, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), Ignore, nullptr);
  return {TIFFClientOpenExt("bytes", "rm", &bytes, ReadBytes, WriteNothing, SeekBytes, CloseBytes,
                            SizeBytes, nullptr, nullptr, options.get()),
          TIFFClose};
}

/// Of one number, as the file's tags have it.
using ToFloat = float (*)(const std::uint8_t*);

template <class Number>
float As(const std::uint8_t* at) {
  Number value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<float>(value);
}

ToFloat ReaderOf(TIFF* tiff, std::size_t* bytes) {
  std::uint16_t samples = 0, bits = 0, format = 0;
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format);
  *bytes = bits / 8;
  if (samples != 1) return nullptr;
  if (format == SAMPLEFORMAT_IEEEFP) return bits == 32 ? As<float> : nullptr;
  const bool has_sign = format == SAMPLEFORMAT_INT;
  if (!has_sign && format != SAMPLEFORMAT_UINT) return nullptr;
  if (bits == 8) return has_sign ? As<std::int8_t> : As<std::uint8_t>;
  if (bits == 16) return has_sign ? As<std::int16_t> : As<std::uint16_t>;
  return nullptr;
}

}  // namespace

std::optional<FloatImage> DecodeTiff(std::string_view file) {
  Bytes bytes{file};
  const Tiff tiff = Open(bytes);
  if (tiff == nullptr) return std::nullopt;
  std::uint32_t width = 0, height = 0, block_width = 0, block_height = 0;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  std::size_t each = 0;
  const ToFloat to_float = ReaderOf(tiff.get(), &each);
  if (!ImageSize{width, height}.usable() || to_float == nullptr) return std::nullopt;
  const bool tiled = TIFFIsTiled(tiff.get()) != 0;
  if (tiled) {
    TIFFGetField(tiff.get(), TIFFTAG_TILEWIDTH, &block_width);
    TIFFGetField(tiff.get(), TIFFTAG_TILELENGTH, &block_height);
  } else {
    block_width = width;
    TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_ROWSPERSTRIP, &block_height);
    block_height = std::min(block_height, height);
  }
  const tmsize_t room = tiled ? TIFFTileSize(tiff.get()) : TIFFStripSize(tiff.get());
  if (room <= 0 || room > kMostBytes || block_width == 0 || block_height == 0) return std::nullopt;
  FloatImage image{static_cast<int>(width), static_cast<int>(height), {}};
  image.pixels.resize(std::size_t{width} * height);
  std::vector<std::uint8_t> block(static_cast<std::size_t>(room));
  for (std::uint32_t y0 = 0; y0 < height; y0 += block_height) {
    for (std::uint32_t x0 = 0; x0 < width; x0 += block_width) {
      const std::uint32_t rows = std::min(block_height, height - y0);
      const std::uint32_t columns = std::min(block_width, width - x0);
      const tmsize_t got =
          tiled ? TIFFReadEncodedTile(tiff.get(), TIFFComputeTile(tiff.get(), x0, y0, 0, 0),
                                      block.data(), room)
                : TIFFReadEncodedStrip(tiff.get(), TIFFComputeStrip(tiff.get(), y0, 0),
                                       block.data(), room);
      const std::size_t row_bytes = each * block_width;
      if (got < 0 || static_cast<std::size_t>(got) < row_bytes * (rows - 1) + each * columns) {
        return std::nullopt;
      }
      for (std::uint32_t y = 0; y < rows; ++y) {
        float* to = &image.pixels[std::size_t{y0 + y} * width + x0];
        for (std::uint32_t x = 0; x < columns; ++x)
          to[x] = to_float(&block[y * row_bytes + x * each]);
      }
    }
  }
  return image;
}

}  // namespace dockyard
