// The program's help: one screen for the whole, a page for each command.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/app/invocation.h"

namespace dockyard {

/// The whole program's help lists its commands by group, a line each. In a command's help the
/// options' values are in words: "NUMBER from 0 to 1"; their meanings end at column 100. A
/// command inside shows its first line alone.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
};

/// "NUMBER from 0 to 1" from CLI11's "FLOAT:from 0 to 1", "a|b" from "TEXT:{a,b}".
std::string TypeInWords(const std::string& type);

/// The commands that are shown, by name.
std::vector<std::string> CommandNames(const CLI::App& app);
/// The first line of a command's help.
std::string Summary(const CLI::App& command);

/// What to do first, for a call without a command.
/// @param app  of the program, with its name as it was called
std::string FirstSteps(const CLI::App& app, const ExampleFiles& files);

/// `dockyard help [COMMAND...]`.
void AddHelpCommand(CLI::App& app, Invocation& call);

}  // namespace dockyard
