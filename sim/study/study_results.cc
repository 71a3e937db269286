#include "sim/study/study_results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "controller/base/check.h"
#include "sim/campaign/statistics.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

double Quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// What was set at a point: a cell for each factor, then the key changed alone and its value.
std::vector<std::string> Settings(const Study& study, const StudyPoint& point) {
  std::vector<std::string> cells;
  for (std::size_t i = 0; i < study.factors.size(); ++i) {
    cells.push_back(study.factors[i].labels[static_cast<std::size_t>(point.level[i])]);
  }
  if (study.one_at_a_time.empty()) return cells;
  if (point.changed < 0) {
    cells.insert(cells.end(), {"", ""});
  } else {
    const StudyFactor& factor = study.one_at_a_time[static_cast<std::size_t>(point.changed)];
    cells.push_back(factor.key);
    cells.push_back(factor.labels[static_cast<std::size_t>(point.changed_level)]);
  }
  return cells;
}

std::string SettingsHeader(const Study& study) {
  std::string header;
  for (const StudyFactor& factor : study.factors) header += CsvCell(factor.key) + ",";
  return header + (study.one_at_a_time.empty() ? "" : "changed,changed_to,");
}

/// A value as people want it: four figures.
std::string Brief(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Points that are told in one line: all with the same settings. In the order of the points.
std::vector<std::pair<int, std::vector<const StudyRow*>>> ByPoint(
    const std::vector<StudyRow>& rows) {
  std::map<int, std::vector<const StudyRow*>> groups;
  for (const StudyRow& row : rows) groups[row.point].push_back(&row);
  return {groups.begin(), groups.end()};
}

/// What it takes to bring the arm in: spool current and peak force on the cone from the mouth
/// to 20 cm deep, before the socket's floor stops it. NaN when the tip never came past the mouth.
struct Entry {
  double current_mean_a = std::nan(""), current_peak_a = std::nan("");
  double force_peak_n = std::nan("");
};

Entry EntryOf(const RunRecord& record) {
  double current_sum = 0.0, current_peak = 0.0, force = 0.0;
  int count = 0;
  for (const HistorySample& sample : record.history) {
    if (sample.tip_depth_m < 0.0) continue;
    if (sample.tip_depth_m > kDockedDepth_m) break;
    current_sum += std::abs(sample.spool_current_a);
    current_peak = std::max(current_peak, std::abs(sample.spool_current_a));
    force = std::max(force, sample.cone_force_n);
    ++count;
  }
  if (count == 0) return {};
  return {
      .current_mean_a = current_sum / count, .current_peak_a = current_peak, .force_peak_n = force};
}

}  // namespace

std::size_t MeasureIndex(const std::string& name) {
  const auto& names = StudyMeasures();
  const auto found = std::find(names.begin(), names.end(), name);
  DOCKYARD_CHECK(found != names.end());
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<double> MeasuresOf(const RunRecord& record) {
  const RunResult& row = record.result;
  const Entry entry = EntryOf(record);
  double arm_up_rad = 0.0, roll_squares = 0.0, advance_m = 0.0, turned_rad = 0.0;
  for (const HistorySample& sample : record.history) {
    arm_up_rad = std::max(arm_up_rad, -(sample.pitch_rad + sample.arm_rad));
    roll_squares += sample.roll_rad * sample.roll_rad;
  }
  const auto samples = static_cast<double>(std::max<std::size_t>(1, record.history.size()));
  if (!record.history.empty()) {
    const Pose2 from = record.history.front().X_DR, to = record.history.back().X_DR;
    advance_m = std::cos(from.heading) * (to.x - from.x) + std::sin(from.heading) * (to.y - from.y);
    turned_rad = WrapPi(to.heading - from.heading);
  }
  return {row.docked ? 1.0 : 0.0,   row.sim_time_s,
          row.tip_depth_m,          row.lateral_error_m,
          row.yaw_error_deg,        row.station_shift_m,
          row.cone_force_peak_n,    record.tension_peak_n,
          row.spool_current_mean_a, row.spool_current_peak_a,
          Degrees(arm_up_rad),      Degrees(std::sqrt(roll_squares / samples)),
          entry.current_mean_a,     entry.current_peak_a,
          entry.force_peak_n,       advance_m,
          Degrees(turned_rad)};
}

Spread SpreadOf(const std::string& measure, const std::vector<const StudyRow*>& rows) {
  Spread spread;
  const std::size_t column = MeasureIndex(measure);
  std::vector<double> values;
  for (const StudyRow* row : rows) {
    if (!row->measures.empty() && !std::isnan(row->measures[column])) {
      values.push_back(row->measures[column]);
    }
  }
  spread.count = static_cast<int>(values.size());
  if (values.empty()) return spread;
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  spread.mean = sum / static_cast<double>(values.size());
  spread.median = Quantile(values, 0.5);
  spread.low = Quantile(values, 0.1);
  spread.high = Quantile(values, 0.9);
  if (measure == "docked") {
    const Interval interval = ClopperPearson(static_cast<int>(std::lround(sum)), spread.count);
    spread.median = spread.mean;
    spread.low = interval.low;
    spread.high = interval.high;
  }
  return spread;
}

std::string StudyRunsCsv(const Study& study, const std::vector<StudyRow>& rows) {
  std::string text = "run,seed," + SettingsHeader(study) + "outcome";
  for (const std::string& name : StudyMeasures()) text += "," + name;
  text += "\n";
  for (const StudyRow& row : rows) {
    text += std::to_string(row.run) + "," + std::to_string(row.seed);
    for (const std::string& cell :
         Settings(study, study.points[static_cast<std::size_t>(row.point)])) {
      text += "," + CsvCell(cell);
    }
    text += "," + row.outcome;
    for (std::size_t i = 0; i < StudyMeasures().size(); ++i) {
      text += "," + (row.measures.empty() ? std::string() : NumberText(row.measures[i]));
    }
    text += "\n";
  }
  return text;
}

std::string StudyPointsCsv(const Study& study, const std::vector<StudyRow>& rows) {
  std::string text = SettingsHeader(study) + "runs,docked,docked_low,docked_high";
  for (const std::string& name : StudyMeasures()) {
    if (name != "docked") text += "," + name + "_mean," + name + "_p10," + name + "_p90";
  }
  text += "\n";
  for (const auto& [index, group] : ByPoint(rows)) {
    for (const std::string& cell : Settings(study, study.points[static_cast<std::size_t>(index)])) {
      text += CsvCell(cell) + ",";
    }
    const Spread share = SpreadOf("docked", group);
    text += std::to_string(share.count) + "," + NumberText(share.mean) + "," +
            NumberText(share.low) + "," + NumberText(share.high);
    for (const std::string& name : StudyMeasures()) {
      if (name == "docked") continue;
      const Spread spread = SpreadOf(name, group);
      text += spread.count == 0 ? ",,,"
                                : "," + NumberText(spread.mean) + "," + NumberText(spread.low) +
                                      "," + NumberText(spread.high);
    }
    text += "\n";
  }
  return text;
}

std::string StudyTable(const Study& study, const std::vector<StudyRow>& rows) {
  std::string text = "|";
  for (const StudyFactor& factor : study.factors) text += " " + factor.key + " |";
  if (!study.one_at_a_time.empty()) text += " changed | to |";
  text += " docked |";
  for (const std::string& name : study.measures) {
    if (name != "docked") text += " " + name + " (10-90 %) |";
  }
  text += "\n" + [&] {
    std::string line;
    for (const char c : text) line += c == '|' ? "|" : "-";
    return line;
  }() + "\n";
  for (const auto& [index, group] : ByPoint(rows)) {
    text += "|";
    for (const std::string& cell : Settings(study, study.points[static_cast<std::size_t>(index)])) {
      text += " " + cell + " |";
    }
    const Spread share = SpreadOf("docked", group);
    text +=
        " " + RateText(static_cast<int>(std::lround(share.mean * share.count)), share.count) + " |";
    for (const std::string& name : study.measures) {
      if (name == "docked") continue;
      const Spread spread = SpreadOf(name, group);
      if (spread.count == 0) {
        text += " |";
        continue;
      }
      text += " " + Brief(spread.median) + " (" + Brief(spread.low) + " to " + Brief(spread.high) +
              ") |";
    }
    text += "\n";
  }
  return text;
}

}  // namespace dockyard
