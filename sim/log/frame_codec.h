// Sensor frames and commands as bytes, little-endian, doubles as their bits. Layout in
// docs/reference/run_log.md.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"

namespace dockyard {

/// Thrown for a file that is no log, or a damaged one. The message is a sentence.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Bytes with a place to read at. Throws LogError past the end.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}
  std::uint8_t U8();
  std::uint32_t U32();
  std::uint64_t U64();
  double Double();
  std::string_view Take(std::size_t count);
  bool AtEnd() const { return bytes_.empty(); }

 private:
  std::string_view bytes_;
};

void PutU8(std::string& out, std::uint8_t value);
void PutU32(std::string& out, std::uint32_t value);
void PutU64(std::string& out, std::uint64_t value);
void PutDouble(std::string& out, double value);

/// How images go into a record: as PNG (a log), raw (a pipe), or only a note that there were some.
enum class ImageCoding { kPng, kRaw, kLeftOut };

void PutFrame(std::string& out, const SensorFrame& frame, ImageCoding coding);
void PutCommands(std::string& out, const Commands& commands);

struct LoggedFrame {
  SensorFrame frame;
  bool images_left_out = false;  // the controller saw images that the log does not hold
};
/// Throws LogError, also for a reading that is not finite.
LoggedFrame TakeFrame(ByteReader& in, ImageCoding coding);
Commands TakeCommands(ByteReader& in);

}  // namespace dockyard
