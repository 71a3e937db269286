// `dockyard socket`: what RAPOSA's socket lets in.
#pragma once

#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard::raposa {

/// A CommandFunction. Throws CLI::ParseError and ConfigError.
int Socket(const std::string& program, const std::vector<std::string>& words);

/// For completion.
std::vector<CommandOption> SocketOptions();

}  // namespace dockyard::raposa
