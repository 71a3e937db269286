// The head of a report as Markdown, for a pull request or a log of a build.
#pragma once

#include <string>

#include "sim/base/json.h"

namespace dockyard {

/// @param overview        as OverviewPart gives it
/// @param replay_command  with {run} in place of a run's number; may be empty
std::string OverviewMarkdown(const std::string& title, const Json& overview,
                             const std::string& replay_command);

}  // namespace dockyard
