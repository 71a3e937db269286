// Closes an MCAP file that was cut short, as by a kill -9.
#pragma once

#include <filesystem>

namespace dockyard {

/// Drops what is not whole at the end, and writes the end anew. False: the file has its end, and
/// stays as it is. Throws IoError, and DataError for a file that is damaged before its end, or that
/// is none.
bool RepairMcap(const std::filesystem::path& file);

}  // namespace dockyard
