// The log of one run, as the robot could keep it: the nominal parameters that its controller got,
// then every sensor frame with the commands that answered it. The log alone is enough to run the
// controller again. One file, frames.bin, in the run's folder; layout in docs/reference/run_log.md.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/log/frame_codec.h"

namespace dockyard {

inline constexpr std::uint32_t kRunLogVersion = 2;

struct RunLogHeader {
  int run = 0;
  std::uint64_t seed = 0;
  std::string system, controller;
  bool images_kept = true;
  Json nominal;  // the nominal parameters that the controller got
};

struct RunLogEntry {
  SensorFrame sensed;
  bool images_left_out = false;  // the controller saw images that the log does not hold
  Commands commands;
};

class RunLogWriter {
 public:
  /// Makes the folder and dir/frames.bin. Throws IoError.
  RunLogWriter(const std::filesystem::path& dir, const RunLogHeader& header);
  /// A log without Finish reads as cut short.
  ~RunLogWriter() = default;

  /// Throws IoError, as when the disk is full.
  void Append(const SensorFrame& sensed, const Commands& commands);
  /// Writes the end mark and closes. Throws IoError.
  void Finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void WriteRecord(char kind, const std::string& payload);

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Close> file_;
  bool keep_images_ = true;
  std::uint64_t entries_ = 0;
  std::string payload_;  // kept between calls for its memory
};

/// Reads a log entry by entry. Throws IoError, and DataError for a damaged log, another version, or
/// a file that is no log.
class RunLogReader {
 public:
  explicit RunLogReader(const std::filesystem::path& dir);

  const RunLogHeader& header() const { return header_; }
  /// None at the end of the log.
  std::optional<RunLogEntry> Next();
  /// After the last entry: whether the end mark was there, or the run was cut short.
  bool complete() const { return complete_; }

 private:
  bool ReadRecord(char& kind);

  std::filesystem::path path_;
  std::ifstream file_;
  std::uintmax_t bytes_left_ = 0;
  RunLogHeader header_;
  std::uint64_t entries_ = 0;
  bool complete_ = false;
  std::string payload_;
};

/// The result of running the controller alone.
struct ControllerReplay {
  std::uint64_t compared = 0;      // entries with equal commands, bit for bit
  std::optional<Tick> differs_at;  // first tick with other commands
  std::optional<Tick> blind_at;    // first tick whose images the log left out: stopped there
  bool complete = false;           // the log has its end mark
  bool same() const { return !differs_at && !blind_at && complete; }
};
/// How many motors and cameras a robot has: a controller takes for granted that a frame has them.
struct RobotShape {
  int motors = 0, cameras = 0;
};
/// Feeds the logged frames to a fresh controller and compares its commands with the logged ones.
/// Throws DataError for a frame that is not of this robot.
ControllerReplay ReplayController(RunLogReader& log, Controller& controller,
                                  const RobotShape& robot);

}  // namespace dockyard
