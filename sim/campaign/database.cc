#include "sim/campaign/database.h"

#include <sqlite3.h>

#include <memory>
#include <string>
#include <system_error>
#include <type_traits>

#include "sim/log/files.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

void Demand(int code, int wanted, sqlite3* database, const std::filesystem::path& path) {
  if (code == wanted) return;
  throw IoError("cannot write " + path.string() + ": " + sqlite3_errmsg(database));
}

void Execute(sqlite3* database, const std::string& sql, const std::filesystem::path& path) {
  Demand(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK, database, path);
}

template <class T>
const char* SqlType(const char* name, const T&) {
  if (std::is_same_v<T, double>) return "REAL";
  const bool small = std::is_same_v<T, int> || std::is_same_v<T, bool>;
  return std::string_view(name) == "run" ? "INTEGER PRIMARY KEY" : small ? "INTEGER" : "TEXT";
}

std::string CreateTable() {
  const RunResult row;
  std::string columns;
  VisitColumns(row, [&](const char* name, const auto& value) {
    columns += (columns.empty() ? "" : ", ") + std::string(name) + " " + SqlType(name, value);
  });
  return "CREATE TABLE runs (" + columns + ")";
}

void BindRow(sqlite3_stmt* insert, const RunResult& row) {
  const std::vector<std::string> cells = RowCells(row);
  int column = 0;
  VisitColumns(row, [&](const char*, const auto& value) {
    using Field = std::decay_t<decltype(value)>;
    const std::string& text = cells[static_cast<std::size_t>(column++)];
    if constexpr (std::is_same_v<Field, double>) {
      sqlite3_bind_double(insert, column, value);  // SQLite stores NaN as NULL
    } else if constexpr (std::is_same_v<Field, int> || std::is_same_v<Field, bool>) {
      sqlite3_bind_int(insert, column, value);
    } else {
      sqlite3_bind_text(insert, column, text.c_str(), -1, SQLITE_TRANSIENT);
    }
  });
}

void Fill(sqlite3* database, const FinishedRuns& runs, const std::filesystem::path& path) {
  Execute(database, CreateTable(), path);
  std::string marks;
  for (std::size_t i = 0; i < RowCells({}).size(); ++i) marks += i == 0 ? "?" : ",?";
  sqlite3_stmt* raw = nullptr;
  const std::string sql = "INSERT INTO runs VALUES (" + marks + ")";
  Demand(sqlite3_prepare_v2(database, sql.c_str(), -1, &raw, nullptr), SQLITE_OK, database, path);
  const Statement insert(raw, sqlite3_finalize);
  for (const auto& [number, run] : runs) {
    BindRow(insert.get(), run.result);
    Demand(sqlite3_step(insert.get()), SQLITE_DONE, database, path);
    sqlite3_reset(insert.get());
  }
}

}  // namespace

void WriteDatabase(const std::filesystem::path& path, const FinishedRuns& runs) {
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  {
    sqlite3* raw = nullptr;
    const int opened = sqlite3_open(temporary.c_str(), &raw);
    const Database database(raw, sqlite3_close);
    Demand(opened, SQLITE_OK, raw, path);
    Execute(raw, "BEGIN", path);
    Fill(raw, runs, path);
    Execute(raw, "COMMIT", path);
  }
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) throw IoError("cannot write " + path.string() + ": " + error.message());
}

}  // namespace dockyard
