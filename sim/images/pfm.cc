#include "sim/images/pfm.h"

#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "sim/images/image_size.h"

namespace dockyard {
namespace {

constexpr std::size_t kNumberBytes = 4;

/// The next word of the header, and one white space behind it.
std::optional<std::string> TakeWord(std::string_view& bytes) {
  const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!bytes.empty() && is_space(bytes.front())) bytes.remove_prefix(1);
  std::size_t length = 0;
  while (length < bytes.size() && length < 32 && !is_space(bytes[length])) ++length;
  if (length == 0 || length >= bytes.size() || !is_space(bytes[length])) return std::nullopt;
  const std::string word(bytes.substr(0, length));
  bytes.remove_prefix(length + 1);
  return word;
}

std::optional<int> TakeSide(std::string_view& bytes) {
  const auto word = TakeWord(bytes);
  int side = 0;
  if (!word) return std::nullopt;
  const auto read = std::from_chars(word->data(), word->data() + word->size(), side);
  if (read.ec != std::errc() || read.ptr != word->data() + word->size() || side < 1) {
    return std::nullopt;
  }
  return side;
}

std::size_t RowFromBottom(const FloatImage& image, int row) {
  return static_cast<std::size_t>(image.height - 1 - row) * static_cast<std::size_t>(image.width);
}

}  // namespace

std::string EncodePfm(const FloatImage& image) {
  std::string bytes =
      "Pf\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      float value = image.pixels[RowFromBottom(image, row) + static_cast<std::size_t>(column)];
      if (std::isnan(value)) value = std::numeric_limits<float>::infinity();
      const auto bits = std::bit_cast<std::uint32_t>(value);
      for (std::size_t i = 0; i < kNumberBytes; ++i) bytes += static_cast<char>(bits >> (8 * i));
    }
  }
  return bytes;
}

std::optional<FloatImage> DecodePfm(std::string_view bytes) {
  const auto kind = TakeWord(bytes);
  if (!kind || *kind != "Pf") return std::nullopt;
  const auto width = TakeSide(bytes), height = TakeSide(bytes);
  if (!width || !height) return std::nullopt;
  if (!ImageSize{*width, *height}.usable()) return std::nullopt;
  const auto scale = TakeWord(bytes);
  if (!scale) return std::nullopt;
  // Its sign tells the byte order, its size nothing that disparities need.
  const double order = std::strtod(scale->c_str(), nullptr);
  FloatImage image{*width, *height, {}};
  const auto count = static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height);
  if (order == 0.0 || bytes.size() < kNumberBytes * count) return std::nullopt;
  image.pixels.resize(count);
  std::size_t at = 0;
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column, at += kNumberBytes) {
      std::uint32_t bits = 0;
      for (std::size_t i = 0; i < kNumberBytes; ++i) {
        const std::size_t from = order < 0.0 ? i : kNumberBytes - 1 - i;
        bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + from])) << (8 * i);
      }
      image.pixels[RowFromBottom(image, row) + static_cast<std::size_t>(column)] =
          std::bit_cast<float>(bits);
    }
  }
  return image;
}

}  // namespace dockyard
