#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "models/read/config_error.h"
#include "sim/app/check_file.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"

namespace dockyard {
namespace {

constexpr const char* kCheckHelp =
    R"(Check input files: scenarios, campaigns, rovers, stations, soils, URDF, meshes.

Examples:
  dockyard check {campaign}
  dockyard check {robot}

Prints a line for each good file on stdout and the first fault of each bad one on stderr.
Exit code 3: a file is bad.)";

int Check(const std::vector<std::string>& files, const std::vector<System>& systems) {
  int exit_code = kExitDone;
  for (const std::string& file : files) {
    try {
      const FileCheck check = CheckFile(file, systems);
      std::printf("%s: %s: %s\n", file.c_str(), check.kind.c_str(), check.summary.c_str());
    } catch (const ConfigError& error) {
      PrintError(error.what());
      exit_code = kExitBadInput;
    }
  }
  return exit_code;
}

}  // namespace

void AddCheckCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("check", kCheckHelp);
  command->add_option("FILE", *files, "files to check")->required();
  command->callback([files, &systems, &exit_code] { exit_code = Check(*files, systems); });
}

}  // namespace dockyard
