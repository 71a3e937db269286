// Thrown when an input file cannot be used. The message is one sentence for people, with the place
// first: "file:line:col: path: expected ..., found '...'".
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace dockyard {

/// Line breaks and other control characters become spaces.
inline std::string OneLine(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

class ConfigError : public std::runtime_error {
 public:
  /// The message stays one line, whatever a file that it quotes holds.
  explicit ConfigError(std::string message) : std::runtime_error(OneLine(std::move(message))) {}
};

}  // namespace dockyard
