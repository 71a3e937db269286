#include "sim/log/logged_run.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <unordered_map>

#include "sim/log/ros_messages.h"
#include "sim/mcap/cdr.h"

namespace dockyard {
namespace {

double TakeTime(CdrReader& in) {
  const std::int32_t s = in.I32();
  return s + 1e-9 * in.U32();
}

struct Header {
  double time_s = 0.0;
  std::string frame;
};

Header TakeHeader(CdrReader& in) {
  const double time_s = TakeTime(in);
  return {time_s, in.Text()};
}

Eigen::Vector3d TakeVector(CdrReader& in) {
  Eigen::Vector3d v;
  for (double& x : v) x = in.Double();
  return v;
}

Pose3 TakePose(CdrReader& in) {
  Pose3 X;
  X.p = TakeVector(in);
  const double x = in.Double(), y = in.Double(), z = in.Double(), w = in.Double();
  X.R = Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
  return X;
}

// The smallest size of an item, for lists that lie about their length.
constexpr std::size_t kSmallestText = 5, kSmallestStamped = 64, kSmallestMarker = 128,
                      kPointBytes = 24, kMarkBytes = 24;

std::vector<SightingReport::Mark> TakeMarks(CdrReader& in) {
  std::vector<SightingReport::Mark> marks(in.Count(kMarkBytes));
  for (SightingReport::Mark& mark : marks) {
    mark.id = in.I32();
    mark.camera = in.I32();
    mark.u_px = in.Double();
    mark.v_px = in.Double();
  }
  return marks;
}

SightingSample TakeSighting(CdrReader in) {
  SightingSample sighting{.time_s = TakeTime(in), .X_DR = {}, .report = {}, .X_DR_measured = {}};
  SightingReport& report = sighting.report;
  report.accepted = in.Bool();
  report.reason = in.Text();
  report.method = in.Text();
  report.detected.resize(in.Count(sizeof(std::int32_t)));
  for (int& count : report.detected) count = in.I32();
  report.marks = TakeMarks(in);
  report.predicted = TakeMarks(in);
  report.reprojection_px = in.Double();
  report.X_RB = TakePose(in);
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) report.covariance(row, column) = in.Double();
  }
  for (Pose2* X : {&sighting.X_DR, &sighting.X_DR_measured}) {
    for (double* value : {&X->x, &X->y, &X->heading}) *value = in.Double();
  }
  return sighting;
}

Timed<std::vector<Pose2>> TakePlan(CdrReader in) {
  Timed<std::vector<Pose2>> plan{TakeHeader(in).time_s, {}};
  for (std::uint32_t left = in.Count(kSmallestStamped); left > 0; --left) {
    TakeHeader(in);
    plan.value.push_back(ToGround(TakePose(in)));
  }
  return plan;
}

Timed<LoggedNote> TakeNote(CdrReader in) {
  const double time_s = TakeTime(in);
  in.U8();  // the level
  std::string name = in.Text();
  return {time_s, {std::move(name), in.Text()}};
}

Timed<LoggedImage> TakeImage(CdrReader in) {
  const Header header = TakeHeader(in);
  in.Text();  // the format
  return {header.time_s, {header.frame, std::string(in.Bytes())}};
}

LoggedCamera TakeCamera(CdrReader in) {
  LoggedCamera camera{.name = TakeHeader(in).frame};
  camera.height = in.U32();
  camera.width = in.U32();
  return camera;
}

Timed<LoggedGround> TakeGround(CdrReader in) {
  Timed<LoggedGround> ground{TakeHeader(in).time_s, {}};
  LoggedGround& g = ground.value;
  for (double* number : {&g.x0_m, &g.y0_m, &g.cell_m}) *number = in.Double();
  g.nx = in.U32();
  g.ny = in.U32();
  g.step_m = in.Double();
  g.cells.resize(in.Count(sizeof(std::uint32_t)));
  for (std::uint32_t& cell : g.cells) cell = in.U32();
  g.heights.resize(in.Count(sizeof(std::int16_t)));
  for (std::int16_t& height : g.heights) height = static_cast<std::int16_t>(in.U16());
  const std::uint64_t all = std::uint64_t{g.nx} * g.ny;
  const bool fits = g.cells.empty() ? g.heights.size() == all
                                    : g.heights.size() == g.cells.size() &&
                                          *std::max_element(g.cells.begin(), g.cells.end()) < all;
  if (!fits) throw DataError("heights of the ground do not fit their grid");
  return ground;
}

/// The first marker of an array of lines.
StageLine TakeLine(CdrReader in) {
  StageLine line;
  if (in.Count(kSmallestMarker) == 0) return line;
  TakeHeader(in);
  line.name = in.Text();
  for (int i = 0; i < 3; ++i) in.I32();  // id, type, action
  TakePose(in);
  line.diameter_m = TakeVector(in).x();
  for (double& part : line.rgb) part = in.Float();
  in.Float();
  in.I32();  // lifetime
  in.U32();
  in.Bool();
  line.points_W.resize(in.Count(kPointBytes));
  for (Eigen::Vector3d& point : line.points_W) point = TakeVector(in);
  return line;
}

void TakeScalars(CdrReader in, Series& series) {
  TakeTime(in);
  std::vector<std::string> names(in.Count(kSmallestText));
  for (std::string& name : names) name = in.Text();
  const std::vector<double> values = in.Doubles();
  if (values.size() != names.size()) throw DataError("scalars without a name");
  for (std::size_t i = 0; i < names.size(); ++i) series[names[i]].push_back(values[i]);
}

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
      run_.cameras.push_back(TakeCamera(CdrReader(data)));
    } else if (type == "visualization_msgs/msg/MarkerArray" && topic != topic::kGroundMarkers) {
      StageLine line = TakeLine(CdrReader(data));
      run_.lines[topic.substr(1)].push_back(std::move(line));
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
  }

 private:
  void TakeTransforms(CdrReader in) {
    double time_s = 0.0;
    Pose3 X_WD, X_WG;
    std::size_t body = 0;
    for (std::uint32_t left = in.Count(kSmallestStamped); left > 0; --left) {
      time_s = TakeHeader(in).time_s;
      const std::string name = in.Text();
      const Pose3 X = TakePose(in);
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

std::size_t LoggedRun::SampleAt(double time_s) const {
  constexpr double kRounding_s = 1e-6;
  const auto at = std::lower_bound(times_s.begin(), times_s.end(), time_s - kRounding_s);
  return std::min(static_cast<std::size_t>(at - times_s.begin()), times_s.size() - 1);
}

LoggedRun ReadLoggedRun(const std::filesystem::path& dir) {
  const std::filesystem::path path = dir / kRunLogFile;
  LoggedRun run;
  run.header = RunLogReader(dir).header();
  try {
    McapReader file(path);
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
