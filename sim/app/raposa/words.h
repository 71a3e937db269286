// A system's command line: the words after its name.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace dockyard::raposa {

/// Parses the words, or prints help: then the exit code. Throws CLI::ParseError for bad ones.
inline std::optional<int> ParseWords(CLI::App& app, std::vector<std::string> words) {
  std::reverse(words.begin(), words.end());  // CLI11 takes the last one first
  try {
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    std::cout << app.help();
    return 0;
  }
  return std::nullopt;
}

}  // namespace dockyard::raposa
