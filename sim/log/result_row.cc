#include "sim/log/result_row.h"

#include <charconv>
#include <cmath>
#include <type_traits>

namespace dockyard {
namespace {

template <class T>
std::string IntegerText(T value, int base = 10) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value, base);
  return std::string(text, end.ptr);
}

template <class T>
bool ReadInteger(std::string_view text, T& value, int base = 10) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, base);
  return read.ec == std::errc() && read.ptr == end && !text.empty();
}

std::string HexText(std::uint64_t value) {
  const std::string digits = IntegerText(value, 16);
  return std::string(16 - digits.size(), '0') + digits;
}

template <class T>
std::string CellText(std::string_view name, const T& value) {
  if constexpr (std::is_same_v<T, std::string>)
    return value;
  else if constexpr (std::is_same_v<T, double>)
    return NumberText(value);
  else if constexpr (std::is_same_v<T, bool>)
    return value ? "1" : "0";
  else if constexpr (std::is_same_v<T, Outcome>)
    return dockyard::Name(value);
  else
    return name == "state_hash" ? HexText(static_cast<std::uint64_t>(value)) : IntegerText(value);
}

bool ReadCell(const std::string& text, std::string_view, std::string& value) {
  value = text;
  return true;
}
bool ReadCell(const std::string& text, std::string_view, double& value) {
  const auto number = NumberFromText(text);
  if (number) value = *number;
  return number.has_value();
}
bool ReadCell(const std::string& text, std::string_view, bool& value) {
  value = text == "1";
  return text == "0" || text == "1";
}
bool ReadCell(const std::string& text, std::string_view, Outcome& value) {
  const auto outcome = OutcomeFromName(text);
  if (outcome) value = *outcome;
  return outcome.has_value();
}
bool ReadCell(const std::string& text, std::string_view, int& value) {
  return ReadInteger(text, value);
}
bool ReadCell(const std::string& text, std::string_view name, std::uint64_t& value) {
  if (name != "state_hash") return ReadInteger(text, value);
  return text.size() == 16 && ReadInteger(text, value, 16);
}

double RoundedDegrees(double angle_rad) { return std::round(Degrees(angle_rad) * 1e9) / 1e9; }

}  // namespace

RunResult StartOfRow(const CampaignRun& run) {
  RunResult row;
  row.run = run.run;
  row.seed = run.scenario.seed;
  row.controller = run.scenario.controller;
  row.region = run.region;
  row.day = run.day;
  row.soil = run.soil;
  row.light = LightName(run.scenario.light);
  row.r_m = run.scenario.start.r_m;
  row.alpha_deg = RoundedDegrees(run.scenario.start.alpha_rad);
  row.heading_deg = RoundedDegrees(run.scenario.start.heading_rad);
  return row;
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

std::string CsvHeader() {
  const RunResult row;
  std::string header;
  VisitColumns(row, [&](const char* name, const auto&) {
    if (!header.empty()) header += ',';
    header += name;
  });
  return header;
}

std::vector<std::string> RowCells(const RunResult& row) {
  std::vector<std::string> cells;
  VisitColumns(
      row, [&](const char* name, const auto& value) { cells.push_back(CellText(name, value)); });
  return cells;
}

std::string CsvRow(const RunResult& row) {
  std::string line;
  for (const std::string& cell : RowCells(row)) {
    if (!line.empty()) line += ',';
    line += CsvCell(cell);
  }
  return line;
}

std::optional<RunResult> RowFromCsv(std::string_view line) {
  const auto cells = SplitCsv(line);
  if (!cells) return std::nullopt;
  RunResult row;
  std::size_t next = 0;
  bool good = true;
  VisitColumns(row, [&](const char* column, auto& value) {
    good = good && next < cells->size() && ReadCell((*cells)[next], column, value);
    ++next;
  });
  if (!good || next != cells->size()) return std::nullopt;
  return row;
}

std::vector<std::string> DifferingColumns(const RunResult& a, const RunResult& b) {
  const std::vector<std::string> cells_a = RowCells(a), cells_b = RowCells(b);
  std::vector<std::string> names;
  std::size_t i = 0;
  VisitColumns(a, [&](const char* name, const auto&) {
    if (cells_a[i] != cells_b[i]) names.push_back(name);
    ++i;
  });
  return names;
}

}  // namespace dockyard
