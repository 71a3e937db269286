#include "models/read/csv_table.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/csv_separator.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

struct Cell {
  std::string text;
  int column = 0;
};

/// The end of a cell that begins with a quotation mark: behind the mark that closes it, or npos.
std::size_t EndOfQuotation(std::string_view line, std::size_t begin) {
  for (std::size_t at = begin + 1; at < line.size(); ++at) {
    if (line[at] != '"') continue;
    if (at + 1 == line.size() || line[at + 1] != '"') return at + 1;
    ++at;  // two marks stand for one
  }
  return std::string_view::npos;
}

/// Takes the marks off.
std::string Unquoted(std::string_view quotation) {
  std::string text;
  for (std::size_t at = 1; at + 1 < quotation.size(); ++at) {
    text += quotation[at];
    if (quotation[at] == '"') ++at;
  }
  return text;
}

/// Cells of RFC 4180 with spaces around them, each on one line.
std::vector<Cell> Split(std::string_view line, const YamlPlace& place) {
  std::vector<Cell> cells;
  std::size_t begin = 0;
  while (true) {
    while (begin < line.size() && line[begin] == ' ') ++begin;
    const int column = static_cast<int>(begin) + 1;
    const bool quoted = begin < line.size() && line[begin] == '"';
    const std::size_t quotation = quoted ? EndOfQuotation(line, begin) : begin;
    const std::size_t comma =
        quotation == std::string_view::npos ? quotation : line.find(',', quotation);
    std::string_view cell = line.substr(begin, comma - begin);
    while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
    if (quoted && (quotation == std::string_view::npos || cell.size() != quotation - begin)) {
      throw ConfigError(YamlPlace{place.source, place.line, column}.Text() +
                        ": expected one quotation as the whole cell");
    }
    cells.push_back({quoted ? Unquoted(cell) : std::string(cell), column});
    if (comma == std::string_view::npos) return cells;
    begin = comma + 1;
  }
}

// Readers look names up one by one, so that their work grows with the columns squared: a header of
// 100 000 took minutes.
constexpr std::size_t kMaxColumns = 200;

class Table {
 public:
  explicit Table(const std::string& file) : source_(std::make_shared<const std::string>(file)) {
    list_.kind = YamlNode::Kind::kSequence;
    list_.place = {source_, 1, 1};
  }
  YamlNode Take() { return std::move(list_); }

  YamlPlace PlaceOf(int line, std::size_t at = 0) const {
    return {source_, line, static_cast<int>(at) + 1};
  }
  bool has_header() const { return !header_.empty(); }
  /// Whether a line without a comma can be a whole one.
  bool may_have_one_cell() const { return header_.size() <= 1; }

  void AddLine(const std::vector<Cell>& cells, int line) {
    if (header_.empty()) {
      TakeHeader(cells, line);
    } else {
      TakeRow(cells, line);
    }
  }

 private:
  [[noreturn]] void Refuse(int line, int column, const std::string& what) const {
    throw ConfigError(YamlPlace{source_, line, column}.Text() + ": " + what);
  }
  void RefuseControls(const Cell& cell, int line) const {
    if (const auto found = FirstControl(cell.text)) {
      Refuse(line, cell.column,
             "expected text without control characters, found " + CharacterName(*found) +
                 (*found == U'\t' ? " (a tab)" : ""));
    }
  }
  void TakeHeader(const std::vector<Cell>& cells, int line) {
    if (cells.size() > kMaxColumns) {
      Refuse(line, cells[kMaxColumns].column,
             "expected at most " + std::to_string(kMaxColumns) + " columns, found " +
                 std::to_string(cells.size()));
    }
    for (const Cell& cell : cells) {
      RefuseControls(cell, line);
      if (cell.text.empty()) Refuse(line, cell.column, "expected a column's name, found nothing");
      for (const YamlNode::Key& key : header_) {
        if (key.name == cell.text) Refuse(line, cell.column, cell.text + ": given twice");
      }
      header_.push_back({cell.text, {source_, line, cell.column}});
    }
  }
  void TakeRow(const std::vector<Cell>& cells, int line) {
    if (cells.size() != header_.size()) {
      // A number with a decimal comma makes two cells.
      const bool commas = cells.size() == 2 * header_.size() && header_.size() > 1;
      Refuse(line, cells.back().column,
             "expected " + std::to_string(header_.size()) + " cells as in the header, found " +
                 std::to_string(cells.size()) +
                 (commas ? " (decimal commas? expected decimal points)" : ""));
    }
    YamlNode row;
    row.kind = YamlNode::Kind::kMapping;
    row.place = {source_, line, 1};
    row.keys = header_;
    for (const Cell& cell : cells) {
      RefuseControls(cell, line);
      YamlNode value;
      value.kind = cell.text.empty() ? YamlNode::Kind::kNull : YamlNode::Kind::kScalar;
      value.place = {source_, line, cell.column};
      value.scalar = cell.text;
      row.items.push_back(std::move(value));
    }
    list_.items.push_back(std::move(row));
  }

  std::shared_ptr<const std::string> source_;
  std::vector<YamlNode::Key> header_;
  YamlNode list_;
};

/// The lines, ended as on any system: \n, \r\n, or \r alone (Excel's "CSV (Macintosh)").
std::vector<std::string_view> LinesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    lines.push_back(text.substr(0, end));
    const std::size_t ending = text.substr(end, 2) == "\r\n" ? 2 : 1;
    text.remove_prefix(std::min(end + ending, text.size()));
  }
  return lines;
}

/// A spreadsheet leaves rows of empty cells (",,,") below a table: as blank as an empty line.
bool IsBlank(std::string_view line) { return line.find_first_not_of(" \t,") == line.npos; }

/// Excel's first line "sep=X" names the separator.
std::optional<char> NamedSeparator(std::string_view line) {
  if (line.size() > 4 && line.front() == '"') line = line.substr(1, line.find_last_not_of('"'));
  const bool names = line.size() == 5 && (line.starts_with("sep=") || line.starts_with("SEP="));
  return names ? std::optional(line[4]) : std::nullopt;
}

/// Refuses a line whose cells are separated by something else than commas.
void CheckSeparator(const Table& table, const std::vector<std::string_view>& lines,
                    std::size_t index) {
  if (table.has_header() && table.may_have_one_cell()) return;
  const std::optional<OtherSeparator> other = FindOtherSeparator(lines[index]);
  if (!other) return;
  const bool decimal_commas =
      std::any_of(lines.begin() + static_cast<std::ptrdiff_t>(index), lines.end(),
                  [&](std::string_view line) { return HasDecimalComma(line, other->mark); });
  throw ConfigError(table.PlaceOf(static_cast<int>(index) + 1, other->at).Text() +
                    ": expected cells separated by commas, found " + other->name +
                    (decimal_commas ? " and decimal commas" : "") +
                    "; save the table with commas between the cells" +
                    (decimal_commas ? " and decimal points" : ""));
}

}  // namespace

YamlNode LoadCsv(const std::string& file, std::size_t max_bytes) {
  const std::string text = ReadText(file, max_bytes);
  const std::vector<std::string_view> lines = LinesOf(text);
  Table table(file);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string_view line = lines[i];
    if (line.find_first_not_of(" \t") == std::string_view::npos || line.front() == '#') continue;
    if (table.has_header() && IsBlank(line)) continue;
    if (!table.has_header() && NamedSeparator(line) == ',') continue;
    CheckSeparator(table, lines, i);
    const int number = static_cast<int>(i) + 1;
    table.AddLine(Split(line, table.PlaceOf(number)), number);
  }
  return table.Take();
}

}  // namespace dockyard
