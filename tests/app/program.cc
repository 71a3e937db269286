#include "app/program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "support/fake_runs.h"
#include "support/program_path.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

std::string ShellCommand(const std::string& arguments, const std::string& out,
                         const std::string& err) {
  return "cd '" + SourceDir() + "' && exec '" + ProgramPath() + "' " + arguments + " >'" + out +
         "' 2>'" + err + "'";
}

int ExitCode(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Ended Dockyard(const std::string& arguments, const std::string& redirect) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string(), err = (folder.path() / "err").string();
  const int status =
      std::system(ShellCommand(arguments, redirect.empty() ? out : redirect, err).c_str());
  return {ExitCode(status), redirect.empty() ? Slurp(out) : "", Slurp(err)};
}

pid_t StartDockyard(const std::string& arguments) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const std::string command = ShellCommand(arguments, "/dev/null", "/dev/null");
  ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
  ::_exit(127);
}

int WaitForEnd(pid_t process) {
  int status = 0;
  ::waitpid(process, &status, 0);
  return ExitCode(status);
}

}  // namespace dockyard
