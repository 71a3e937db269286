// The subcommands of the program. Each adds itself to the command line. When chosen, it sets its
// exit code in the call, or throws; RunProgram turns what was thrown into an exit code. The call
// must outlive the parsing.
#pragma once

#include <CLI/CLI.hpp>
#include <stdexcept>

#include "sim/app/invocation.h"

namespace dockyard {

/// Arguments that parse but contradict each other. The message is a sentence.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void AddRunCommand(CLI::App& app, Invocation& call);
void AddCampaignCommand(CLI::App& app, Invocation& call);
void AddSubmitCommand(CLI::App& app, Invocation& call);
void AddMergeCommand(CLI::App& app, Invocation& call);
void AddReproduceCommand(CLI::App& app, Invocation& call);
void AddReplayCommand(CLI::App& app, Invocation& call);
void AddAuditCommand(CLI::App& app, Invocation& call);
void AddFramesCommand(CLI::App& app, Invocation& call);
void AddReportCommand(CLI::App& app, Invocation& call);
void AddViewCommand(CLI::App& app, Invocation& call);
void AddAcceptCommand(CLI::App& app, Invocation& call);
void AddCompareCommand(CLI::App& app, Invocation& call);
/// Says what took the former command's place.
void AddStudyCommand(CLI::App& app);
void AddColumnsCommand(CLI::App& app, Invocation& call);
void AddCameraCommand(CLI::App& app, Invocation& call);
void AddDetectCommand(CLI::App& app, Invocation& call);
void AddPoseCommand(CLI::App& app, Invocation& call);
void AddBoardCommand(CLI::App& app, Invocation& call);
void AddCheckCommand(CLI::App& app, Invocation& call);
void AddWheelCommand(CLI::App& app, Invocation& call);
void AddPlanCommand(CLI::App& app, Invocation& call);
void AddStereoCommand(CLI::App& app, Invocation& call);
void AddDoctorCommand(CLI::App& app, Invocation& call);
void AddSchemaCommand(CLI::App& app, Invocation& call);
void AddCompletionCommand(CLI::App& app, Invocation& call);

/// Commands of the systems' own.
void AddSystemCommands(CLI::App& app, Invocation& call);

}  // namespace dockyard
