#include <cstdio>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/report/column_tables.h"

namespace dockyard {
namespace {

constexpr const char* kColumnsHelp =
    R"(Print the columns of every table that comes out, with units and meanings, as Markdown.

Examples:
  dockyard columns)";

int PrintColumns(const std::vector<System>& systems) {
  std::vector<SystemColumns> columns;
  for (const System& system : systems) {
    columns.push_back({system.name, system.measures, system.channels, system.beliefs});
  }
  std::printf("%s", ColumnsPage(columns).c_str());
  return kExitDone;
}

}  // namespace

void AddColumnsCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  CLI::App* command = app.add_subcommand("columns", kColumnsHelp);
  command->callback([&systems, &exit_code] { exit_code = PrintColumns(systems); });
}

}  // namespace dockyard
