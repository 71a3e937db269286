// The subcommands of the program. Each adds itself to the command line. When chosen, it sets its
// exit code or throws; RunProgram turns what was thrown into an exit code. `systems` must outlive
// the parsing.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// Arguments that parse but contradict each other. The message is a sentence.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void AddRunCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCampaignCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddSubmitCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddMergeCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddReproduceCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddReplayCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddFramesCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddReportCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddViewCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddAcceptCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCompareCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
/// Says what took the former command's place.
void AddStudyCommand(CLI::App& app);
void AddColumnsCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCameraCommand(CLI::App& app, int& exit_code);
void AddDetectCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddPoseCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddBoardCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCheckCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddWheelCommand(CLI::App& app, int& exit_code);
void AddPlanCommand(CLI::App& app, int& exit_code);
void AddStereoCommand(CLI::App& app, int& exit_code);
void AddDoctorCommand(CLI::App& app, int& exit_code);
void AddSchemaCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCompletionCommand(CLI::App& app, int& exit_code);

/// Commands of the systems' own.
void AddSystemCommands(CLI::App& app, const std::vector<System>& systems, int& exit_code);

}  // namespace dockyard
