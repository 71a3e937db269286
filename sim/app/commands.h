// The subcommands of the program. Each adds itself, and when chosen leaves its exit code; it throws
// what RunProgram turns into one. `systems` outlives the parsing.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// Arguments that parse but make no sense together. The message is a sentence.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void AddRunCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCampaignCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddReplayCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddViewCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddStudyCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCameraCommand(CLI::App& app, int& exit_code);
void AddDetectCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddPoseCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddBoardCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddCheckCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code);
void AddWheelCommand(CLI::App& app, int& exit_code);

/// Commands of the systems' own.
void AddSystemCommands(CLI::App& app, const std::vector<System>& systems, int& exit_code);

}  // namespace dockyard
