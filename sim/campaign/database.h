// results.sqlite: the rows of results.csv for those who ask in SQL.
#pragma once

#include <filesystem>

#include "sim/log/results.h"

namespace dockyard {

/// Writes table `runs` with the columns of results.csv: measures and time are REAL, success (0 or
/// 1) and counts INTEGER, labels NUMERIC (a number where the text is one), the rest TEXT: the seed
/// since SQLite's integers end at 2^63, state_hash as 16 hexadecimal digits. NaN and missing are
/// NULL. Names are as in the CSV; SQL needs quotes around "start.r_m". The file is replaced as a
/// whole. Throws IoError.
void WriteDatabase(const std::filesystem::path& path, const FinishedRuns& runs,
                   const RowColumns& columns);

}  // namespace dockyard
