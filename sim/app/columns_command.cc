#include <cstdio>
#include <memory>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
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

int PrintColumnsJson(const std::vector<SystemColumns>& systems,
                     const std::vector<std::string>& warnings) {
  Json answer{{"tables", Json::array()}, {"systems", Json::array()}, {"warnings", warnings}};
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

int PrintColumns(const Invocation& call, bool as_json) {
  std::vector<SystemColumns> columns;
  for (const System& system : call.systems) {
    columns.push_back(
        {system.name, system.columns.measures, system.columns.channels, system.columns.beliefs});
  }
  if (as_json) return PrintColumnsJson(columns, call.warnings);
  std::printf("%s", ColumnsPage(columns).c_str());
  return kExitDone;
}

}  // namespace

void AddColumnsCommand(CLI::App& app, Invocation& call) {
  CLI::App* command = app.add_subcommand("columns", kColumnsHelp);
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "print JSON");
  command->callback([json, &call] { call.exit_code = PrintColumns(call, *json); });
}

}  // namespace dockyard
