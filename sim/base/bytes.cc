#include "sim/base/bytes.h"

#include <bit>

namespace dockyard {
namespace {

template <class T>
void Put(std::string& out, T value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    out += static_cast<char>(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

template <class T>
T Number(std::string_view bytes) {
  T value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    value = static_cast<T>(value | static_cast<T>(static_cast<std::uint8_t>(bytes[i])) << (8 * i));
  }
  return value;
}

}  // namespace

std::string_view ByteReader::Take(std::size_t count) {
  if (count > bytes_.size()) throw DataError("it ends in the middle of a record");
  const std::string_view taken = bytes_.substr(0, count);
  bytes_.remove_prefix(count);
  return taken;
}

std::uint8_t ByteReader::U8() { return static_cast<std::uint8_t>(Take(1)[0]); }
std::uint16_t ByteReader::U16() { return Number<std::uint16_t>(Take(2)); }
std::uint32_t ByteReader::U32() { return Number<std::uint32_t>(Take(4)); }
std::uint64_t ByteReader::U64() { return Number<std::uint64_t>(Take(8)); }
double ByteReader::Double() { return std::bit_cast<double>(U64()); }

void PutU8(std::string& out, std::uint8_t value) { out += static_cast<char>(value); }
void PutU16(std::string& out, std::uint16_t value) { Put(out, value); }
void PutU32(std::string& out, std::uint32_t value) { Put(out, value); }
void PutU64(std::string& out, std::uint64_t value) { Put(out, value); }
void PutDouble(std::string& out, double value) { PutU64(out, std::bit_cast<std::uint64_t>(value)); }

}  // namespace dockyard
