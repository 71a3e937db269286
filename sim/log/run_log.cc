#include "sim/log/run_log.h"

#include <cerrno>
#include <limits>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr std::string_view kMagic = "DOCKLOG\n";
constexpr char kHeaderKind = 'H', kEntryKind = 'F', kEndKind = 'E';
// Records are far smaller than this; a damaged length must not allocate all memory.
constexpr std::uint32_t kLargestRecord = 256u << 20;

std::filesystem::path LogFile(const std::filesystem::path& dir) { return dir / "frames.bin"; }

std::string HeaderText(const RunLogHeader& header) {
  const Json json = {{"run", header.run},
                     {"seed", header.seed},
                     {"system", header.system},
                     {"controller", header.controller},
                     {"images_kept", header.images_kept},
                     {"nominal", header.nominal}};
  return json.dump();
}

RunLogHeader HeaderFromText(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    RunLogHeader header;
    header.run = json.at("run");
    header.seed = json.at("seed");
    header.system = json.at("system");
    header.controller = json.at("controller");
    header.images_kept = json.at("images_kept");
    header.nominal = json.at("nominal");
    return header;
  } catch (const Json::exception& error) {
    throw DataError(std::string("its header cannot be read: ") + error.what());
  }
}

void RequireShape(const SensorFrame& frame, const RobotShape& robot) {
  const auto refuse = [&](const std::string& what) {
    throw DataError("the log, at tick " + std::to_string(frame.tick) + ": " + what);
  };
  if (frame.motors.size() != static_cast<std::size_t>(robot.motors)) {
    refuse("expected the readings of " + std::to_string(robot.motors) + " motors, found " +
           std::to_string(frame.motors.size()));
  }
  for (const CameraImage& image : frame.images) {
    if (image.camera >= 0 && image.camera < robot.cameras) continue;
    refuse("expected images of cameras 0 to " + std::to_string(robot.cameras - 1) +
           ", found one of " + std::to_string(image.camera));
  }
}

std::string CommandBytes(const Commands& commands) {
  std::string bytes;
  PutCommands(bytes, commands);
  return bytes;
}

}  // namespace

RunLogWriter::RunLogWriter(const std::filesystem::path& dir, const RunLogHeader& header)
    : path_(LogFile(dir)), keep_images_(header.images_kept) {
  MakeFolder(dir);
  file_.reset(std::fopen(path_.c_str(), "wbe"));
  if (!file_) throw IoErrorFromErrno("write", path_);
  std::string start(kMagic);
  PutU32(start, kRunLogVersion);
  if (std::fwrite(start.data(), 1, start.size(), file_.get()) != start.size()) {
    throw IoErrorFromErrno("write", path_);
  }
  WriteRecord(kHeaderKind, HeaderText(header));
}

void RunLogWriter::WriteRecord(char kind, const std::string& payload) {
  DOCKYARD_CHECK(file_ != nullptr && payload.size() <= kLargestRecord);
  std::string head(1, kind);
  PutU32(head, static_cast<std::uint32_t>(payload.size()));
  if (std::fwrite(head.data(), 1, head.size(), file_.get()) != head.size() ||
      std::fwrite(payload.data(), 1, payload.size(), file_.get()) != payload.size()) {
    throw IoErrorFromErrno("write", path_);
  }
}

void RunLogWriter::Append(const SensorFrame& sensed, const Commands& commands) {
  payload_.clear();
  PutFrame(payload_, sensed, keep_images_ ? ImageCoding::kPng : ImageCoding::kLeftOut);
  PutCommands(payload_, commands);
  WriteRecord(kEntryKind, payload_);
  ++entries_;
}

void RunLogWriter::Finish() {
  payload_.clear();
  PutU64(payload_, entries_);
  WriteRecord(kEndKind, payload_);
  if (std::fclose(file_.release()) != 0) throw IoErrorFromErrno("write", path_);
}

RunLogReader::RunLogReader(const std::filesystem::path& dir) : path_(LogFile(dir)) {
  errno = 0;
  file_.open(path_, std::ios::binary);
  if (!file_) throw IoErrorFromErrno("read", path_);
  std::error_code error;
  bytes_left_ = std::filesystem::file_size(path_, error);
  if (error) throw IoError("cannot read " + path_.string() + ": " + error.message());
  try {
    char start[kMagic.size() + 4] = {};
    file_.read(start, sizeof start);
    ByteReader in(std::string_view(start, sizeof start));
    if (!file_ || in.Take(kMagic.size()) != kMagic) throw DataError("it is not a run log");
    const std::uint32_t version = in.U32();
    if (version != kRunLogVersion) {
      throw DataError("its version is " + std::to_string(version) + ", this program reads " +
                     std::to_string(kRunLogVersion));
    }
    bytes_left_ -= sizeof start;
    char kind = 0;
    if (!ReadRecord(kind) || kind != kHeaderKind) throw DataError("its header is missing");
    header_ = HeaderFromText(payload_);
  } catch (const DataError& failure) {
    throw DataError(path_.string() + ": " + failure.what());
  }
}

/// False at the end of the file, be it in the middle of a record: the run was cut short.
bool RunLogReader::ReadRecord(char& kind) {
  char head[5] = {};
  if (bytes_left_ < sizeof head || !file_.read(head, sizeof head)) return false;
  bytes_left_ -= sizeof head;
  kind = head[0];
  ByteReader in(std::string_view(head + 1, 4));
  const std::uint32_t length = in.U32();
  if (length > kLargestRecord) throw DataError("a record's length is damaged");
  if (length > bytes_left_) return false;
  bytes_left_ -= length;
  payload_.resize(length);
  return static_cast<bool>(file_.read(payload_.data(), length));
}

std::optional<RunLogEntry> RunLogReader::Next() {
  try {
    char kind = 0;
    if (complete_ || !ReadRecord(kind)) return std::nullopt;
    ByteReader in(payload_);
    if (kind == kEndKind) {
      if (in.U64() != entries_) throw DataError("entries are missing before its end mark");
      complete_ = true;
      return std::nullopt;
    }
    if (kind != kEntryKind) throw DataError("a record is of unknown kind");
    LoggedFrame logged = TakeFrame(in, ImageCoding::kPng);
    RunLogEntry entry{std::move(logged.frame), logged.images_left_out, TakeCommands(in)};
    if (!in.AtEnd()) throw DataError("a record is longer than its content");
    ++entries_;
    return entry;
  } catch (const DataError& failure) {
    throw DataError(path_.string() + ", entry " + std::to_string(entries_) + ": " + failure.what());
  }
}

ControllerReplay ReplayController(RunLogReader& log, Controller& controller,
                                  const RobotShape& robot) {
  ControllerReplay replay;
  while (const auto entry = log.Next()) {
    if (entry->images_left_out) {
      replay.blind_at = entry->sensed.tick;
      return replay;
    }
    RequireShape(entry->sensed, robot);
    // Bytes, not ==: a NaN equals itself here and -0 is not 0.
    if (CommandBytes(controller.Step(entry->sensed)) != CommandBytes(entry->commands)) {
      replay.differs_at = entry->sensed.tick;
      return replay;
    }
    ++replay.compared;
  }
  replay.complete = log.complete();
  return replay;
}

}  // namespace dockyard
