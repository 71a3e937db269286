// Numbers as bytes and back: little-endian, doubles as their bits.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace dockyard {

/// Bytes that are not what they should be, as in a damaged file. The message is a sentence.
class DataError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes with a place to read at. Throws DataError past the end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  std::uint8_t U8();
  std::uint16_t U16();
  std::uint32_t U32();
  std::uint64_t U64();
  double Double();
  std::string_view Take(std::size_t count);
  bool AtEnd() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

void PutU8(std::string& out, std::uint8_t value);
void PutU16(std::string& out, std::uint16_t value);
void PutU32(std::string& out, std::uint32_t value);
void PutU64(std::string& out, std::uint64_t value);
void PutDouble(std::string& out, double value);

}  // namespace dockyard
