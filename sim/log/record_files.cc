#include "sim/log/record_files.h"

#include "controller/base/check.h"
#include "sim/base/folder.h"
#include "sim/base/text.h"
#include "sim/log/belief_error.h"
#include "sim/log/pose_numbers.h"
#include "sim/log/result_row.h"
#include "sim/log/value_table.h"

namespace dockyard {
namespace {

constexpr const char* kSingleResultFile = "result.csv";
// Assumed, 1 to 64 MiB: a row takes about 1 KiB.
constexpr std::uint64_t kMostResultBytes = 16u << 20;

std::vector<std::string> HistoryNames(const RunRecord& record) {
  std::vector<std::string> names{"time_s", "x_m",         "y_m",         "heading_deg",
                                 "z_m",    "roll_DR_deg", "pitch_DR_deg"};
  for (const Column& channel : record.channels) names.push_back(channel.name);
  for (const NamedSensor& sensor : record.sensors) names.push_back("sensor." + sensor.name);
  names.insert(names.end(),
               {"phase", "located", "believed_x_m", "believed_y_m", "believed_heading_deg",
                "believed_z_m", "believed_roll_deg", "believed_pitch_deg", "sightings", "plans"});
  for (const Column& belief : record.belief_columns) names.push_back(belief.name);
  for (const Column& error : BeliefErrorColumns()) names.push_back(error.name);
  return names;
}

std::vector<std::string> HistoryCells(const HistorySample& sample) {
  std::vector<std::string> cells;
  const auto add_pose = [&cells](const RobotPose& pose) {
    const auto n = PoseNumbers(pose);
    for (const double value :
         {pose.x, pose.y, Degrees(pose.heading), n[3], Degrees(n[4]), Degrees(n[5])}) {
      cells.push_back(NumberText(value));
    }
  };
  cells.push_back(NumberText(sample.time_s));
  add_pose(sample.X_DR);
  for (const double value : sample.channels) cells.push_back(NumberText(value));
  for (const double value : sample.sensed) cells.push_back(NumberText(value));
  cells.push_back(sample.phase);
  cells.push_back(sample.located ? "1" : "0");
  add_pose(sample.X_DR_believed);
  cells.push_back(std::to_string(sample.sighting_count));
  cells.push_back(std::to_string(sample.plan_count));
  for (const double value : sample.beliefs) cells.push_back(NumberText(value));
  for (const double value : BeliefErrors(sample)) cells.push_back(NumberText(value));
  return cells;
}

Json PoseJson(const RobotPose& X_DR) {
  const auto numbers = PoseNumbers(X_DR);
  Json json = Json::object();
  for (std::size_t i = 0; i < numbers.size(); ++i) json[kPoseNames[i]] = numbers[i];
  return json;
}

Json Vector3Json(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// 1 sigma of the board's place [m] and turn [rad] in the rover's axes.
Json SigmaJson(const Eigen::Matrix<double, 6, 6>& covariance) {
  const Eigen::Matrix<double, 6, 1> sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  return {{"p_m", Vector3Json(sigma.head<3>())}, {"turn_rad", Vector3Json(sigma.tail<3>())}};
}

Json MarksJson(const std::vector<SightingReport::Mark>& marks) {
  Json json = Json::array();
  for (const auto& mark : marks) {
    json.push_back(
        {{"id", mark.id}, {"camera", mark.camera}, {"u_px", mark.u_px}, {"v_px", mark.v_px}});
  }
  return json;
}

}  // namespace

std::string HistoryCsv(const RunRecord& record) {
  std::string csv = SafeCsvLine(HistoryNames(record)) + "\n";
  for (const HistorySample& sample : record.history) {
    DOCKYARD_CHECK(sample.channels.size() == record.channels.size() &&
                   sample.sensed.size() == record.sensors.size() &&
                   sample.beliefs.size() == record.belief_columns.size());
    csv += SafeCsvLine(HistoryCells(sample)) + "\n";
  }
  return csv;
}

Json SightingsJson(const std::vector<SightingSample>& sightings) {
  Json json = Json::array();
  for (const SightingSample& sample : sightings) {
    const SightingReport& report = sample.report;
    json.push_back({{"time_s", sample.time_s},
                    {"true_X_DR", PoseJson(sample.X_DR)},
                    {"accepted", report.accepted},
                    {"reason", report.reason},
                    {"method", report.method},
                    {"measured_X_DR", report.accepted ? PoseJson(sample.X_DR_measured) : Json()},
                    {"detected", report.detected},
                    {"reprojection_px", report.reprojection_px},
                    {"X_RB", report.accepted ? ToJson(report.X_RB) : Json()},
                    {"camera_turn_rad", Vector3Json(report.camera_turn_rad)},
                    {"camera_turn_sigma_rad", Vector3Json(report.camera_turn_sigma_rad)},
                    {"sigma", SigmaJson(report.covariance)},
                    {"marks", MarksJson(report.marks)}});
  }
  return json;
}

Json PlansJson(const std::vector<PlanSample>& plans) {
  Json json = Json::array();
  for (const PlanSample& sample : plans) {
    Json arcs = Json::array();
    for (const PlannedArc& arc : sample.arcs) {
      arcs.push_back({{"X_DR_start", ToJson(arc.X_DR_start)},
                      {"length_m", arc.length_m},
                      {"turn_rad", arc.turn_rad}});
    }
    json.push_back({{"time_s", sample.time_s}, {"arcs", arcs}});
  }
  return json;
}

Json OutcomeJson(const RunRecord& record) {
  Json json = RowJson(record.result, record.columns);
  json["failure_note"] = record.failure_note;
  json["limits"] = LimitsJson(record.limits);
  return json;
}

void WriteSightings(const std::filesystem::path& dir, const RunRecord& record) {
  WriteWhole(dir / "sightings.json", SightingsJson(record.sightings).dump(1) + "\n");
}

void WriteRecordFiles(const std::filesystem::path& dir, const RunRecord& record) {
  MakeFolder(dir);
  WriteWhole(dir / "history.csv", HistoryCsv(record));
  if (!record.value_names.empty()) {
    WriteWhole(dir / kValuesFile, ValuesCsv(record));
  } else {
    std::error_code error;
    std::filesystem::remove(dir / kValuesFile, error);  // of an earlier run in this folder
  }
  WriteSightings(dir, record);
  WriteWhole(dir / "plans.json", PlansJson(record.plans).dump(1) + "\n");
  WriteWhole(dir / "outcome.json", OutcomeJson(record).dump(1) + "\n");
}

void WriteSingleResult(const std::filesystem::path& dir, const RunResult& row,
                       const RowColumns& columns) {
  WriteWhole(dir / kSingleResultFile, CsvHeader(columns) + "\n" + CsvRow(row, columns) + "\n");
}

std::optional<RunResult> ReadSingleResult(const std::filesystem::path& dir,
                                          const RowColumns& columns) {
  const std::string text = Folder(dir).Read(kSingleResultFile, kMostResultBytes).value_or("");
  for (const RowColumns& known : {columns, FormerColumns(columns)}) {
    const std::string header = CsvHeader(known) + "\n";
    if (text.rfind(header, 0) != 0 || text.back() != '\n') continue;
    return RowFromCsv(std::string_view(text).substr(header.size(), text.size() - header.size() - 1),
                      known);
  }
  return std::nullopt;
}

}  // namespace dockyard
