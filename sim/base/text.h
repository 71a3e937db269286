// Cells of a table as text, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/number_text.h"

namespace dockyard {

/// RFC 4180: quoted where it must be.
std::string CsvCell(std::string_view text);
/// The cells with commas between them, no newline.
std::string CsvLine(const std::vector<std::string>& cells);
/// Cells of one line; none when a quotation is not closed.
std::optional<std::vector<std::string>> SplitCsv(std::string_view line);

}  // namespace dockyard
