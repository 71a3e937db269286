// What is wrong with a command line that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace dockyard {

/// A sentence: which word is unknown and which was likely meant, else what CLI11 found.
/// @param app      after the parsing that failed
/// @param program  as it was called, to lead to its help
std::string ParseFault(const CLI::App& app, const CLI::ParseError& error,
                       const std::string& program);

/// A sentence for a first word that names no command.
std::string UnknownCommand(const CLI::App& app, const std::string& word,
                           const std::string& program);

}  // namespace dockyard
