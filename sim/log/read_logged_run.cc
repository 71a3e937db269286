#include "sim/log/logged_run.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <unordered_map>

#include "sim/log/ros_messages.h"
#include "sim/log/take_messages.h"
#include "sim/log/value_table.h"

namespace dockyard {
namespace {

/// Gathers a log's messages. A sample begins with its transforms.
class Gatherer {
 public:
  explicit Gatherer(LoggedRun& run) : run_(run) {
    const auto into = [](auto& list, auto take) {
      return [&list, take](const CdrReader& in) { list.push_back(take(in)); };
    };
    takers_ = {{topic::kTransforms, [this](const CdrReader& in) { TakeTransforms(in); }},
               {topic::kMotors, [this](const CdrReader& in) { TakeMotors(in); }},
               {topic::kTruth, [this](const CdrReader& in) { TakeScalars(in, run_.truth); }},
               {topic::kBelief, [this](const CdrReader& in) { TakeScalars(in, run_.belief); }},
               {topic::kValues, [this](const CdrReader& in) { TakeValues(in); }},
               {topic::kSighting, into(run.sightings, TakeSighting)},
               {topic::kPlan, into(run.plans, TakePlan)},
               {topic::kNotes, into(run.notes, TakeNote)},
               {topic::kGround, into(run.ground, TakeGround)}};
  }

  void Take(const std::string& topic, const std::string& type, std::string_view data) {
    const auto taker = takers_.find(topic);
    if (taker != takers_.end()) return taker->second(CdrReader(data));
    if (type == "sensor_msgs/msg/CompressedImage") {
      run_.images.push_back(TakeImage(CdrReader(data)));
    } else if (type == "sensor_msgs/msg/CameraInfo") {
      const LoggedCamera camera = TakeCamera(CdrReader(data));  // one for each image
      const auto same = [&](const LoggedCamera& each) { return each.name == camera.name; };
      if (std::none_of(run_.cameras.begin(), run_.cameras.end(), same)) {
        run_.cameras.push_back(camera);
      }
    } else if (type == "visualization_msgs/msg/MarkerArray" && topic != topic::kGroundMarkers) {
      // Solids are written once: as lines they would cut the run to its first sample.
      std::optional<StageLine> line = TakeLine(CdrReader(data));
      if (line) run_.lines[topic.substr(1)].push_back(*std::move(line));
    }
  }

  /// All lists as long as that of the times: a log may be cut in the middle of a sample.
  void Finish() {
    std::size_t samples = run_.times_s.size();
    const auto shortest = [&](const auto& list) { samples = std::min(samples, list.size()); };
    const auto each = [&](const auto& call) {
      for (auto& poses : run_.X_WO) call(poses);
      for (auto& [name, line] : run_.lines) call(line);
      for (Series* series : {&run_.truth, &run_.belief, &run_.currents_a}) {
        for (auto& [name, values] : *series) call(values);
      }
      call(run_.X_WD);
      call(run_.X_WG);
    };
    each(shortest);
    run_.times_s.resize(samples);
    each([&](auto& list) { list.resize(samples); });
    for (auto& [name, values] : run_.values) values.resize(samples, std::nan(""));
  }

 private:
  void TakeTransforms(CdrReader in) {
    double time_s = 0.0;
    Pose3 X_WD, X_WG;
    std::size_t body = 0;
    for (std::uint32_t left = in.Count(kSmallestStamped); left > 0; --left) {
      const TakenHeader header = TakeHeader(in);
      time_s = header.time_s;
      const std::string name = in.Text();
      const Pose3 X = TakePose(in);
      if (header.frame != kWorldFrame) continue;  // a camera on the robot
      if (name == kDockFrame) {
        X_WD = X;
      } else if (name == kGroundFrame) {
        X_WG = X;
      } else {
        if (body == run_.body_names.size() && run_.times_s.empty()) {
          run_.body_names.push_back(name);
          run_.X_WO.emplace_back();
        }
        if (body >= run_.body_names.size() || run_.body_names[body] != name) {
          throw DataError("the body " + name + " is not in every sample");
        }
        run_.X_WO[body++].push_back(X);
      }
    }
    run_.times_s.push_back(time_s);
    run_.X_WD.push_back(X_WD);
    run_.X_WG.push_back(X_WG);
    // The last readings of the motors belong to this sample.
    for (const auto& [name, current] : motors_) run_.currents_a[name].push_back(current);
  }

  /// Of the last sample; it may lack names that others have.
  void TakeValues(const CdrReader& in) {
    if (run_.times_s.empty()) throw DataError("values before the first sample");
    Series now;
    TakeScalars(in, now);
    for (const auto& [name, value] : now) {
      std::vector<double>& values = run_.values[name];
      values.resize(run_.times_s.size(), std::nan(""));
      values.back() = value.back();
    }
    if (run_.values.size() > kMostValueNames) throw DataError("too many names of values");
  }

  void TakeMotors(CdrReader in) {
    TakeHeader(in);
    std::vector<std::string> names(in.Count(kSmallestText));
    for (std::string& name : names) name = in.Text();
    in.Doubles();  // angles
    in.Doubles();  // speeds
    const std::vector<double> currents_a = in.Doubles();
    if (currents_a.size() != names.size()) throw DataError("a motor has no current");
    for (std::size_t i = 0; i < names.size(); ++i) motors_[names[i]] = currents_a[i];
  }

  LoggedRun& run_;
  std::unordered_map<std::string, std::function<void(const CdrReader&)>> takers_;
  std::map<std::string, double> motors_;
};

}  // namespace

LoggedRun ReadLoggedRun(const Folder& dir) {
  const std::filesystem::path path = dir.path() / kRunLogFile;
  LoggedRun run;
  run.header = RunLogReader(dir).header();
  for (const NamedCamera& each : run.header.cameras) {
    run.cameras.push_back({each.name, static_cast<std::uint32_t>(each.camera.width),
                           static_cast<std::uint32_t>(each.camera.height)});
  }
  try {
    McapReader file(OpenLog(dir, kRunLogFile), path);
    Gatherer gatherer(run);
    while (const auto message = file.Next()) {
      const McapChannel& channel = file.channel(message->channel_id);
      gatherer.Take(channel.topic, file.schemas().at(channel.schema_id).name, message->data);
    }
    gatherer.Finish();
    run.complete = file.complete();
    for (const McapAttachment& attachment : file.attachments()) {
      if (attachment.name == "outcome.json") {
        run.outcome = Json::parse(attachment.data, nullptr, /*allow_exceptions=*/false);
      }
    }
  } catch (const DataError& failure) {
    throw DataError(path.string() + ": " + failure.what());
  } catch (const std::out_of_range&) {
    throw DataError(path.string() + ": a channel has no schema");
  }
  return run;
}

}  // namespace dockyard
