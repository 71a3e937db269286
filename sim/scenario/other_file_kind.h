// A scenario where a campaign was expected, or a campaign where a scenario was.
#pragma once

#include <string>
#include <utility>

#include "models/read/config_error.h"

namespace dockyard {

/// Carries the command that takes the file: the program alone knows how it was called.
class OtherFileKind : public ConfigError {
 public:
  OtherFileKind(std::string message, std::string command, std::string file)
      : ConfigError(std::move(message)), command_(std::move(command)), file_(std::move(file)) {}
  const std::string& command() const { return command_; }
  const std::string& file() const { return file_; }

 private:
  std::string command_, file_;
};

}  // namespace dockyard
