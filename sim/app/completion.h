// Scripts by which shells complete the program's commands and options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace dockyard {

/// @param shell  bash, zsh or fish
std::string CompletionScript(const CLI::App& app, const std::string& shell);

}  // namespace dockyard
