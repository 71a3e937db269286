#include "sim/mcap/cdr.h"

#include <bit>

namespace dockyard {
namespace {

// CDR_LE and no options.
constexpr std::string_view kEncoding("\x00\x01\x00\x00", 4);

/// Bytes from a place to the next multiple of the size.
std::size_t Gap(std::size_t at, std::size_t size) { return (size - at % size) % size; }

}  // namespace

CdrWriter::CdrWriter() : bytes_(kEncoding) {}

void CdrWriter::Align(std::size_t size) {
  bytes_.append(Gap(bytes_.size() - kEncoding.size(), size), '\0');
}

void CdrWriter::U16(std::uint16_t value) {
  Align(sizeof value);
  PutU16(bytes_, value);
}

void CdrWriter::U32(std::uint32_t value) {
  Align(sizeof value);
  PutU32(bytes_, value);
}

void CdrWriter::U64(std::uint64_t value) {
  Align(sizeof value);
  PutU64(bytes_, value);
}

void CdrWriter::Float(float value) { U32(std::bit_cast<std::uint32_t>(value)); }
void CdrWriter::Double(double value) { U64(std::bit_cast<std::uint64_t>(value)); }

void CdrWriter::Text(std::string_view text) {
  U32(static_cast<std::uint32_t>(text.size() + 1));  // with its zero
  bytes_.append(text).push_back('\0');
}

void CdrWriter::Bytes(std::string_view bytes) {
  Count(bytes.size());
  bytes_.append(bytes);
}

void CdrWriter::Doubles(const std::vector<double>& values) {
  Count(values.size());
  for (const double value : values) Double(value);
}

std::string CdrWriter::Take() {
  std::string taken(kEncoding);
  taken.swap(bytes_);
  return taken;
}

CdrReader::CdrReader(std::string_view message) : in_(message) {
  if (in_.Take(kEncoding.size()) != kEncoding) {
    throw DataError("a message is not in little-endian CDR");
  }
  total_ = in_.left();
}

void CdrReader::Align(std::size_t size) { in_.Take(Gap(total_ - in_.left(), size)); }

std::uint16_t CdrReader::U16() {
  Align(2);
  return in_.U16();
}

std::uint32_t CdrReader::U32() {
  Align(4);
  return in_.U32();
}

std::uint64_t CdrReader::U64() {
  Align(8);
  return in_.U64();
}

float CdrReader::Float() { return std::bit_cast<float>(U32()); }
double CdrReader::Double() { return std::bit_cast<double>(U64()); }

std::string CdrReader::Text() {
  const std::string_view text = in_.Take(U32());
  if (text.empty() || text.back() != '\0') throw DataError("a text has no end");
  return std::string(text.substr(0, text.size() - 1));
}

std::uint32_t CdrReader::Count(std::size_t size) {
  const std::uint32_t count = U32();
  if (count > in_.left() / size) throw DataError("a list is longer than its message");
  return count;
}

std::string_view CdrReader::Bytes() { return in_.Take(U32()); }

std::vector<double> CdrReader::Doubles() {
  std::vector<double> values(Count(sizeof(double)));
  for (double& value : values) value = Double();
  return values;
}

}  // namespace dockyard
