// Scripts by which shells complete the program's commands and options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/run/system.h"

namespace dockyard {

/// @param systems  whose own commands are completed too
/// @param shell    bash, zsh or fish
std::string CompletionScript(const CLI::App& app, const std::vector<System>& systems,
                             const std::string& shell);

}  // namespace dockyard
