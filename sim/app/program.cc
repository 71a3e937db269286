#include "sim/app/program.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "models/read/config_error.h"
#include "sim/app/commands.h"
#include "sim/app/examples.h"
#include "sim/app/exit_codes.h"
#include "sim/app/failure.h"
#include "sim/app/help.h"
#include "sim/app/invocation.h"
#include "sim/app/machine.h"
#include "sim/app/parse_fault.h"
#include "sim/app/terminal.h"
#include "sim/base/math_pin.h"
#include "sim/base/shell_word.h"
#include "sim/scenario/load_scenario.h"

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

/// The system whose own perception `detect` is to use: that of the robot or of the scenario.
const System* DetectingSystem(const std::vector<std::string>& words, const Invocation& call) {
  const std::string robot = ValueOf(words, "--robot"), scenario = ValueOf(words, "--scenario");
  if (!scenario.empty()) {
    const std::string name = LoadScenario(scenario, {}, KnownSystems(call.systems)).system;
    const System& system = FindSystem(call.systems, name);
    if (system.detect.run) return &system;
    throw ConfigError(scenario +
                      ": expected a scenario of a system with a perception of its own, "
                      "found one of " +
                      name + ", for whose images `detect` has --robot and --board");
  }
  if (robot.empty()) return nullptr;
  for (const System& system : call.systems) {
    if (system.detect.run && system.files.check && system.files.check(robot)) return &system;
  }
  return nullptr;
}

/// The exit code of `detect` where the system has a perception of its own.
std::optional<int> DetectBySystem(int argc, char** argv, const Invocation& call) {
  if (argc < 2 || std::string(argv[1]) != "detect") return std::nullopt;
  const std::vector<std::string> words(argv + 2, argv + argc);
  const System* system = DetectingSystem(words, call);
  if (system == nullptr) return std::nullopt;
  try {
    return system->detect.run(call.program, words);
  } catch (const CLI::ParseError& error) {  // which says where its own help is
    throw UsageError("detect, for the system " + system->name + ": " + error.what());
  }
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
void RequireCommand(const CLI::App& app, int argc, char** argv, const std::string& program) {
  if (argc < 2 || argv[1][0] == '-') return;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
  }
  throw UsageError(UnknownCommand(app, argv[1], program));
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

void AddCommands(CLI::App& app, Invocation& call) {
  AddRunCommand(app, call);
  AddCampaignCommand(app, call);
  AddSubmitCommand(app, call);
  AddMergeCommand(app, call);
  AddReproduceCommand(app, call);
  EndGroup(app, "Run");
  AddReplayCommand(app, call);
  AddAuditCommand(app, call);
  AddReportCommand(app, call);
  AddFramesCommand(app, call);
  AddAcceptCommand(app, call);
  AddCompareCommand(app, call);
  AddColumnsCommand(app, call);
  EndGroup(app, "Results");
  AddViewCommand(app, call);
  AddCameraCommand(app, call);
  AddDetectCommand(app, call);
  AddPoseCommand(app, call);
  AddStereoCommand(app, call);
  AddBoardCommand(app, call);
  EndGroup(app, "Vision");
  AddCheckCommand(app, call);
  AddWheelCommand(app, call);
  AddPlanCommand(app, call);
  AddDoctorCommand(app, call);
  AddSchemaCommand(app, call);
  AddCompletionCommand(app, call);
  AddHelpCommand(app, call);
  EndGroup(app, "Tools");
  AddStudyCommand(app);
  AddSystemCommands(app, call);
}

}  // namespace

int RunProgram(int argc, char** argv, const std::vector<System>& systems) {
  if (const std::string fault = LimitFault(); !fault.empty()) {
    PrintError(fault);
    return kExitIo;
  }
  if (AskForNumbers(argc, argv) && !PinMathFunctions(argv)) {
    PrintNote(
        "note: results hold for processors like this one alone; the program could not start "
        "again with GLIBC_TUNABLES=" +
        PinnedTunables(""));
  }
  // Past the limit on a file's size, write fails with EFBIG. A handler, as an ignored signal would
  // stay so in controllers' programs.
  std::signal(SIGXFSZ, [](int) {});
  // A failed internal check has printed its place; it ends with the code that says so.
  std::signal(SIGABRT, [](int) { ::_exit(kExitOurBug); });
  const bool named = argc > 0 && *argv[0] != '\0';
  Invocation call{.systems = systems, .program = ShellWord(named ? argv[0] : "dockyard")};
  CLI::App app(kProgramHelp, call.program);
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", "dockyard " DOCKYARD_VERSION);
  app.require_subcommand(1);
  AddCommands(app, call);
  const ExampleFiles files = systems.empty() ? ExampleFiles{} : systems.front().example_files;
  FillExamples(app, call.program, files);
  const int exit_code = WithFailuresTold(app, call, AsksForJson(argc, argv), [&] {
    if (argc < 2) {
      std::cout << FirstSteps(app, files);
      return kExitUsage;
    }
    RequireCommand(app, argc, argv, call.program);
    if (const auto ended = DetectBySystem(argc, argv, call)) return *ended;
    app.parse(argc, argv);
    return call.exit_code;
  });
  std::cout.flush();
  if (std::fflush(stdout) != 0 || !std::cout) {
    PrintError("cannot write to standard output");
    return kExitIo;
  }
  return exit_code;
}

}  // namespace dockyard
