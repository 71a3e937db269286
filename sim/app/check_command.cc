#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "models/read/config_error.h"
#include "sim/app/check_answer.h"
#include "sim/app/check_file.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"

namespace dockyard {
namespace {

constexpr const char* kCheckHelp =
    R"(Check files: scenarios, campaigns, robots, targets, soils, cameras, URDF, meshes.

Examples:
  dockyard check {campaign}
  dockyard check {robot}
  dockyard check --all --json {robot}

Prints a line for each good file on stdout. The first fault of each bad one goes to
stderr, with --all every fault of a URDF file, also of one that a robot's file names;
for every other kind --all also gives the first fault alone. Warnings go to stderr and
change no exit code; those of a URDF file also come for a robot, target, scenario or
campaign that names it.
A URDF file's package://NAME/PATH is found by the package.xml of that name above the
file, or in the packages in its own or next to it; --package NAME=DIR names it. A file
with macros (.xacro) is expanded by the program xacro, if it is on PATH.
--json prints {files: [{file, kind, summary, faults, left_out, warnings}], faults,
left_out, warnings}, the last three over all files. A fault is {file, line, column,
text}; left_out counts elements that change nothing here.
Exit code 3: a file is bad.)";

struct CheckArguments {
  std::vector<std::string> files, packages;
  bool all = false, json = false;
};

CheckOptions OptionsOf(const CheckArguments& arguments) {
  CheckOptions options;
  for (const std::string& package : arguments.packages) {
    const std::size_t equals = package.find('=');
    const bool whole = equals != std::string::npos && equals > 0 && equals + 1 < package.size();
    if (!whole) throw UsageError("--package: expected NAME=DIR, found '" + package + "'");
    const std::string folder = package.substr(equals + 1);
    if (!std::filesystem::is_directory(folder)) {
      throw UsageError("--package: expected a folder, found none at '" + folder + "'");
    }
    options.packages[package.substr(0, equals)] = folder;
  }
  return options;
}

CheckedFile CheckOne(const std::string& file, const CheckArguments& arguments,
                     const CheckOptions& options, const std::vector<System>& systems) {
  CheckedFile checked{file, {}, {}};
  try {
    checked.check = CheckFile(file, systems, options);
  } catch (const ConfigError& error) {
    checked.faults = {error.what()};
    if (!arguments.all && !arguments.json) return checked;
    UrdfFindings found = FindFaults(file, systems, options);
    if (arguments.all && !found.faults.empty()) checked.faults = std::move(found.faults);
    checked.check.left_out = std::move(found.left_out);
  }
  return checked;
}

int Check(const CheckArguments& arguments, Invocation& call) {
  const CheckOptions options = OptionsOf(arguments);
  std::vector<CheckedFile> files;
  int exit_code = kExitDone;
  for (const std::string& file : arguments.files) {
    files.push_back(CheckOne(file, arguments, options, call.systems));
    const CheckedFile& checked = files.back();
    for (const std::string& fault : checked.faults) PrintError(fault);
    if (!checked.faults.empty()) exit_code = kExitBadInput;
    for (const std::string& text : checked.check.warnings) {
      const bool placed = text.starts_with(file) || PlaceOf(text, file).file != file;
      Warn(placed ? text : file + ": " + text, &call.warnings);
    }
    if (arguments.json || !checked.faults.empty()) continue;
    std::printf("%s: %s: %s\n", file.c_str(), checked.check.kind.c_str(),
                checked.check.summary.c_str());
  }
  if (arguments.json) std::printf("%s\n", CheckAnswer(files, call.warnings).c_str());
  return exit_code;
}

}  // namespace

void AddCheckCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand("check", kCheckHelp);
  command->add_option("FILE", arguments->files, "files to check")->required();
  command->add_flag("--all", arguments->all, "every fault of a URDF file, not the first alone");
  command->add_flag("--json", arguments->json, "one JSON object for all files");
  command->add_option("--package", arguments->packages, "NAME=DIR: the folder of a ROS package")
      ->expected(1)
      ->take_all();
  command->callback([arguments, &call] { call.exit_code = Check(*arguments, call); });
}

}  // namespace dockyard
