// The command line over any systems. Another project calls it from its main, with its own systems
// or controllers beside ours.
#pragma once

#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// Runs the command that the words name; returns the exit code (docs/reference/exit_codes.md).
int RunProgram(int argc, char** argv, const std::vector<System>& systems);

}  // namespace dockyard
