// A run's result row as text: the columns of results.csv, in one place and one order.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/json.h"
#include "sim/log/record.h"

namespace dockyard {

/// The content of a column's cells.
enum class CellKind {
  kInteger,  // decimal, within 32 bits
  kSeed,     // decimal, within 64 bits without sign
  kReal,     // shortest decimal form that reads back to the same bits
  kMeasure,  // as kReal; empty in the row of a run that was lost
  kFlag,     // 1 or 0
  kText,
  kLabel,  // text, which may be a number
  kHash,   // 16 hexadecimal digits
};

struct RowColumn {
  std::string name;
  CellKind kind = CellKind::kText;
};

/// All columns in order: the fixed head, the labels, the outcome, the measures, state_hash. Every
/// name occurs once: a label whose name another column has is called "table.<name>".
std::vector<RowColumn> ColumnsOfRow(const RowColumns& columns);
std::vector<std::string> ColumnNames(const RowColumns& columns);

/// The columns of results that an earlier program wrote. Rows read by them have NaN margins and no
/// success_word.
RowColumns FormerColumns(RowColumns columns);

/// A cell for each column. The row has a value for each label, and a value for each measure or
/// none.
std::vector<std::string> RowCells(const RunResult& row, const RowColumns& columns);

struct DifferingCell {
  std::string column, was, is;
};
/// The columns whose text differs, in order: equal text is equal bits. Where a row was read by
/// former columns, those are compared.
std::vector<DifferingCell> DifferingCells(const RunResult& then, const RunResult& now,
                                          const RowColumns& columns);

/// "run,seed,...,state_hash"
std::string CsvHeader(const RowColumns& columns);
/// One line without its newline.
std::string CsvRow(const RunResult& row, const RowColumns& columns);
/// None when the line is not exactly one whole row, or names an outcome that is not in the columns.
std::optional<RunResult> RowFromCsv(std::string_view line, const RowColumns& columns);
std::optional<RunResult> RowFromCells(const std::vector<std::string>& cells,
                                      const RowColumns& columns);

/// The row by names, in the order of results.csv: success and docked are booleans, labels are text,
/// NaN and missing are null.
Json RowJson(const RunResult& row, const RowColumns& columns);

}  // namespace dockyard
