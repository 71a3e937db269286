// Whole numbers in the bytes of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace dockyard {

/// 0 beyond the end: no image has that size, no list that length.
inline std::int64_t NumberAt(std::string_view bytes, std::size_t at, std::size_t count,
                             bool big_endian) {
  if (at > bytes.size() || bytes.size() - at < count) return 0;
  std::int64_t value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[at + (big_endian ? i : count - 1 - i)]);
    value = 256 * value + byte;
  }
  return value;
}
inline std::int64_t Big(std::string_view bytes, std::size_t at, std::size_t count) {
  return NumberAt(bytes, at, count, true);
}
inline std::int64_t Little(std::string_view bytes, std::size_t at, std::size_t count) {
  return NumberAt(bytes, at, count, false);
}

}  // namespace dockyard
