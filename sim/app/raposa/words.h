// A system's command line: the words after its name.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "models/read/near_names.h"
#include "sim/run/system.h"

namespace dockyard::raposa {

/// The first of the words that is an option which the command does not have; empty without one.
inline std::string UnknownOption(const CLI::App& app) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) known.push_back(name);
  }
  for (const std::string& word : app.remaining()) {
    if (word.rfind("--", 0) != 0) continue;
    const std::string near = NearestName(word.substr(2), known);  // all have the dashes
    return "unknown option '" + word + "'" +
           (near.empty() ? "" : ", did you mean '--" + near + "'?");
  }
  return "";
}

/// For SystemCommand::options, from the command line that the command itself reads.
inline std::vector<CommandOption> OptionsOf(const CLI::App& app) {
  std::vector<CommandOption> options;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      options.push_back({"--" + name, option->get_description(), option->get_type_size() != 0});
    }
  }
  return options;
}

/// The help with its examples as the program was called.
inline std::string WithProgram(std::string help, const std::string& program) {
  const std::string head = "\n  dockyard ";
  for (std::size_t at = 0; (at = help.find(head, at)) != std::string::npos; at += 3) {
    help.replace(at, head.size(), "\n  " + program + " ");
  }
  return help;
}

/// Parses the words, or prints help: then the exit code. Throws CLI::ParseError for bad ones.
/// @param help  the command that prints the help
inline std::optional<int> ParseWords(CLI::App& app, std::vector<std::string> words,
                                     const std::string& help) {
  std::reverse(words.begin(), words.end());  // CLI11 takes the last one first
  try {
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError& error) {
    const std::string unknown = UnknownOption(app);
    if (unknown.ends_with('?')) throw CLI::ParseError(unknown, CLI::ExitCodes::ExtrasError);
    throw CLI::ParseError((unknown.empty() ? error.what() : unknown) + "; " + help +
                              (unknown.empty() ? " shows its arguments" : " lists the options"),
                          CLI::ExitCodes::ExtrasError);
  }
  return std::nullopt;
}

}  // namespace dockyard::raposa
