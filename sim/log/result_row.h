// A run's result row as text: the columns of results.csv, in one place and one order.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "models/number_text.h"
#include "models/scenario.h"
#include "sim/run/record.h"

namespace dockyard {

/// Calls visit(name, field) for every column in order; Row is RunResult or const RunResult.
/// state_hash is the one column that is written in hexadecimal.
template <class Row, class Visit>
void VisitColumns(Row& row, Visit&& visit) {
  visit("run", row.run);
  visit("seed", row.seed);
  visit("controller", row.controller);
  visit("region", row.region);
  visit("day", row.day);
  visit("soil", row.soil);
  visit("light", row.light);
  visit("r_m", row.r_m);
  visit("alpha_deg", row.alpha_deg);
  visit("heading_deg", row.heading_deg);
  visit("docked", row.docked);
  visit("outcome", row.outcome);
  visit("sim_time_s", row.sim_time_s);
  visit("image_pairs", row.image_pairs);
  visit("recoveries", row.recoveries);
  visit("tip_depth_m", row.tip_depth_m);
  visit("lateral_error_m", row.lateral_error_m);
  visit("yaw_error_deg", row.yaw_error_deg);
  visit("station_shift_m", row.station_shift_m);
  visit("cone_force_peak_n", row.cone_force_peak_n);
  visit("spool_current_mean_a", row.spool_current_mean_a);
  visit("spool_current_peak_a", row.spool_current_peak_a);
  visit("wheel_current_mean_a", row.wheel_current_mean_a);
  visit("wheel_current_peak_a", row.wheel_current_peak_a);
  visit("state_hash", row.state_hash);
}

/// The columns that are known before the run: what a crashed run's row holds, and where a run's
/// row begins. Angles in degrees are rounded to 1e-9, so that a table's 15 stays 15.
RunResult StartOfRow(const CampaignRun& run);

/// "run,seed,...,state_hash"
std::string CsvHeader();
/// One line without its newline. Doubles in the shortest form that reads back to the same bits;
/// docked is 1 or 0; state_hash 16 hexadecimal digits.
std::string CsvRow(const RunResult& row);
/// The same as text, cell by cell.
std::vector<std::string> RowCells(const RunResult& row);
/// None when the line is not exactly one whole row.
std::optional<RunResult> RowFromCsv(std::string_view line);
/// Names of the columns whose text differs: equal text is equal bits.
std::vector<std::string> DifferingColumns(const RunResult& a, const RunResult& b);

/// RFC 4180: quoted where it must be.
std::string CsvCell(std::string_view text);
/// Cells of one line; none when a quotation is left open.
std::optional<std::vector<std::string>> SplitCsv(std::string_view line);

}  // namespace dockyard
