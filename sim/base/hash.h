// FNV-1a: the fingerprint of a run, of a file and of a stream's name.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace dockyard {

inline constexpr std::uint64_t kHashSeed = 14695981039346656037ull;

inline std::uint64_t HashByte(std::uint64_t hash, std::uint64_t byte) {
  return (hash ^ byte) * 1099511628211ull;
}
inline std::uint64_t HashText(std::uint64_t hash, std::string_view text) {
  for (const char c : text) hash = HashByte(hash, static_cast<unsigned char>(c));
  return hash;
}
inline std::uint64_t HashBits(std::uint64_t hash, std::uint64_t bits) {
  for (int byte = 0; byte < 8; ++byte) hash = HashByte(hash, (bits >> (8 * byte)) & 0xff);
  return hash;
}
/// 16 hexadecimal digits.
inline std::string HexText(std::uint64_t hash) {
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; hash >>= 4) text[i] = "0123456789abcdef"[hash & 0xf];
  return text;
}
inline std::uint64_t HashDouble(std::uint64_t hash, double value) {
  return HashBits(hash, std::bit_cast<std::uint64_t>(value));
}

}  // namespace dockyard
