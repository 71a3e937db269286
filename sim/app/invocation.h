// One call of the program, as its commands need it.
#pragma once

#include <string>
#include <vector>

#include "sim/app/exit_codes.h"
#include "sim/run/system.h"

namespace dockyard {

struct Invocation {
  const std::vector<System>& systems;
  std::string program;           // as it was called, as a word of a shell: "build/dockyard"
  std::string secret_file = {};  // of the sealed campaign that the command opens; or empty
  std::vector<std::string> warnings = {};  // so far; every `--json` answer has them all
  int exit_code = kExitDone;               // set by the command
};

}  // namespace dockyard
