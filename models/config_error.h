// What is thrown when an input file cannot be used. The message is one sentence for people, with
// the place first: "file:line:col: path: expected ..., found '...'".
#pragma once

#include <stdexcept>
#include <string>

namespace dockyard {

class ConfigError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace dockyard
