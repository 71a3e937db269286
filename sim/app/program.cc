#include "sim/app/program.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "sim/app/commands.h"
#include "sim/app/examples.h"
#include "sim/app/exit_codes.h"
#include "sim/app/failure.h"
#include "sim/app/help.h"
#include "sim/app/parse_fault.h"
#include "sim/app/terminal.h"
#include "sim/base/called_as.h"
#include "sim/base/math_pin.h"

namespace dockyard {
namespace {

constexpr const char* kProgramHelp = R"(Dockyard: a physics testbed for autonomous rover docking.
Examples:
  dockyard run {scenario}
  dockyard campaign {campaign})";

/// Examples are to be pasted: they name the program as it was called and files of its first system.
void FillExamples(CLI::App& app, const std::string& program, const ExampleFiles& files) {
  app.description(WithExamples(app.get_description(), program, files));
  for (CLI::App* command : app.get_subcommands({})) FillExamples(*command, program, files);
}

/// The value of an option given as `--name value` or `--name=value`; empty if it is not.
std::string ValueOf(const std::vector<std::string>& words, const std::string& option) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) return words[i + 1];
    if (words[i].rfind(option + "=", 0) == 0) return words[i].substr(option.size() + 1);
  }
  return "";
}

/// The exit code of `detect` where the robot's system has a perception of its own.
std::optional<int> DetectBySystem(int argc, char** argv, const std::vector<System>& systems) {
  if (argc < 2 || std::string(argv[1]) != "detect") return std::nullopt;
  const std::vector<std::string> words(argv + 2, argv + argc);
  const std::string robot = ValueOf(words, "--robot");
  if (robot.empty()) return std::nullopt;
  for (const System& system : systems) {
    if (system.detect && system.check_file && system.check_file(robot)) {
      return system.detect(words);
    }
  }
  return std::nullopt;
}

/// Whether the words ask for more than help or a check of files: for numbers, whose bits must not
/// depend on the processor.
bool AskForNumbers(int argc, char** argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  if (words.empty() || words[0].empty() || words[0][0] == '-') return false;
  for (const char* without : {"check", "help", "completion", "schema"}) {
    if (words[0] == without) return false;
  }
  return std::none_of(words.begin(), words.end(),
                      [](const std::string& word) { return word == "--help" || word == "-h"; });
}

/// Throws UsageError for a first word that names no command.
void RequireCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
  }
  throw UsageError(UnknownCommand(app, argv[1]));
}

bool AsksForJson(int argc, char** argv) {
  return std::any_of(argv + std::min(argc, 1), argv + argc,
                     [](const char* word) { return std::string(word) == "--json"; });
}

/// The commands that were added since the last call are of this group.
void EndGroup(CLI::App& app, const char* group) {
  for (CLI::App* command : app.get_subcommands({})) {
    if (command->get_group() == "Subcommands") command->group(group);
  }
}

void AddCommands(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  AddRunCommand(app, systems, exit_code);
  AddCampaignCommand(app, systems, exit_code);
  AddSubmitCommand(app, systems, exit_code);
  AddMergeCommand(app, systems, exit_code);
  AddReproduceCommand(app, systems, exit_code);
  EndGroup(app, "Run");
  AddReplayCommand(app, systems, exit_code);
  AddReportCommand(app, systems, exit_code);
  AddFramesCommand(app, systems, exit_code);
  AddAcceptCommand(app, systems, exit_code);
  AddCompareCommand(app, systems, exit_code);
  AddColumnsCommand(app, systems, exit_code);
  EndGroup(app, "Results");
  AddViewCommand(app, systems, exit_code);
  AddCameraCommand(app, exit_code);
  AddDetectCommand(app, systems, exit_code);
  AddPoseCommand(app, systems, exit_code);
  AddStereoCommand(app, exit_code);
  AddBoardCommand(app, systems, exit_code);
  EndGroup(app, "Vision");
  AddCheckCommand(app, systems, exit_code);
  AddWheelCommand(app, exit_code);
  AddPlanCommand(app, exit_code);
  AddDoctorCommand(app, exit_code);
  AddSchemaCommand(app, systems, exit_code);
  AddCompletionCommand(app, exit_code);
  AddHelpCommand(app, systems, exit_code);
  EndGroup(app, "Tools");
  AddStudyCommand(app);
  AddSystemCommands(app, systems, exit_code);
}

}  // namespace

int RunProgram(int argc, char** argv, const std::vector<System>& systems) {
  if (AskForNumbers(argc, argv) && !PinMathFunctions(argv)) {
    PrintNote(
        "note: results hold for processors like this one alone; the program could not start "
        "again with GLIBC_TUNABLES=" +
        PinnedTunables(""));
  }
  // A failed internal check has printed its place; it ends with the code that says so.
  std::signal(SIGABRT, [](int) { ::_exit(kExitOurBug); });
  SetCalledAs(argc > 0 ? argv[0] : "");
  int exit_code = kExitDone;
  CLI::App app(kProgramHelp, CalledAs());
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", "dockyard " DOCKYARD_VERSION);
  app.require_subcommand(1);
  AddCommands(app, systems, exit_code);
  const ExampleFiles files = systems.empty() ? ExampleFiles{} : systems.front().example_files;
  FillExamples(app, CalledAs(), files);
  exit_code = WithFailuresTold(app, AsksForJson(argc, argv), [&] {
    if (argc < 2) {
      std::cout << FirstSteps(app, files);
      return kExitUsage;
    }
    RequireCommand(app, argc, argv);
    if (const auto ended = DetectBySystem(argc, argv, systems)) return *ended;
    app.parse(argc, argv);
    return exit_code;
  });
  std::cout.flush();
  if (std::fflush(stdout) != 0 || !std::cout) {
    PrintError("cannot write to standard output");
    return kExitIo;
  }
  return exit_code;
}

}  // namespace dockyard
