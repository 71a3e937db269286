// Separators that a table of comma-separated values has instead of commas.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dockyard {

struct OtherSeparator {
  char mark = 0;
  std::string name;    // "';' (semicolons)"
  std::size_t at = 0;  // offset of the first one in the line
};

/// Of a line without a comma outside quotations; none for a single cell. Spaces count where no
/// other separator is found.
std::optional<OtherSeparator> FindOtherSeparator(std::string_view line);

/// Whether a cell between these marks is a number with a comma in the place of the point.
bool HasDecimalComma(std::string_view line, char mark);

}  // namespace dockyard
