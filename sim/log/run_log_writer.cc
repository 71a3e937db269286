#include <algorithm>
#include <cmath>

#include "sim/base/files.h"
#include "sim/images/png.h"
#include "sim/images/webp.h"
#include "sim/log/belief_error.h"
#include "sim/log/pose_numbers.h"
#include "sim/log/ros_cameras.h"
#include "sim/log/ros_markers.h"
#include "sim/log/ros_messages.h"
#include "sim/log/ros_schemas.h"
#include "sim/log/run_log.h"

namespace dockyard {
namespace {

/// Their order is that of the numbers by which sightings and frames name them.
Json CamerasJson(const std::vector<NamedCamera>& cameras) {
  Json list = Json::array();
  for (const NamedCamera& each : cameras) {
    list.push_back(
        {{"name", each.name}, {"width_px", each.camera.width}, {"height_px", each.camera.height}});
  }
  return list;
}

std::string HeaderText(const RunLogHeader& header) {
  Json json = {{"version", kRunLogVersion},
               {"run", header.run},
               {"seed", header.seed},
               {"system", header.system},
               {"controller", header.controller},
               {"images_kept", header.images_kept},
               {"nominal", header.nominal},
               {"cameras", CamerasJson(header.cameras)},
               {"sensors", ToJson(header.sensors)}};
  if (header.image_gap_s > 0.0) json["image_gap_s"] = header.image_gap_s;
  if (header.commands_alone) json["commands_alone"] = true;
  return json.dump();
}

std::vector<Column> WithErrors(std::vector<Column> channels) {
  const std::vector<Column>& errors = BeliefErrorColumns();
  channels.insert(channels.end(), errors.begin(), errors.end());
  return channels;
}

std::vector<std::string> Names(std::vector<std::string> names, const std::vector<Column>& columns) {
  for (const Column& column : columns) names.push_back(column.name);
  return names;
}

/// Units and meanings of scalars, for those who open the log elsewhere.
McapTexts Meanings(const std::vector<Column>& columns) {
  McapTexts texts;
  for (const Column& column : columns) {
    texts[column.name] = (column.unit.empty() ? "" : "[" + column.unit + "] ") + column.meaning;
  }
  return texts;
}

/// Lossy, and so not for a controller.
std::vector<std::string> ForPeople(const std::vector<CameraImage>& images) {
  constexpr double kQuality = 85.0;
  std::vector<std::string> files;
  for (const CameraImage& image : images) {
    const auto* rgb = std::get_if<RgbImage>(&image.pixels);
    const RgbImage pixels = rgb ? *rgb : AsColour(std::get<GrayImage>(image.pixels));
    files.push_back(pixels.pixels.empty() ? std::string() : EncodeWebp(pixels, kQuality));
  }
  return files;
}

/// The pose on an arc, in its start, at that share of its length.
Pose2 OnArc(const PlannedArc& arc, double share) {
  const double length_m = share * arc.length_m, turn_rad = share * arc.turn_rad;
  if (std::abs(turn_rad) < 1e-9) return {length_m, 0.0, turn_rad};
  const double radius_m = length_m / turn_rad;
  return {radius_m * std::sin(turn_rad), radius_m * (1.0 - std::cos(turn_rad)), WrapPi(turn_rad)};
}

/// The poses along the arcs, about every 0.1 m.
std::vector<Pose2> PosesAlong(const std::vector<PlannedArc>& arcs) {
  std::vector<Pose2> poses;
  for (const PlannedArc& arc : arcs) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(arc.length_m) / 0.1)));
    for (int i = poses.empty() ? 0 : 1; i <= steps; ++i) {
      poses.push_back(arc.X_DR_start * OnArc(arc, static_cast<double>(i) / steps));
    }
  }
  return poses;
}

}  // namespace

RunLogWriter::RunLogWriter(const std::filesystem::path& dir, const RunLogHeader& header,
                           const std::string& scenario)
    : keep_images_(header.images_kept),
      thinned_(header.image_gap_s > 0.0),
      commands_alone_(header.commands_alone),
      motors_(header.motors),
      cameras_(header.cameras),
      named_cameras_(header.cameras),
      truth_names_(Names({kPoseNames.begin(), kPoseNames.end()}, WithErrors(header.channels))),
      belief_names_(Names({kPoseNames.begin(), kPoseNames.end()}, header.beliefs)),
      sensor_names_(Names({}, ColumnsOf(header.sensors))) {
  belief_names_.insert(belief_names_.begin(), "located");
  MakeFolder(dir);
  file_ = std::make_unique<McapWriter>(dir / kRunLogFile,
                                       McapOptions{.profile = "ros2", .library = "dockyard"});
  file_->Attach({0, 0, "header.json", "application/json", HeaderText(header)});
  if (!scenario.empty()) file_->Attach({0, 0, "scenario.yaml", "application/yaml", scenario});
  channels_[topic::kTruth] =
      Channel(topic::kTruth, "dockyard_msgs/Scalars", Meanings(WithErrors(header.channels)));
  channels_[topic::kBelief] =
      Channel(topic::kBelief, "dockyard_msgs/Scalars", Meanings(header.beliefs));
  if (!sensor_names_.empty()) {
    Channel(topic::kSensors, "dockyard_msgs/Scalars", Meanings(ColumnsOf(header.sensors)));
  }
  rectifications_ = RectificationsOf(cameras_);
  file_->Flush();
}

std::uint16_t RunLogWriter::Channel(const std::string& topic, const std::string& type,
                                    const McapTexts& metadata) {
  const auto known = channels_.find(topic);
  if (known != channels_.end()) return known->second;
  auto schema = schemas_.find(type);
  if (schema == schemas_.end()) {
    const auto id = file_->AddSchema(RosSchemaName(type), "ros2msg", RosSchema(type));
    schema = schemas_.emplace(type, id).first;
  }
  return channels_[topic] = file_->AddChannel(schema->second, topic, "cdr", metadata);
}

void RunLogWriter::Put(std::uint16_t channel, Tick tick, const std::string& data) {
  const std::uint64_t time = Nanoseconds(tick);
  file_->Write({channel, sequence_++, time, time, data});
}

const NamedCamera& RunLogWriter::CameraOf(int index) {
  while (cameras_.size() <= static_cast<std::size_t>(index)) {
    cameras_.push_back({std::to_string(cameras_.size()), {}, {}});
  }
  return cameras_[static_cast<std::size_t>(index)];
}

const std::vector<NamedMotor>& RunLogWriter::MotorsOf(const SensorFrame& sensed) {
  while (motors_.size() < sensed.motors.size()) {
    motors_.push_back({"motor_" + std::to_string(motors_.size()), 1.0});
  }
  return motors_;
}

void RunLogWriter::AppendImages(const SensorFrame& sensed, const std::vector<std::string>& files,
                                const std::string& format) {
  for (std::size_t i = 0; i < files.size(); ++i) {
    const int index = sensed.images[i].camera;
    const NamedCamera& camera = CameraOf(index);
    if (const auto place = static_cast<std::size_t>(index); place < rectifications_.size()) {
      Put(Channel("/camera/" + camera.name + "/camera_info", "sensor_msgs/CameraInfo"), sensed.tick,
          CameraInfoMessage(sensed.tick, camera.name, camera.camera, rectifications_[place]));
    }
    Put(Channel("/camera/" + camera.name + "/image/compressed", "sensor_msgs/CompressedImage"),
        sensed.tick, ImageMessage(sensed.tick, camera.name, format, files[i]));
  }
}

void RunLogWriter::Append(const SensorFrame& sensed, const Commands& commands,
                          bool without_images) {
  std::vector<std::string> pngs;
  payload_.clear();
  const bool whole = keep_images_ && !thinned_;
  PutFrame(payload_, sensed, whole ? ImageCoding::kBeside : ImageCoding::kLeftOut,
           whole ? &pngs : nullptr);
  PutCommands(payload_, commands);
  if (whole) AppendImages(sensed, pngs, "png");
  if (keep_images_ && thinned_ && !without_images) {
    AppendImages(sensed, ForPeople(sensed.images), "webp");
  }
  const Tick tick = sensed.tick;
  Put(Channel(topic::kFrame, "dockyard_msgs/Frame"), tick, FrameMessage(tick, payload_));
  if (commands_alone_) return;
  Put(Channel(topic::kImu, "sensor_msgs/Imu"), tick, ImuMessage(tick, sensed.imu));
  Put(Channel(topic::kMotors, "sensor_msgs/JointState",
              {{"position", "rad since power-on"}, {"effort", "current, A"}}),
      tick, MotorsMessage(tick, MotorsOf(sensed), sensed.motors));
  Put(Channel(topic::kCommands, "dockyard_msgs/Commands"), tick, CommandsMessage(tick, commands));
}

void RunLogWriter::Append(const Stage& stage, Tick tick) {
  std::vector<BodyPose> frames{{kDockFrame, stage.X_WD}};
  if (commands_alone_) {
    Put(Channel(topic::kTransforms, "tf2_msgs/TFMessage"), tick,
        TransformsMessage(tick, frames, {}));
    return;
  }
  if (stage.ground.heights_m != nullptr) frames.push_back({kGroundFrame, stage.ground.X_WG});
  frames.insert(frames.end(), stage.bodies.begin(), stage.bodies.end());
  Put(Channel(topic::kTransforms, "tf2_msgs/TFMessage"), tick,
      TransformsMessage(tick, frames, named_cameras_));
  if (!has_solids_) {
    has_solids_ = true;
    for (const StageSolids& solids : stage.solids) {
      Put(Channel("/" + solids.name, "visualization_msgs/MarkerArray"), tick,
          SolidsMessage(tick, solids));
    }
  }
  for (const StageLine& line : stage.lines) {
    Put(Channel("/" + line.name, "visualization_msgs/MarkerArray"), tick,
        LinesMessage(tick, {line}));
  }
}

void RunLogWriter::Append(const HistorySample& sample, const Stage& stage, Tick tick) {
  Append(stage, tick);
  const auto pose = PoseNumbers(sample.X_DR), believed = PoseNumbers(sample.X_DR_believed);
  std::vector<double> truth(pose.begin(), pose.end());
  truth.insert(truth.end(), sample.channels.begin(), sample.channels.end());
  const std::vector<double> errors = BeliefErrors(sample);
  truth.insert(truth.end(), errors.begin(), errors.end());
  Put(channels_.at(topic::kTruth), tick, ScalarsMessage(tick, truth_names_, truth));
  std::vector<double> belief(believed.begin(), believed.end());
  belief.insert(belief.begin(), sample.located ? 1.0 : 0.0);
  belief.insert(belief.end(), sample.beliefs.begin(), sample.beliefs.end());
  Put(channels_.at(topic::kBelief), tick, ScalarsMessage(tick, belief_names_, belief));
  if (!sensor_names_.empty() && !commands_alone_) {
    Put(channels_.at(topic::kSensors), tick, ScalarsMessage(tick, sensor_names_, sample.sensed));
  }
  if (sample.located && !commands_alone_) {
    Put(Channel(topic::kBeliefPose, "geometry_msgs/PoseWithCovarianceStamped"), tick,
        BeliefPoseMessage(tick, sample.X_DR_believed.X));
  }
  if (sample.phase == phase_) return;
  phase_ = sample.phase;
  Note("phase", phase_, tick);
}

void RunLogWriter::AppendValues(const std::vector<std::string>& names,
                                const std::vector<double>& values, Tick tick) {
  std::vector<std::string> known;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    known.push_back(names.at(i));
    numbers.push_back(values[i]);
  }
  if (known.empty()) return;
  Put(Channel(topic::kValues, "dockyard_msgs/Scalars"), tick, ScalarsMessage(tick, known, numbers));
}

void RunLogWriter::AppendGround(const StageGround& ground, Tick tick) {
  if (commands_alone_ || !ground_.Update(ground)) return;
  Put(Channel(topic::kGround, "dockyard_msgs/Ground"), tick, ground_.Message(tick));
  Put(Channel(topic::kGroundMarkers, "visualization_msgs/MarkerArray"), tick,
      ground_.Markers(tick));
}

void RunLogWriter::Append(const SightingSample& sighting, Tick tick) {
  Put(Channel(topic::kSighting, "dockyard_msgs/Sighting"), tick, SightingMessage(tick, sighting));
}

void RunLogWriter::Append(const PlanSample& plan, Tick tick) {
  Put(Channel(topic::kPlan, "nav_msgs/Path"), tick, PathMessage(tick, PosesAlong(plan.arcs)));
}

void RunLogWriter::Note(const std::string& name, const std::string& text, Tick tick) {
  Put(Channel(topic::kNotes, "rcl_interfaces/Log"), tick, NoteMessage(tick, name, text));
}

void RunLogWriter::Finish(const Json& outcome) {
  if (!outcome.is_null()) {
    file_->Attach({0, 0, "outcome.json", "application/json", outcome.dump()});
  }
  file_->Finish();
}

}  // namespace dockyard
