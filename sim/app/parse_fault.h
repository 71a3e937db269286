// What is wrong with a command line that cannot be read.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace dockyard {

/// A sentence: which word is unknown and which was likely meant, else what CLI11 found.
/// @param app  after the parsing that failed
std::string ParseFault(const CLI::App& app, const CLI::ParseError& error);

/// A sentence for a first word that names no command.
std::string UnknownCommand(const CLI::App& app, const std::string& word);

}  // namespace dockyard
