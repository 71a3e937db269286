// The subcommands of the program. Each adds itself, and when chosen leaves its exit code; it throws
// what main turns into one.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

namespace dockyard {

/// Arguments that parse but make no sense together. The message is a sentence.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void AddRunCommand(CLI::App& app, int& exit_code);
void AddCampaignCommand(CLI::App& app, int& exit_code);
void AddReplayCommand(CLI::App& app, int& exit_code);
void AddViewCommand(CLI::App& app, int& exit_code);
void AddStudyCommand(CLI::App& app, int& exit_code);
void AddCameraCommand(CLI::App& app, int& exit_code);
void AddDetectCommand(CLI::App& app, int& exit_code);
void AddPoseCommand(CLI::App& app, int& exit_code);
void AddBoardCommand(CLI::App& app, int& exit_code);
void AddCheckCommand(CLI::App& app, int& exit_code);
void AddWheelCommand(CLI::App& app, int& exit_code);

}  // namespace dockyard
