#include "sim/campaign/database.h"

#include <sqlite3.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/files.h"
#include "sim/base/text.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

using Cells = std::vector<std::string>;
using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

void Demand(int code, int wanted, sqlite3* database, const std::filesystem::path& path) {
  if (code == wanted) return;
  throw IoError("cannot write " + path.string() + ": " + sqlite3_errmsg(database));
}

void Execute(sqlite3* database, const std::string& sql, const std::filesystem::path& path) {
  Demand(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK, database, path);
}

const char* SqlType(CellKind kind) {
  switch (kind) {
    case CellKind::kInteger:
    case CellKind::kFlag:
      return "INTEGER";
    case CellKind::kReal:
    case CellKind::kMeasure:
      return "REAL";
    case CellKind::kLabel:
      return "NUMERIC";
    case CellKind::kSeed:
    case CellKind::kText:
    case CellKind::kHash:
      break;
  }
  return "TEXT";
}

/// As SQL takes any name: in quotes.
std::string SqlName(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string CreateTable(const std::vector<RowColumn>& columns) {
  std::string text;
  for (const RowColumn& column : columns) {
    text += (text.empty() ? "" : ", ") + SqlName(column.name) + " " + SqlType(column.kind);
    if (column.name == "run") text += " PRIMARY KEY";
  }
  return "CREATE TABLE runs (" + text + ")";
}

/// Cells are bound as text, which the columns' types turn into numbers, but for reals: SQLite reads
/// their text to fewer digits than they have.
void BindRow(sqlite3_stmt* insert, const std::vector<RowColumn>& columns, const Cells& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int at = static_cast<int>(i) + 1;
    if (columns[i].kind == CellKind::kReal || columns[i].kind == CellKind::kMeasure) {
      const auto value = NumberFromText(cells[i]);  // SQLite stores NaN as NULL
      sqlite3_bind_double(insert, at, value.value_or(std::nan("")));
    } else {
      sqlite3_bind_text(insert, at, cells[i].c_str(), static_cast<int>(cells[i].size()),
                        SQLITE_TRANSIENT);
    }
  }
}

void Fill(sqlite3* database, const FinishedRuns& runs, const RowColumns& columns,
          const std::filesystem::path& path) {
  const std::vector<RowColumn> named = ColumnsOfRow(columns);
  Execute(database, CreateTable(named), path);
  std::string marks;
  for (std::size_t i = 0; i < named.size(); ++i) marks += i == 0 ? "?" : ",?";
  sqlite3_stmt* raw = nullptr;
  const std::string sql = "INSERT INTO runs VALUES (" + marks + ")";
  Demand(sqlite3_prepare_v2(database, sql.c_str(), -1, &raw, nullptr), SQLITE_OK, database, path);
  const Statement insert(raw, sqlite3_finalize);
  for (const RunResult& result : runs.results) {
    BindRow(insert.get(), named, RowCells(result, columns));
    Demand(sqlite3_step(insert.get()), SQLITE_DONE, database, path);
    sqlite3_reset(insert.get());
  }
}

}  // namespace

void WriteDatabase(const std::filesystem::path& path, const FinishedRuns& runs,
                   const RowColumns& columns) {
  // A name of its own, as two programs may write the same file at once; SQLite goes on with an
  // empty file.
  WholeFile file(path);
  {
    sqlite3* raw = nullptr;
    const int opened =
        sqlite3_open_v2(file.temporary().c_str(), &raw, SQLITE_OPEN_READWRITE, nullptr);
    const Database database(raw, sqlite3_close);
    Demand(opened, SQLITE_OK, raw, path);
    Execute(raw, "PRAGMA journal_mode = OFF", path);  // a file that fails is thrown away
    Execute(raw, "BEGIN", path);
    Fill(raw, runs, columns, path);
    Execute(raw, "COMMIT", path);
  }
  file.Finish(/*to_the_disk=*/false);
}

}  // namespace dockyard
