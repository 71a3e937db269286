#include "sim/app/program.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>

#include "models/read/config_error.h"
#include "sim/app/commands.h"
#include "sim/app/examples.h"
#include "sim/app/exit_codes.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/base/math_pin.h"
#include "sim/campaign/campaign.h"
#include "sim/log/run_log.h"

namespace dockyard {
namespace {

constexpr const char* kProgramHelp = R"(Dockyard: a physics testbed for autonomous rover docking.

Examples:
  dockyard run {scenario}
  dockyard campaign {campaign}
  dockyard replay results/{campaign_name} 17
  dockyard view {scenario} --out out/view
  dockyard camera project models/cameras/navcam.yaml 2.1 0.3 0.2 --name left
  dockyard check {robot})";

int Fail(const std::exception& error, int exit_code) {
  PrintError(error.what());
  return exit_code;
}

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
  if (words.empty() || words[0].empty() || words[0][0] == '-' || words[0] == "check") return false;
  return std::none_of(words.begin(), words.end(),
                      [](const std::string& word) { return word == "--help" || word == "-h"; });
}

/// A first word that names no subcommand; empty if there is none or it does.
std::string StrangeWord(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return "";
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return "";
  }
  return argv[1];
}

int ParseAndRun(CLI::App& app, int argc, char** argv, const std::vector<System>& systems,
                int& exit_code) {
  try {
    const std::string strange = StrangeWord(app, argc, argv);
    if (!strange.empty()) {
      throw UsageError("expected a subcommand, found '" + strange +
                       "'; dockyard --help lists them");
    }
    if (const auto ended = DetectBySystem(argc, argv, systems)) return *ended;
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    return app.exit(error, std::cout, std::cerr) == 0 ? kExitDone : kExitUsage;
  } catch (const UsageError& error) {
    return Fail(error, kExitUsage);
  } catch (const FolderTaken& error) {
    return Fail(error, kExitUsage);
  } catch (const ConfigError& error) {
    return Fail(error, kExitBadInput);
  } catch (const ResultsError& error) {
    return Fail(error, kExitBadInput);
  } catch (const DataError& error) {
    return Fail(error, kExitBadInput);
  } catch (const IoError& error) {
    return Fail(error, kExitIo);
  } catch (const std::filesystem::filesystem_error& error) {
    return Fail(error, kExitIo);
  } catch (const std::exception& error) {
    return Fail(error, kExitOurBug);
  }
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
  int exit_code = kExitDone;
  CLI::App app(kProgramHelp, "dockyard");
  app.set_version_flag("--version", "dockyard " DOCKYARD_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* failed, const CLI::Error& error) {
    return "error: " + CLI::FailureMessage::simple(failed, error);
  });
  AddRunCommand(app, systems, exit_code);
  AddCampaignCommand(app, systems, exit_code);
  AddSubmitCommand(app, systems, exit_code);
  AddMergeCommand(app, systems, exit_code);
  AddReplayCommand(app, systems, exit_code);
  AddFramesCommand(app, systems, exit_code);
  AddReportCommand(app, systems, exit_code);
  AddAcceptCommand(app, systems, exit_code);
  AddCompareCommand(app, systems, exit_code);
  AddColumnsCommand(app, systems, exit_code);
  AddViewCommand(app, systems, exit_code);
  AddStudyCommand(app);
  AddCameraCommand(app, exit_code);
  AddDetectCommand(app, systems, exit_code);
  AddPoseCommand(app, systems, exit_code);
  AddBoardCommand(app, systems, exit_code);
  AddCheckCommand(app, systems, exit_code);
  AddWheelCommand(app, exit_code);
  AddPlanCommand(app, exit_code);
  AddStereoCommand(app, exit_code);
  AddDoctorCommand(app, exit_code);
  AddReproduceCommand(app, systems, exit_code);
  AddSystemCommands(app, systems, exit_code);
  FillExamples(app, argc > 0 ? argv[0] : "dockyard",
               systems.empty() ? ExampleFiles{} : systems.front().example_files);
  exit_code = ParseAndRun(app, argc, argv, systems, exit_code);
  std::cout.flush();
  if (std::fflush(stdout) != 0 || !std::cout) {
    PrintError("cannot write to standard output");
    return kExitIo;
  }
  return exit_code;
}

}  // namespace dockyard
