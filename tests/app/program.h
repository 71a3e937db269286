// Runs the program in a process of its own: arguments, streams and exit codes.
#pragma once

#include <sys/types.h>

#include <string>

namespace dockyard {

struct Ended {
  int code = -1;  // 128 + signal when a signal ended it
  std::string out, err;
};

/// `dockyard <arguments>` in the source folder, through the shell.
/// @param redirect  where stdout goes instead of into `out`
Ended Dockyard(const std::string& arguments, const std::string& redirect = "");

/// The same in the background, without output; its process number.
pid_t StartDockyard(const std::string& arguments);
/// Waits for its end; the exit code as above.
int WaitForEnd(pid_t process);

}  // namespace dockyard
