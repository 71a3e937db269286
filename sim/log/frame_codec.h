// Sensor frames and commands as bytes, little-endian, doubles as their bits. Layout in
// docs/reference/run_log.md.
#pragma once

#include <string>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "sim/base/bytes.h"

namespace dockyard {

/// How images go into a record: as PNG (a log), raw (a pipe), or only a note that there were some.
enum class ImageCoding { kPng, kRaw, kLeftOut };

void PutFrame(std::string& out, const SensorFrame& frame, ImageCoding coding);
void PutCommands(std::string& out, const Commands& commands);

struct LoggedFrame {
  SensorFrame frame;
  bool images_left_out = false;  // the controller saw images that the log does not hold
};
/// Throws DataError, also for a reading that is not finite.
LoggedFrame TakeFrame(ByteReader& in, ImageCoding coding);
Commands TakeCommands(ByteReader& in);

}  // namespace dockyard
