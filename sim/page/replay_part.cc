#include "sim/page/replay_part.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "sim/log/belief_error.h"
#include "sim/page/images_part.h"
#include "sim/page/replay_ground.h"
#include "sim/page/sightings_part.h"
#include "sim/page/simplified.h"

namespace dockyard {
namespace {

constexpr double kLengthQuantum_m = 1e-4, kTurnQuantum = 4e-4, kPointQuantum_m = 1e-3;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Position and quaternion over the samples. Signs are such that neighbours are near.
Json TrackJson(const std::vector<Pose3>& X_GO, Payload& payload) {
  std::vector<std::vector<double>> parts(7);
  Eigen::Quaterniond last = Eigen::Quaterniond::Identity();
  for (const Pose3& X : X_GO) {
    Eigen::Quaterniond q(X.R);
    if (q.dot(last) < 0.0) q.coeffs() *= -1.0;
    last = q;
    for (int i = 0; i < 3; ++i) parts[static_cast<std::size_t>(i)].push_back(X.p(i));
    for (int i = 0; i < 4; ++i) parts[static_cast<std::size_t>(3 + i)].push_back(q.coeffs()(i));
  }
  Json track = Json::array();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    track.push_back(payload.AddChannel(parts[i], i < 3 ? kLengthQuantum_m : kTurnQuantum));
  }
  return track;
}

Json LineJson(const std::string& name, const std::vector<StageLine>& line, const Pose3& X_GW,
              Payload& payload) {
  std::vector<double> counts, points[3];
  for (const StageLine& now : line) {
    const std::vector<Eigen::Vector3d> shown_W = Simplified(now.points_W, kPointQuantum_m);
    counts.push_back(static_cast<double>(shown_W.size()));
    for (const Eigen::Vector3d& p_W : shown_W) {
      const Eigen::Vector3d p_G = X_GW * p_W;
      for (int i = 0; i < 3; ++i) points[i].push_back(p_G(i));
    }
  }
  Json channels = Json::array();
  for (const auto& axis : points) channels.push_back(payload.AddChannel(axis, kPointQuantum_m));
  const Eigen::Vector3d& rgb = line.front().rgb;
  return {{"name", name},
          {"diameter_m", line.front().diameter_m},
          {"colour", Json::array({rgb.x(), rgb.y(), rgb.z()})},
          {"counts", payload.AddChannel(counts, 1.0)},
          {"points", channels}};
}

/// Three channels of a series with these names.
Json PoseJson(const Series& series, Payload& payload) {
  Json channels = Json::array();
  for (const char* name : {"x_m", "y_m", "heading_rad"}) {
    channels.push_back(payload.AddChannel(series.at(name), kLengthQuantum_m));
  }
  return channels;
}

bool HasPose(const Series& series) {
  return series.contains("x_m") && series.contains("y_m") && series.contains("heading_rad");
}

Json BelievedJson(Series belief, Payload& payload) {
  const std::vector<double> located = belief.at("located");
  for (const char* name : {"x_m", "y_m", "heading_rad"}) {
    for (std::size_t i = 0; i < located.size(); ++i) {
      if (located[i] == 0.0) belief.at(name)[i] = kNaN;
    }
  }
  return {{"pose", PoseJson(belief, payload)}, {"located", payload.AddChannel(located, 1.0)}};
}

/// A step that shows all that can be seen of values this large: about a 4 000th.
double QuantumOf(const std::vector<double>& values) {
  constexpr double kSmallest = 1e-300;  // a 4 000th of less is no number of full precision
  double largest = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  if (largest < kSmallest) return 1.0;
  return std::pow(10.0, std::floor(std::log10(largest)) - 3.0);
}

const char* GroupOf(const std::string& unit) {
  if (unit == "A") return "Currents";
  if (unit == "N") return "Forces";
  if (unit == "m") return "Lengths";
  if (unit == "deg" || unit == "rad") return "Angles";
  return "Others";
}

/// By the end of a name, as the columns have it: "reeled_m". Empty where it tells none.
const char* UnitOfName(const std::string& name) {
  static constexpr std::pair<const char*, const char*> kEnds[] = {
      {"_m_s", "m/s"}, {"_rad_s", "rad/s"}, {"_deg_s", "deg/s"}, {"_m", "m"},
      {"_mm", "mm"},   {"_rad", "rad"},     {"_deg", "deg"},     {"_s", "s"},
      {"_px", "px"},   {"_a", "A"},         {"_n", "N"}};
  for (const auto& [end, unit] : kEnds) {
    if (name.ends_with(end)) return unit;
  }
  return "";
}

bool HasValues(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return !std::isnan(value); });
}

Json ScalarJson(const Column& column, const char* source, const std::string& group,
                const std::vector<double>& values, Payload& payload) {
  return {{"name", column.name},
          {"unit", column.unit},
          {"meaning", column.meaning},
          {"source", source},
          {"group", group},
          {"channel", payload.AddChannel(values, QuantumOf(values))}};
}

void AddScalars(const Series& series, const std::vector<Column>& columns, const char* source,
                Payload& payload, Json& scalars) {
  for (const Column& column : columns) {
    const auto found = series.find(column.name);
    if (found == series.end() || !HasValues(found->second)) continue;
    scalars.push_back(ScalarJson(column, source, GroupOf(column.unit), found->second, payload));
  }
}

/// Values that the system does not name: a panel has one for each colour of the page.
void AddValues(const Series& series, Payload& payload, Json& scalars) {
  constexpr int kColours = 6;  // of sim/page/web/src/replay/scalars.js
  std::map<std::string, int> counts;
  for (const auto& [name, values] : series) {
    if (!HasValues(values)) continue;
    const Column column{name, UnitOfName(name), "as the controller gives it"};
    const int panel = 1 + counts[column.unit]++ / kColours;
    const std::string group = panel == 1 ? "Values" : "Values " + std::to_string(panel);
    scalars.push_back(ScalarJson(column, "belief", group, values, payload));
  }
}

Json ScalarsJson(const LoggedRun& run, const ReplayFacts& facts, Payload& payload) {
  Json scalars = Json::array();
  std::vector<Column> motors, truth;
  for (const auto& [name, values] : run.currents_a) {
    motors.push_back({name, "A", "current of the motor, as its drive measures it"});
  }
  AddScalars(run.currents_a, motors, "sensor", payload, scalars);
  // The true currents are those, without noise.
  std::copy_if(facts.channels.begin(), facts.channels.end(), std::back_inserter(truth),
               [&](const Column& column) { return column.unit != "A" || motors.empty(); });
  AddScalars(run.truth, truth, "truth", payload, scalars);
  AddScalars(run.sensors, ColumnsOf(run.header.sensors), "sensor", payload, scalars);
  AddScalars(run.belief, facts.beliefs, "belief", payload, scalars);
  AddScalars(run.truth, BeliefErrorColumns(), "belief", payload, scalars);
  AddValues(run.values, payload, scalars);
  return scalars;
}

Json PlansJson(const LoggedRun& run) {
  Json plans = Json::array();
  for (const auto& plan : run.plans) {
    Json points = Json::array();
    for (const Pose2& X : plan.value) points.push_back(Json::array({X.x, X.y}));
    plans.push_back({{"sample", run.SampleAt(plan.time_s)}, {"points", points}});
  }
  return plans;
}

Json PhasesJson(const LoggedRun& run) {
  Json phases = Json::array();
  for (const Timed<LoggedNote>& note : run.notes) {
    if (note.value.name != "phase") continue;
    phases.push_back(Json::array({run.SampleAt(note.time_s), note.value.text}));
  }
  return phases;
}

}  // namespace

Json ReplayPart(const LoggedRun& run, const ReplayFacts& facts, Payload& payload) {
  const std::size_t samples = run.times_s.size();
  if (samples == 0) return nullptr;
  const Pose3 X_GW = Inverse(run.X_WG.front());
  Json json{{"run", facts.run},
            {"scene", facts.scene},
            {"outcome", facts.outcome},
            {"success", facts.success},
            {"sentence", facts.sentence},
            {"command", facts.command},
            {"seed", facts.seed},
            {"state_hash", facts.state_hash},
            {"messages", facts.messages},
            {"samples", samples},
            {"period_s", samples > 1 ? run.times_s[1] - run.times_s[0] : 0.1},
            {"end_s", run.times_s.back() - run.times_s.front()},
            {"X_WD", PlanarJson(ToGround(X_GW * run.X_WD.front()))}};
  json["bodies"] = Json::array();
  std::vector<std::vector<Pose3>> X_GO = run.X_WO;
  for (std::size_t body = 0; body < X_GO.size(); ++body) {
    for (Pose3& X : X_GO[body]) X = X_GW * X;
    json["bodies"].push_back({{"body", body}, {"track", TrackJson(X_GO[body], payload)}});
  }
  json["lines"] = Json::array();
  for (const auto& [name, line] : run.lines) {
    if (!line.empty()) json["lines"].push_back(LineJson(name, line, X_GW, payload));
  }
  if (HasPose(run.truth)) json["pose"] = PoseJson(run.truth, payload);
  if (HasPose(run.belief) && run.belief.contains("located")) {
    json["believed"] = BelievedJson(run.belief, payload);
  }
  json["ground"] = ReplayGround(run, X_GO, payload);
  json["scalars"] = ScalarsJson(run, facts, payload);
  json["sightings"] = SightingsPart(run, facts.pictures, payload);
  if (facts.pictures) json["images"] = ImagesPart(run, facts.most_images, payload);
  json["plans"] = PlansJson(run);
  json["phases"] = PhasesJson(run);
  return json;
}

}  // namespace dockyard
