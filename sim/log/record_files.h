// The readable part of a run's folder: history.csv, sightings.json, plans.json, outcome.json.
// A single run's folder holds its row in result.csv too.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/log/json_io.h"
#include "sim/run/record.h"

namespace dockyard {

/// One line per history sample, header first; angles in degrees, the rest SI.
std::string HistoryCsv(const std::vector<HistorySample>& history);
Json SightingsJson(const std::vector<SightingSample>& sightings);
Json PlansJson(const std::vector<PlanSample>& plans);
/// The result row in the order of results.csv; docked as a boolean, NaN as null.
Json RowJson(const RunResult& row);

/// Writes history.csv, sightings.json, plans.json and outcome.json into the folder, which it makes.
/// Throws IoError.
void WriteRecordFiles(const std::filesystem::path& dir, const RunRecord& record);

/// result.csv: header and row, as a campaign's results.csv has them. Throws IoError.
void WriteSingleResult(const std::filesystem::path& dir, const RunResult& row);
/// None when there is no such file or it holds no whole row.
std::optional<RunResult> ReadSingleResult(const std::filesystem::path& dir);

}  // namespace dockyard
