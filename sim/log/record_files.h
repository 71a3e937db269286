// The readable part of a run's folder: history.csv, values.csv, sightings.json, plans.json,
// outcome.json.
// A single run's folder holds its row in result.csv too.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/base/json.h"
#include "sim/log/record.h"

namespace dockyard {

/// One line per sample of the history, header first: time and true pose, the system's channels, the
/// believed pose with the counts of sightings and plans, the system's beliefs. Headings in degrees,
/// channels and beliefs in their columns' units.
std::string HistoryCsv(const RunRecord& record);
/// `detected` counts by camera; each mark names its camera by index.
Json SightingsJson(const std::vector<SightingSample>& sightings);
Json PlansJson(const std::vector<PlanSample>& plans);
/// The row, failure_note, and `limits`: those that the judge held the run against.
Json OutcomeJson(const RunRecord& record);

/// Writes history.csv, sightings.json, plans.json and outcome.json into
/// the folder, which it makes, and values.csv where the controller has values that the system does
/// not name. Throws IoError.
void WriteRecordFiles(const std::filesystem::path& dir, const RunRecord& record);

/// sightings.json alone.
void WriteSightings(const std::filesystem::path& dir, const RunRecord& record);

/// result.csv: header and row, as a campaign's results.csv has them. Throws IoError.
void WriteSingleResult(const std::filesystem::path& dir, const RunResult& row,
                       const RowColumns& columns);
/// None when there is no such file or it holds no whole row of these columns or of the
/// former ones.
std::optional<RunResult> ReadSingleResult(const std::filesystem::path& dir,
                                          const RowColumns& columns);

}  // namespace dockyard
