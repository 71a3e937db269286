// Cells of a table as text, and back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/number_text.h"

namespace dockyard {

/// With commas between them.
std::string Listed(const std::vector<std::string>& names);

/// RFC 4180: quoted where it must be.
std::string CsvCell(std::string_view text);
/// The cells with commas between them, no newline.
std::string CsvLine(const std::vector<std::string>& cells);
/// Cells of one line; none when a quotation is not closed.
std::optional<std::vector<std::string>> SplitCsv(std::string_view line);

/// The same for tables that people open. A spreadsheet takes a cell for a formula that begins with
/// = + - @, a tab or a carriage return: where it is no number, an apostrophe is put before it, and
/// before apostrophes that such a cell begins with already.
std::string SafeCsvLine(std::vector<std::string> cells);
/// The cells that SafeCsvLine was given.
std::optional<std::vector<std::string>> SplitSafeCsv(std::string_view line);

}  // namespace dockyard
