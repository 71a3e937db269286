#include "sim/base/descendants.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>

namespace dockyard {
namespace {

// How long killed processes may take to end; assumed, 1-60 s. A disk that does not answer holds
// them longer.
constexpr std::chrono::seconds kLongestEnd{10};

struct ProcessState {
  pid_t parent = 0;
  bool over = false;  // ended, and waits for its parent to ask how
  std::int64_t threads = 0, pages = 0;
};

/// /proc/PID/stat (proc(5)); its second field is a name that may hold anything, in brackets.
bool ReadState(pid_t process, ProcessState& state) {
  char path[32], text[1024];
  std::snprintf(path, sizeof path, "/proc/%d/stat", process);
  std::FILE* file = std::fopen(path, "re");
  if (file == nullptr) return false;
  const std::size_t count = std::fread(text, 1, sizeof text - 1, file);
  std::fclose(file);
  text[count] = '\0';
  const char* after = std::strrchr(text, ')');
  if (after == nullptr) return false;
  char letter = 0;
  long parent = 0, threads = 0, pages = 0;
  const int read = std::sscanf(after + 1,
                               " %c %ld %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s %*s "
                               "%*s %ld %*s %*s %*s %ld",
                               &letter, &parent, &threads, &pages);
  state = {static_cast<pid_t>(parent), letter == 'Z' || letter == 'X', threads, pages};
  return read == 4;
}

std::map<pid_t, ProcessState> AllProcesses() {
  std::map<pid_t, ProcessState> all;
  std::error_code error;
  for (std::filesystem::directory_iterator at("/proc", error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename();
    const char* stop = name.data() + name.size();
    pid_t process = 0;
    ProcessState state;
    if (std::from_chars(name.data(), stop, process).ptr == stop && ReadState(process, state)) {
      all[process] = state;
    }
  }
  return all;
}

bool HasChildren() {
  siginfo_t info{};
  return ::waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) == 0;
}

bool Holds(const std::vector<pid_t>& list, pid_t process) {
  return std::find(list.begin(), list.end(), process) != list.end();
}

/// Those below this process, but for the children named and those below them.
std::map<pid_t, ProcessState> Below(const std::vector<pid_t>& without) {
  std::map<pid_t, ProcessState> below;
  if (!HasChildren()) return below;
  const pid_t self = ::getpid();
  const std::map<pid_t, ProcessState> all = AllProcesses();
  for (bool more = true; more;) {
    more = false;
    for (const auto& [process, state] : all) {
      const bool ours = state.parent == self || below.count(state.parent) > 0;
      if (!ours || Holds(without, process)) continue;
      more = below.emplace(process, state).second || more;
    }
  }
  return below;
}

}  // namespace

double ProcessorSeconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Descendants::Descendants() {
  int adopts = 0;
  ::prctl(PR_GET_CHILD_SUBREAPER, &adopts);
  adopted_before_ = adopts != 0;
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  const pid_t self = ::getpid();
  for (const auto& [process, state] : Below({})) {
    if (state.parent == self) before_.push_back(process);
  }
}

Descendants::~Descendants() {
  if (!adopted_before_) ::prctl(PR_SET_CHILD_SUBREAPER, 0);
}

Descendants::Use Descendants::Count() const {
  static const long page_bytes = ::sysconf(_SC_PAGESIZE);
  Use use;
  for (const auto& [process, state] : Below(before_)) {
    if (state.over) continue;
    use.threads += state.threads;
    use.memory_bytes += state.pages * page_bytes;
  }
  return use;
}

double Descendants::End(const std::vector<pid_t>& keep) {
  using Clock = std::chrono::steady_clock;
  std::vector<pid_t> without = before_;
  without.insert(without.end(), keep.begin(), keep.end());
  const pid_t self = ::getpid();
  double cpu_s = 0.0;
  for (const auto deadline = Clock::now() + kLongestEnd; Clock::now() < deadline;) {
    const std::map<pid_t, ProcessState> left = Below(without);
    if (left.empty()) break;
    for (const auto& [process, state] : left) {
      if (!state.over) ::kill(process, SIGKILL);
    }
    for (const auto& [process, state] : left) {
      rusage usage{};
      if (state.parent == self && ::wait4(process, nullptr, WNOHANG, &usage) == process) {
        cpu_s += ProcessorSeconds(usage);
      }
    }
    ::usleep(1000);
  }
  return cpu_s;
}

}  // namespace dockyard
