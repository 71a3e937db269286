#include <utility>

#include "sim/log/run_log.h"
#include "sim/mcap/cdr.h"

namespace dockyard {
namespace {

RunLogHeader HeaderFromText(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    RunLogHeader header;
    header.version = json.at("version");
    if (header.version < kOldestRunLogVersion || header.version > kRunLogVersion) {
      throw DataError("its version is " + std::to_string(header.version) + ", this program reads " +
                      std::to_string(kOldestRunLogVersion) + " to " +
                      std::to_string(kRunLogVersion));
    }
    header.run = json.at("run");
    header.seed = json.at("seed");
    header.system = json.at("system");
    header.controller = json.at("controller");
    header.images_kept = json.at("images_kept");
    header.image_gap_s = json.value("image_gap_s", 0.0);
    header.nominal = json.at("nominal");
    for (const Json& each : json.value("cameras", Json::array())) {
      NamedCamera camera{.name = each.at("name"), .camera = {}, .X_OC = {}};
      camera.camera.width = each.at("width_px");
      camera.camera.height = each.at("height_px");
      header.cameras.push_back(std::move(camera));
    }
    header.sensors = SensorsFromJson(json.value("sensors", Json::array()));
    return header;
  } catch (const Json::exception& error) {
    throw DataError(std::string("its header cannot be read: ") + error.what());
  }
}

const McapAttachment* HeaderIn(const McapReader& file) {
  for (const McapAttachment& attachment : file.attachments()) {
    if (attachment.name == "header.json") return &attachment;
  }
  return nullptr;
}

/// Behind the time of a message.
CdrReader BehindTime(std::string_view message) {
  CdrReader in(message);
  in.I32();
  in.U32();
  return in;
}

/// The PNG in a sensor_msgs/CompressedImage.
std::string PictureFrom(std::string_view message) {
  CdrReader in = BehindTime(message);
  in.Text();  // the camera's frame
  in.Text();  // the format
  return std::string(in.Bytes());
}

bool IsImage(const std::string& topic) { return topic.ends_with("/image/compressed"); }

void RequireShape(const SensorFrame& frame, const RobotShape& robot) {
  const auto refuse = [&](const std::string& what) {
    throw DataError("the log, at tick " + std::to_string(frame.tick) + ": " + what);
  };
  if (frame.motors.size() != static_cast<std::size_t>(robot.motors)) {
    refuse("expected the readings of " + std::to_string(robot.motors) + " motors, found " +
           std::to_string(frame.motors.size()));
  }
  if (frame.values.size() != static_cast<std::size_t>(robot.sensors)) {
    refuse("expected the values of " + std::to_string(robot.sensors) + " sensors, found " +
           std::to_string(frame.values.size()));
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

RunLogReader::RunLogReader(const Folder& dir) : path_(dir.path() / kRunLogFile) {
  try {
    file_ = std::make_unique<McapReader>(OpenLog(dir, kRunLogFile), path_);
    first_ = file_->Next();
    const McapAttachment* header = HeaderIn(*file_);
    std::optional<McapReader> whole;
    if (header == nullptr) {  // other writers may put it behind the messages
      whole.emplace(OpenLog(dir, kRunLogFile), path_);
      while (whole->Next()) {
      }
      header = HeaderIn(*whole);
    }
    if (header == nullptr) {
      throw DataError(
          "its header is missing: the attachment header.json (mcap filter keeps it with "
          "--include-attachments)");
    }
    header_ = HeaderFromText(header->data);
  } catch (const DataError& failure) {
    throw DataError(path_.string() + ": " + failure.what());
  }
}

std::optional<RunLogEntry> RunLogReader::Next() {
  try {
    for (;;) {
      const auto message = first_ ? std::exchange(first_, std::nullopt) : file_->Next();
      if (!message) return std::nullopt;
      const std::string& topic = file_->channel(message->channel_id).topic;
      // Those of a log with a gap are for people.
      if (IsImage(topic) && header_.image_gap_s == 0.0)
        pictures_.push_back(PictureFrom(message->data));
      if (topic == topic::kFrame) return EntryFrom(message->data);
    }
  } catch (const DataError& failure) {
    throw DataError(path_.string() + ", entry " + std::to_string(entries_) + ": " + failure.what());
  }
}

RunLogEntry RunLogReader::EntryFrom(std::string_view message) {
  CdrReader outer = BehindTime(message);
  ByteReader in(outer.Bytes());
  LoggedFrame logged = TakeFrame(in, ImageCoding::kBeside, pictures_, header_.version);
  pictures_.clear();
  RunLogEntry entry{std::move(logged.frame), logged.images_left_out, TakeCommands(in)};
  if (!in.AtEnd()) throw DataError("a record is longer than its content");
  ++entries_;
  return entry;
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
  replay.guarded = log.guarded();
  return replay;
}

}  // namespace dockyard
