// Netpbm's PGM and PPM: https://netpbm.sourceforge.net/doc/pgm.html, ppm.html.
#include <algorithm>
#include <charconv>

#include "sim/images/formats.h"
#include "sim/images/image_size.h"
#include "sim/images/png.h"

namespace dockyard {
namespace {

/// Takes the header's and text's numbers, with white space and comments between them.
class Numbers {
 public:
  explicit Numbers(std::string_view bytes) : rest_(bytes) {}

  /// -1 when there is none.
  int Next() {
    for (;;) {
      const std::size_t begin = rest_.find_first_not_of(" \t\r\n\v\f");
      if (begin == std::string_view::npos) return -1;
      rest_.remove_prefix(begin);
      if (rest_[0] != '#') break;
      rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size()));
    }
    int number = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc() || number < 0) return -1;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return number;
  }
  /// What follows the last number and the one byte of white space after it.
  std::string_view Rest() const { return rest_.substr(std::min<std::size_t>(1, rest_.size())); }

 private:
  std::string_view rest_;
};

/// Text is stretched to 255, as its greatest number may be small; bytes are taken as they are.
std::vector<std::uint8_t> FromText(Numbers& numbers, int greatest, std::size_t count) {
  std::vector<std::uint8_t> values;
  values.reserve(count);
  while (values.size() < count) {
    const int number = std::min(numbers.Next(), greatest);
    if (number < 0) return {};
    const int value = greatest > 255 ? number >> 8 : number * 255 / greatest;
    values.push_back(static_cast<std::uint8_t>(value));
  }
  return values;
}

std::vector<std::uint8_t> FromBytes(std::string_view bytes, int greatest, std::size_t count) {
  const std::size_t each = greatest > 255 ? 2 : 1;  // the upper one first
  if (bytes.size() < each * count) return {};
  std::vector<std::uint8_t> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<std::uint8_t>(bytes[each * i]);
  return values;
}

/// The file's values, and whether there are three a pixel.
struct Values {
  int width = 0, height = 0;
  bool colour = false;
  std::vector<std::uint8_t> values;
};

std::optional<Values> Read(std::string_view bytes) {
  const char kind = bytes[1];
  const bool text = kind <= '3';
  Numbers numbers(bytes.substr(2));
  Values image;
  image.colour = kind == '3' || kind == '6';
  image.width = numbers.Next();
  image.height = numbers.Next();
  const int greatest = numbers.Next();
  if (!ImageSize{image.width, image.height}.usable() || greatest < 1 || greatest > 65535) {
    return std::nullopt;
  }
  const std::size_t count = static_cast<std::size_t>(image.width) * image.height;
  // A short file must not cost the memory of a large image: a number has a byte at least.
  if (bytes.size() < count) return std::nullopt;
  const std::size_t wanted = image.colour ? 3 * count : count;
  image.values =
      text ? FromText(numbers, greatest, wanted) : FromBytes(numbers.Rest(), greatest, wanted);
  if (image.values.empty()) return std::nullopt;
  return image;
}

}  // namespace

std::optional<GrayImage> GrayFromPnm(std::string_view bytes) {
  std::optional<Values> read = Read(bytes);
  if (!read) return std::nullopt;
  if (read->colour) return GrayOf(RgbImage{read->width, read->height, std::move(read->values)});
  return GrayImage{read->width, read->height, std::move(read->values)};
}

std::optional<RgbImage> RgbFromPnm(std::string_view bytes) {
  std::optional<Values> read = Read(bytes);
  if (!read) return std::nullopt;
  if (read->colour) return RgbImage{read->width, read->height, std::move(read->values)};
  return AsColour(GrayImage{read->width, read->height, std::move(read->values)});
}

}  // namespace dockyard
