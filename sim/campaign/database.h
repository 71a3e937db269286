// results.sqlite: the rows of results.csv for those who ask in SQL.
#pragma once

#include <filesystem>

#include "sim/campaign/results.h"

namespace dockyard {

/// Writes table `runs`, columns as in results.csv: INTEGER, REAL or TEXT by their kind, docked 0 or
/// 1. seed is TEXT, since SQLite's integers end at 2^63; state_hash is TEXT, 16 hexadecimal digits;
/// NaN is NULL. The file is replaced as a whole. Throws IoError.
void WriteDatabase(const std::filesystem::path& path, const FinishedRuns& runs);

}  // namespace dockyard
