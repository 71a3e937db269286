#include <cstdio>
#include <memory>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"
#include "sim/base/json.h"
#include "sim/report/column_tables.h"

namespace dockyard {
namespace {

constexpr const char* kColumnsHelp =
    R"(Print the columns of every table that comes out, with units and meanings, as Markdown.

Examples:
  dockyard columns
  dockyard columns --json)";

Json ListOf(const std::vector<Column>& columns) {
  Json list = Json::array();
  for (const Column& column : columns) {
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
  }
  return list;
}

int PrintColumnsJson(const std::vector<SystemColumns>& systems) {
  Json answer{{"tables", Json::array()}, {"systems", Json::array()}, {"warnings", WarningsSaid()}};
  for (const ColumnTable& table : ColumnTables()) {
    answer["tables"].push_back({{"file", table.file}, {"columns", ListOf(table.columns)}});
  }
  for (const SystemColumns& system : systems) {
    answer["systems"].push_back({{"system", system.system},
                                 {"measures", ListOf(system.measures)},
                                 {"channels", ListOf(system.channels)},
                                 {"beliefs", ListOf(system.beliefs)}});
  }
  std::printf("%s\n", answer.dump(1).c_str());
  return kExitDone;
}

int PrintColumns(const std::vector<System>& systems, bool as_json) {
  std::vector<SystemColumns> columns;
  for (const System& system : systems) {
    columns.push_back({system.name, system.measures, system.channels, system.beliefs});
  }
  if (as_json) return PrintColumnsJson(columns);
  std::printf("%s", ColumnsPage(columns).c_str());
  return kExitDone;
}

}  // namespace

void AddColumnsCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  CLI::App* command = app.add_subcommand("columns", kColumnsHelp);
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print JSON");
  command->callback([json, &systems, &exit_code] { exit_code = PrintColumns(systems, *json); });
}

}  // namespace dockyard
