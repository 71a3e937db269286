#include "sim/log/record_files.h"

#include <type_traits>

#include "sim/log/files.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

constexpr const char* kSingleResultFile = "result.csv";

/// Calls visit(name, value) for each column; poses in the dock frame, belief beside the truth.
template <class Visit>
void VisitHistory(const HistorySample& s, Visit&& visit) {
  visit("time_s", s.time_s);
  visit("x_m", s.X_DR.x);
  visit("y_m", s.X_DR.y);
  visit("heading_deg", Degrees(s.X_DR.heading));
  visit("z_m", s.z_m);
  visit("roll_deg", Degrees(s.roll_rad));
  visit("pitch_deg", Degrees(s.pitch_rad));
  visit("arm_deg", Degrees(s.arm_rad));
  visit("tip_depth_m", s.tip_depth_m);
  visit("tip_lateral_m", s.tip_lateral_m);
  visit("tension_n", s.tension_n);
  visit("cone_force_n", s.cone_force_n);
  visit("station_shift_m", s.station_shift_m);
  visit("left_current_a", s.left_current_a);
  visit("right_current_a", s.right_current_a);
  visit("spool_current_a", s.spool_current_a);
  visit("left_sinkage_m", s.left_sinkage_m);
  visit("right_sinkage_m", s.right_sinkage_m);
  visit("phase", s.phase);
  visit("located", s.located);
  visit("believed_x_m", s.X_DR_believed.x);
  visit("believed_y_m", s.X_DR_believed.y);
  visit("believed_heading_deg", Degrees(s.X_DR_believed.heading));
  visit("sightings", s.sighting_count);
  visit("plans", s.plan_count);
  visit("recoveries", s.recoveries);
}

std::string Text(double value) { return NumberText(value); }
std::string Text(const std::string& value) { return CsvCell(value); }
std::string Text(bool value) { return value ? "1" : "0"; }
std::string Text(int value) { return std::to_string(value); }

Json Vector3Json(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// 1 sigma of the board's place [m] and turn [rad] in the rover's axes.
Json SigmaJson(const Eigen::Matrix<double, 6, 6>& covariance) {
  const Eigen::Matrix<double, 6, 1> sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  return {{"p_m", Vector3Json(sigma.head<3>())}, {"turn_rad", Vector3Json(sigma.tail<3>())}};
}

Json MarksJson(const std::vector<SightingReport::Mark>& marks) {
  Json json = Json::array();
  for (const auto& mark : marks) {
    json.push_back({{"id", mark.id},
                    {"camera", mark.right_camera ? "right" : "left"},
                    {"u_px", mark.u_px},
                    {"v_px", mark.v_px}});
  }
  return json;
}

}  // namespace

std::string HistoryCsv(const std::vector<HistorySample>& history) {
  std::string csv;
  const auto add = [&](const std::string& cell) {
    if (!csv.empty() && csv.back() != '\n') csv += ',';
    csv += cell;
  };
  VisitHistory({}, [&](const char* name, const auto&) { add(name); });
  csv += '\n';
  for (const HistorySample& sample : history) {
    VisitHistory(sample, [&](const char*, const auto& value) { add(Text(value)); });
    csv += '\n';
  }
  return csv;
}

Json SightingsJson(const std::vector<SightingSample>& sightings) {
  Json json = Json::array();
  for (const SightingSample& sample : sightings) {
    const SightingReport& report = sample.report;
    json.push_back({{"time_s", sample.time_s},
                    {"true_X_DR", ToJson(sample.X_DR)},
                    {"accepted", report.accepted},
                    {"reason", report.reason},
                    {"method", report.method},
                    {"measured_X_DR", report.accepted ? ToJson(sample.X_DR_measured) : Json()},
                    {"detected_left", report.detected_left},
                    {"detected_right", report.detected_right},
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

Json RowJson(const RunResult& row) {
  Json json;
  const std::vector<std::string> cells = RowCells(row);
  std::size_t i = 0;
  VisitColumns(row, [&](const char* name, const auto& value) {
    using Field = std::decay_t<decltype(value)>;
    const std::string& text = cells[i++];
    if constexpr (std::is_same_v<Field, Outcome>) {
      json[name] = text;
    } else {
      json[name] = std::string_view(name) == "state_hash" ? Json(text) : Json(value);
    }
  });
  return json;
}

void WriteRecordFiles(const std::filesystem::path& dir, const RunRecord& record) {
  MakeFolder(dir);
  Json outcome = RowJson(record.result);
  outcome["failure_note"] = record.failure_note;
  WriteWhole(dir / "history.csv", HistoryCsv(record.history));
  WriteWhole(dir / "sightings.json", SightingsJson(record.sightings).dump(1) + "\n");
  WriteWhole(dir / "plans.json", PlansJson(record.plans).dump(1) + "\n");
  WriteWhole(dir / "outcome.json", outcome.dump(1) + "\n");
}

void WriteSingleResult(const std::filesystem::path& dir, const RunResult& row) {
  WriteWhole(dir / kSingleResultFile, CsvHeader() + "\n" + CsvRow(row) + "\n");
}

std::optional<RunResult> ReadSingleResult(const std::filesystem::path& dir) {
  const std::string text = ReadWhole(dir / kSingleResultFile).value_or("");
  const std::string header = CsvHeader() + "\n";
  if (text.rfind(header, 0) != 0 || text.back() != '\n') return std::nullopt;
  return RowFromCsv(std::string_view(text).substr(header.size(), text.size() - header.size() - 1));
}

}  // namespace dockyard
