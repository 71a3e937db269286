// A program in a process of its own, with its standard input and output connected to us.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/descendants.h"

namespace dockyard {

/// The variable that names the user's own folder.
inline constexpr const char* kUserFolder = "HOME";

/// How an exchange with the program failed. kTooLarge: with all that it started it took more than
/// its limits.
enum class Trouble { kNone, kEnded, kLate, kTooLarge };

using Deadline = std::chrono::steady_clock::time_point;
/// So many seconds of wall time from now.
Deadline DeadlineIn(double seconds);

/// What a program and all that it started may have together; 0: no limit. They are counted five
/// times a second while we wait for it.
struct SharedLimits {
  std::int64_t threads = 0, memory_mib = 0;
  bool any() const { return threads > 0 || memory_mib > 0; }
};

struct ProgramStart {
  std::vector<std::string> words;  // program and arguments; one without '/' is searched in PATH
  std::filesystem::path folder;    // where it runs
  std::string filter;              // bytes that it can read from descriptor 3; empty: none
  SharedLimits limits;
};

/// Dies with this object, and with this process; so does all that it started. Its environment is
/// PATH, LANG, the user's folder and DOCKYARD_CONTROLLER alone; of our descriptors it has none. One
/// at a time in a process.
class Process {
 public:
  /// Throws IoError when no process can be had. A program that cannot be started ends at once, and
  /// its messages say why.
  explicit Process(const ProgramStart& start);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  const SharedLimits& limits() const { return limits_; }

  /// Writes all bytes. kLate: not before the deadline, though the program still runs.
  Trouble Write(std::string_view bytes, Deadline deadline);
  /// Reads exactly `count` bytes, on top of `into`.
  Trouble Read(std::size_t count, Deadline deadline, std::string& into);
  /// Closes its standard input and gives it this long to end, then kills it, and in any case all
  /// that it started. Says how it ended: "exit code 1", "signal 11".
  std::string End(double limit_s);
  /// The last 64 KiB of the program's output on its standard error, as of the last wait.
  const std::string& Messages() const { return messages_; }
  /// Processor time of it and all that it started; after End.
  double cpu_time_s() const { return cpu_time_s_; }

 private:
  /// Waits until the socket is ready for this. Reads messages meanwhile: a program that prints
  /// without end neither fills memory nor is held up.
  Trouble Wait(short events, Deadline deadline);
  /// At the deadline. A program that ended may have left its end of the socket to a process that
  /// it started, so the socket alone does not tell.
  Trouble LateOrEnded() const;
  bool HasEnded() const;
  /// Counts when it is time to.
  bool IsTooLarge();
  /// At most one block; false when there is none.
  bool TakeMessages();

  Descendants descendants_;
  SharedLimits limits_;
  Deadline next_count_{};
  pid_t child_ = -1;
  int socket_ = -1, errors_ = -1;
  std::string messages_, ended_;
  double cpu_time_s_ = 0.0;
};

/// Other programs of this user can no longer read or change this process's memory, nor those of
/// its forks; it leaves no core file. Does not hold against root.
void HideMemory();

}  // namespace dockyard
