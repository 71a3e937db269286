// The log of one run: an MCAP file of ROS 2 messages (docs/reference/run_log.md). It holds the
// nominal parameters that the controller got, every sensor frame with the commands that answered
// it, what the controller believed, and the truth that a spectator would see. The frames alone are
// enough to run the controller again.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "sim/base/json.h"
#include "sim/log/frame_codec.h"
#include "sim/log/ground_log.h"
#include "sim/log/named_sensor.h"
#include "sim/log/record.h"
#include "sim/log/ros_cameras.h"
#include "sim/log/stage.h"
#include "sim/mcap/mcap_reader.h"
#include "sim/mcap/mcap_writer.h"

namespace dockyard {

inline constexpr std::uint32_t kRunLogVersion = kFrameVersion;
inline constexpr std::uint32_t kOldestRunLogVersion = 5;  // that is still read
inline constexpr const char* kRunLogFile = "run.mcap";

/// Topics of a log.
namespace topic {
inline constexpr const char* kFrame = "/dockyard/frame";
inline constexpr const char* kImu = "/imu";
inline constexpr const char* kMotors = "/motors";
inline constexpr const char* kCommands = "/commands";
inline constexpr const char* kTransforms = "/tf";
inline constexpr const char* kGroundMarkers = "/ground";
inline constexpr const char* kGround = "/truth/ground";
inline constexpr const char* kSensors = "/sensors";
inline constexpr const char* kTruth = "/truth/scalars";
inline constexpr const char* kBelief = "/belief/scalars";
inline constexpr const char* kValues = "/belief/values";
inline constexpr const char* kBeliefPose = "/belief/pose";
inline constexpr const char* kPlan = "/plan";
inline constexpr const char* kSighting = "/sighting";
inline constexpr const char* kNotes = "/rosout";
}  // namespace topic

struct RunLogHeader {
  int run = 0;
  std::uint64_t seed = 0;
  std::string system{}, controller{};
  bool images_kept = true;
  Json nominal{};  // the nominal parameters that the controller got
  // Names for the messages. Motors and cameras without one are called by their number.
  std::vector<NamedMotor> motors{};
  std::vector<NamedCamera> cameras{};  // read back: names and sizes
  std::vector<NamedSensor> sensors{};
  std::vector<Column> channels{}, beliefs{};  // of the history
  // Frames, beliefs and notes alone: what a run needs to be made again without its program.
  bool commands_alone = false;
  double image_gap_s = 0.0;  // of the scenario: some of the images alone are kept; 0: all
  std::uint32_t version = kRunLogVersion;  // as read
};

struct RunLogEntry {
  SensorFrame sensed;
  bool images_left_out = false;  // the controller saw images that the log does not hold
  Commands commands;
};

class RunLogWriter {
 public:
  /// Makes the folder and its run.mcap. Throws IoError.
  /// @param scenario  its YAML, attached; may be empty
  RunLogWriter(const std::filesystem::path& dir, const RunLogHeader& header,
               const std::string& scenario = {});
  /// A log without Finish reads as cut short.
  ~RunLogWriter() = default;

  // All throw IoError, as when the disk is full. Times must not fall.

  /// One control period. A log with an image gap says of each frame that it had images, and keeps
  /// them for people alone, unless they are left out.
  void Append(const SensorFrame& sensed, const Commands& commands, bool without_images = false);
  /// What the truth and the belief were at a time of the history.
  void Append(const HistorySample& sample, const Stage& stage, Tick tick);
  /// The belief's values that the system does not name, by their names; NaN ones are left out.
  void AppendValues(const std::vector<std::string>& names, const std::vector<double>& values,
                    Tick tick);
  /// What has changed of the ground since the last call.
  void AppendGround(const StageGround& ground, Tick tick);
  void Append(const SightingSample& sighting, Tick tick);
  void Append(const PlanSample& plan, Tick tick);
  /// A sentence, and who says it.
  void Note(const std::string& name, const std::string& text, Tick tick);
  /// Attaches the outcome, writes the end and closes.
  void Finish(const Json& outcome = {});

 private:
  std::uint16_t Channel(const std::string& topic, const std::string& type,
                        const McapTexts& metadata = {});
  void Put(std::uint16_t channel, Tick tick, const std::string& data);
  void Append(const Stage& stage, Tick tick);
  void AppendImages(const SensorFrame& sensed, const std::vector<std::string>& files,
                    const std::string& format);
  const NamedCamera& CameraOf(int index);
  const std::vector<NamedMotor>& MotorsOf(const SensorFrame& sensed);

  bool keep_images_ = true;
  bool thinned_ = false;
  bool commands_alone_ = false;
  std::vector<NamedMotor> motors_;
  std::vector<NamedCamera> cameras_;              // more are added as their images come
  const std::vector<NamedCamera> named_cameras_;  // with mounting and lens
  std::vector<RosRectification> rectifications_;  // of these
  std::vector<std::string> truth_names_, belief_names_, sensor_names_;
  std::unique_ptr<McapWriter> file_;
  std::map<std::string, std::uint16_t> schemas_, channels_;  // by type, by topic
  std::uint32_t sequence_ = 0;
  std::string phase_;
  bool has_solids_ = false;  // they are written
  GroundLog ground_;
  std::string payload_;  // kept between calls for its memory
};

/// Reads a log frame by frame. Throws IoError, and DataError for a damaged log, another version, or
/// a file that is no log.
class RunLogReader {
 public:
  /// @param dir  the run's folder
  explicit RunLogReader(const Folder& dir);

  const RunLogHeader& header() const { return header_; }
  /// None at the end of the log.
  std::optional<RunLogEntry> Next();
  /// After the last entry: whether the log has its end, or the run was cut short.
  bool complete() const { return file_->complete(); }
  /// After the last entry: whether a check value covers all of it.
  bool guarded() const { return file_->guarded(); }

 private:
  RunLogEntry EntryFrom(std::string_view message);

  std::filesystem::path path_;
  std::unique_ptr<McapReader> file_;
  std::optional<McapMessage> first_;  // read for the header's sake
  RunLogHeader header_;
  std::vector<std::string> pictures_;  // of the next frame
  std::uint64_t entries_ = 0;
};

/// The result of running the controller alone.
struct ControllerReplay {
  std::uint64_t compared = 0;      // entries with equal commands, bit for bit
  std::optional<Tick> differs_at;  // first tick with other commands
  std::optional<Tick> blind_at;    // first tick whose images the log left out: stopped there
  bool complete = false;           // the log has its end
  bool guarded = true;             // a check value covers all of it
  bool same() const { return !differs_at && !blind_at && complete; }
};
/// How many motors, cameras and further sensors a robot has: a controller takes for granted that a
/// frame has them.
struct RobotShape {
  int motors = 0, cameras = 0, sensors = 0;
};
/// Feeds the logged frames to a fresh controller and compares its commands with the logged ones.
/// Throws DataError for a frame that is not of this robot.
ControllerReplay ReplayController(RunLogReader& log, Controller& controller,
                                  const RobotShape& robot);

}  // namespace dockyard
