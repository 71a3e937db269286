// A program in a process of its own, with its standard input and output connected to us.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

/// How an exchange with the program failed.
enum class Trouble { kNone, kEnded, kLate };

using Deadline = std::chrono::steady_clock::time_point;
/// So many seconds of wall time from now.
Deadline DeadlineIn(double seconds);

/// Dies with this object, and with this process. Its environment is PATH, HOME, LANG and
/// DOCKYARD_CONTROLLER alone; its standard error is kept for Messages.
class Process {
 public:
  /// @param words   the program and its arguments; a program without '/' is looked up in PATH
  /// @param folder  where it runs
  /// Throws IoError when no process can be had. A program that cannot be started ends at once, and
  /// its messages say why.
  Process(const std::vector<std::string>& words, const std::filesystem::path& folder);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Writes all bytes. kLate: not before the deadline, though the program still runs.
  Trouble Write(std::string_view bytes, Deadline deadline);
  /// Reads exactly `count` bytes, on top of `into`.
  Trouble Read(std::size_t count, Deadline deadline, std::string& into);
  /// Closes its standard input and gives it this long to end, then kills it. Says how it ended:
  /// "exit code 1", "signal 11".
  std::string End(double limit_s);
  /// The program's output on its standard error, the last 64 KiB.
  std::string Messages() const;

 private:
  /// At the deadline. A program that ended may have left its end of the socket to a process that
  /// it started, so the socket alone does not tell.
  Trouble LateOrEnded() const;

  pid_t child_ = -1;
  int socket_ = -1, messages_ = -1;
  std::string ended_;
};

}  // namespace dockyard
