// Sensor frames and commands as bytes, little-endian, doubles as their bits. Layout in
// docs/reference/run_log.md.
#pragma once

#include <string>
#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "sim/base/bytes.h"

namespace dockyard {

/// How images go into a record: as PNGs beside it (a log), raw (a pipe), or only a note that there
/// were some.
enum class ImageCoding { kBeside, kRaw, kLeftOut };

/// @param pngs  gets the PNG of each image, with kBeside; an image without pixels is empty
void PutFrame(std::string& out, const SensorFrame& frame, ImageCoding coding,
              std::vector<std::string>* pngs = nullptr);
void PutCommands(std::string& out, const Commands& commands);

struct LoggedFrame {
  SensorFrame frame;
  bool images_left_out = false;  // the controller saw images that the log does not hold
};
/// Layouts are those of the log's versions: 5 has contact switches in place of the values and no
/// time of an exposure.
inline constexpr std::uint32_t kFrameVersion = 6;
/// Throws DataError, also for a reading that is not finite.
/// @param pngs  as of PutFrame
LoggedFrame TakeFrame(ByteReader& in, ImageCoding coding, const std::vector<std::string>& pngs = {},
                      std::uint32_t version = kFrameVersion);
Commands TakeCommands(ByteReader& in);

}  // namespace dockyard
