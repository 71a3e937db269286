#include "sim/base/text.h"

#include <algorithm>

namespace dockyard {
namespace {

/// Whether a spreadsheet would take the text for a formula, without the apostrophes before it.
bool IsFormula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  if (text.empty() || std::string_view("=+-@\t\r").find(text[0]) == text.npos) return false;
  return !NumberFromText(std::string(text)).has_value();
}

}  // namespace

std::string Listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string CsvCell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += (c == '\n' || c == '\r') ? ' ' : c;  // a row is a line, always
  }
  return quoted + '"';
}

std::string CsvLine(const std::vector<std::string>& cells) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) line += (i == 0 ? "" : ",") + CsvCell(cells[i]);
  return line;
}

std::optional<std::vector<std::string>> SplitCsv(std::string_view line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      cells.back() += line[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  if (quoted) return std::nullopt;
  return cells;
}

std::string SafeCsvLine(std::vector<std::string> cells) {
  for (std::string& cell : cells) {
    if (IsFormula(cell)) cell.insert(cell.begin(), '\'');
  }
  return CsvLine(cells);
}

std::optional<std::vector<std::string>> SplitSafeCsv(std::string_view line) {
  auto cells = SplitCsv(line);
  if (!cells) return cells;
  for (std::string& cell : *cells) {
    if (cell.starts_with('\'') && IsFormula(cell)) cell.erase(cell.begin());
  }
  return cells;
}

}  // namespace dockyard
