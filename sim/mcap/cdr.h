// Messages in CDR, the encoding of ROS 2 (OMG DDSI-RTPS 2.3, 10; plain CDR, little-endian). Each
// number stands at a multiple of its size, counted from behind the 4 bytes that name the encoding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/bytes.h"

namespace dockyard {

class CdrWriter {
 public:
  CdrWriter();

  void Bool(bool value) { U8(value ? 1 : 0); }
  void U8(std::uint8_t value) { PutU8(bytes_, value); }
  void U16(std::uint16_t value);
  void U32(std::uint32_t value);
  void I32(std::int32_t value) { U32(static_cast<std::uint32_t>(value)); }
  void U64(std::uint64_t value);
  void Float(float value);
  void Double(double value);
  void Text(std::string_view text);
  /// The length of a list, before its items.
  void Count(std::size_t count) { U32(static_cast<std::uint32_t>(count)); }
  /// A list of bytes.
  void Bytes(std::string_view bytes);
  void Doubles(const std::vector<double>& values);

  /// The message. The writer is empty then, ready for the next.
  std::string Take();

 private:
  void Align(std::size_t size);
  std::string bytes_;
};

/// Throws DataError past the end, and for another encoding.
class CdrReader {
 public:
  explicit CdrReader(std::string_view message);

  bool Bool() { return U8() != 0; }
  std::uint8_t U8() { return in_.U8(); }
  std::uint16_t U16();
  std::uint32_t U32();
  std::int32_t I32() { return static_cast<std::int32_t>(U32()); }
  std::uint64_t U64();
  float Float();
  double Double();
  std::string Text();
  /// A list's length: no more than bytes are left of items that have at least `size` bytes.
  std::uint32_t Count(std::size_t size);
  std::string_view Bytes();
  std::vector<double> Doubles();
  bool AtEnd() const { return in_.AtEnd(); }

 private:
  void Align(std::size_t size);
  ByteReader in_;
  std::size_t total_ = 0;
};

}  // namespace dockyard
