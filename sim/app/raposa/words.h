// A system's command line: the words after its name.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "models/read/near_names.h"
#include "sim/base/called_as.h"

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

/// The help with its examples as the program was called.
inline std::string WithProgram(std::string help) {
  const std::string head = "\n  dockyard ";
  for (std::size_t at = 0; (at = help.find(head, at)) != std::string::npos; at += 3) {
    help.replace(at, head.size(), "\n  " + CalledAs() + " ");
  }
  return help;
}

/// Parses the words, or prints help: then the exit code. Throws CLI::ParseError for bad ones.
inline std::optional<int> ParseWords(CLI::App& app, std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // CLI11 takes the last one first
  try {
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  } catch (const CLI::ParseError&) {
    const std::string unknown = UnknownOption(app);
    if (unknown.empty()) throw;
    throw CLI::ParseError(unknown, CLI::ExitCodes::ExtrasError);
  }
  return std::nullopt;
}

}  // namespace dockyard::raposa
