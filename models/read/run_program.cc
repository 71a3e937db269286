#include "models/read/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace dockyard {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kExitNotStarted = 127;

[[noreturn]] void Fail() {
  throw std::system_error(errno, std::generic_category(), "cannot start a process");
}

struct Pipe {
  Pipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0) Fail();
  }
  ~Pipe() {
    ::close(ends[0]);
    CloseWriting();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void CloseWriting() {
    if (ends[1] >= 0) ::close(ends[1]);
    ends[1] = -1;
  }
  int ends[2] = {-1, -1};
};

/// In the child; only calls that are safe after a fork.
[[noreturn]] void Become(const char* program, char* const* arguments, const Pipe& out,
                         const Pipe& err, const WorkLimits& limits) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int nowhere = ::open("/dev/null", O_RDONLY);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(out.ends[1], STDOUT_FILENO);
  ::dup2(err.ends[1], STDERR_FILENO);
  const rlimit cpu{static_cast<rlim_t>(limits.cpu_s), static_cast<rlim_t>(limits.cpu_s) + 5};
  ::setrlimit(RLIMIT_CPU, &cpu);
  const rlimit memory{limits.memory_bytes, limits.memory_bytes};
  ::setrlimit(RLIMIT_AS, &memory);
  ::execv(program, arguments);
  ::_exit(kExitNotStarted);
}

/// Reads both until both end; false at the time limit or beyond `most` bytes.
bool ReadBoth(const Pipe& out, const Pipe& err, Clock::time_point until, std::size_t most,
              ProgramEnd* end) {
  pollfd open[2] = {{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}};
  std::string* texts[2] = {&end->out, &end->err};
  char block[65536];
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
    if (left <= 0 || end->out.size() + end->err.size() > most) return false;
    if (::poll(open, 2, static_cast<int>(std::min<long>(left, 60000))) < 0 && errno != EINTR) {
      return true;
    }
    for (int i = 0; i < 2; ++i) {
      if (open[i].fd < 0 || open[i].revents == 0) continue;
      const ssize_t count = ::read(open[i].fd, block, sizeof block);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) {
        open[i].fd = -1;
      } else {
        texts[i]->append(block, static_cast<std::size_t>(count));
      }
    }
  }
  return true;
}

std::string FailureOf(int status) {
  if (WIFSIGNALED(status)) return "was killed by signal " + std::to_string(WTERMSIG(status));
  const int code = WEXITSTATUS(status);
  return code == 0 ? "" : "ended with exit code " + std::to_string(code);
}

}  // namespace

std::optional<std::filesystem::path> FindProgram(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::string folder(rest.substr(0, rest.find(':')));
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    std::error_code error;
    if (!folder.empty() && std::filesystem::is_regular_file(file, error) &&
        ::access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return std::nullopt;
}

ProgramEnd RunProgram(const std::filesystem::path& program, const std::vector<std::string>& words,
                      const WorkLimits& limits) {
  std::vector<std::string> all{program.string()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : all) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Pipe out, err;
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(limits.wall_s));
  const pid_t child = ::fork();
  if (child < 0) Fail();
  if (child == 0) Become(arguments[0], arguments.data(), out, err, limits);
  ::setpgid(child, child);  // whichever of both comes first
  out.CloseWriting();
  err.CloseWriting();
  ProgramEnd end;
  const bool whole = ReadBoth(out, err, until, limits.answer_bytes, &end);
  if (!whole) ::kill(-child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!whole && Clock::now() >= until) {
    end.failure = "took more than " + std::to_string(std::lround(limits.wall_s)) + " s";
  } else {
    end.failure = whole ? FailureOf(status) : "printed too much";
  }
  return end;
}

}  // namespace dockyard
