// What is thrown when an input file cannot be used. The message is one sentence for people, with
// the place first: "file:line:col: path: expected ..., found '...'".
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace dockyard {

class ConfigError : public std::runtime_error {
 public:
  /// Line breaks and other control characters quoted from a file become spaces: one line it stays.
  explicit ConfigError(std::string message) : std::runtime_error(OneLine(std::move(message))) {}

 private:
  static std::string OneLine(std::string text) {
    for (char& c : text) {
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return text;
  }
};

}  // namespace dockyard
