#include "sim/bridge/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "sim/base/files.h"

namespace dockyard {
namespace {

using Clock = std::chrono::steady_clock;

// Of standard error, the end; assumed, 16 KiB to 1 MiB.
constexpr std::size_t kMessagesKept = 64 << 10;
// How often a program with limits is counted; assumed, 0.05-1 s.
constexpr std::chrono::milliseconds kCountPeriod{200};

std::vector<std::string> ReducedEnvironment() {
  std::vector<std::string> environment{"DOCKYARD_CONTROLLER=1"};
  for (const char* name : {"PATH", kUserFolder, "LANG"}) {
    if (const char* value = std::getenv(name)) {
      environment.push_back(std::string(name) + "=" + value);
    }
  }
  return environment;
}

std::vector<char*> Pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// What the child needs, made before the fork.
struct Becoming {
  char* const* words;
  char* const* environment;
  const char* folder;
  int socket, errors, filter;  // filter: -1 for none
  pid_t parent;
};

/// In the child: becomes the program. Only calls that are safe after a fork.
[[noreturn]] void Become(const Becoming& what) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != what.parent) ::_exit(127);
  ::setpgid(0, 0);  // Ctrl-C is the parent's matter
  for (const int signal : {SIGINT, SIGHUP, SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  // All ours may lie on 0 to 3, where the parent was started without standard streams.
  const int socket = ::fcntl(what.socket, F_DUPFD, 10), errors = ::fcntl(what.errors, F_DUPFD, 10);
  const int filter = what.filter < 0 ? -1 : ::fcntl(what.filter, F_DUPFD, 10);
  ::dup2(socket, STDIN_FILENO);
  ::dup2(socket, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  unsigned first = STDERR_FILENO + 1;
  if (filter >= 0 && ::dup2(filter, static_cast<int>(first)) >= 0) ++first;
  ::close_range(first, ~0U, 0);
  if (::chdir(what.folder) == 0) ::execvpe(what.words[0], what.words, what.environment);
  const char* reason = std::strerror(errno);
  ::dprintf(STDERR_FILENO, "cannot start %s: %s\n", what.words[0], reason);
  ::_exit(127);
}

/// A file without a name that holds the bytes; -1 when there are none, or on failure.
int FileWith(const std::string& bytes) {
  if (bytes.empty()) return -1;
  const int file = ::memfd_create("filter", MFD_CLOEXEC);
  if (file < 0) return -1;
  if (::write(file, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()) &&
      ::lseek(file, 0, SEEK_SET) == 0) {
    return file;
  }
  ::close(file);
  return -1;
}

}  // namespace

Deadline DeadlineIn(double seconds) {
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<Deadline::duration>(std::chrono::duration<double>(seconds));
}

Process::Process(const ProgramStart& start) : limits_(start.limits) {
  const std::string& name = start.words[0];
  int ends[2] = {-1, -1}, errors[2] = {-1, -1};
  const int filter = FileWith(start.filter);
  if ((filter < 0 && !start.filter.empty()) || ::pipe2(errors, O_CLOEXEC) != 0 ||
      ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    const IoError error = IoErrorFromErrno("start", name);
    for (const int descriptor : {filter, errors[0], errors[1]}) ::close(descriptor);
    throw error;
  }
  const int bytes = 4 << 20;  // a pair of images in one go
  ::setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  ::fcntl(errors[0], F_SETFL, O_NONBLOCK);
  std::vector<std::string> program = start.words, environment = ReducedEnvironment();
  const auto argv = Pointers(program), envp = Pointers(environment);
  const std::string where = start.folder.empty() ? "." : start.folder.string();
  const Becoming what{argv.data(), envp.data(), where.c_str(), ends[1],
                      errors[1],   filter,      ::getpid()};
  child_ = ::fork();
  if (child_ == 0) Become(what);
  for (const int descriptor : {ends[1], errors[1], filter}) {
    if (descriptor >= 0) ::close(descriptor);
  }
  socket_ = ends[0];
  errors_ = errors[0];
  if (child_ < 0) {
    const IoError error = IoErrorFromErrno("start", name);
    for (const int descriptor : {socket_, errors_}) ::close(descriptor);
    throw error;
  }
  ::setpgid(child_, child_);  // as the child does, whoever is first
}

Process::~Process() { End(0.0); }

bool Process::HasEnded() const {
  siginfo_t info{};
  const int flags = WEXITED | WNOHANG | WNOWAIT;
  return ::waitid(P_PID, static_cast<id_t>(child_), &info, flags) == 0 && info.si_pid == child_;
}

Trouble Process::LateOrEnded() const { return HasEnded() ? Trouble::kEnded : Trouble::kLate; }

bool Process::IsTooLarge() {
  if (!limits_.any() || Clock::now() < next_count_) return false;
  const Descendants::Use use = descendants_.Count();
  next_count_ = Clock::now() + kCountPeriod;
  return (limits_.threads > 0 && use.threads > limits_.threads) ||
         (limits_.memory_mib > 0 && (use.memory_bytes >> 20) > limits_.memory_mib);
}

bool Process::TakeMessages() {
  char block[kMessagesKept];
  const ssize_t count = errors_ < 0 ? 0 : ::read(errors_, block, sizeof block);
  if (count > 0) {
    messages_.append(block, static_cast<std::size_t>(count));
    if (messages_.size() > kMessagesKept) messages_.erase(0, messages_.size() - kMessagesKept);
    return true;
  }
  const bool closed = count == 0 || (errno != EAGAIN && errno != EINTR);
  if (closed && errors_ >= 0) {
    ::close(errors_);
    errors_ = -1;  // which poll passes over
  }
  return false;
}

Trouble Process::Wait(short events, Deadline deadline) {
  for (;;) {
    if (IsTooLarge()) return Trouble::kTooLarge;
    const auto now = Clock::now();
    auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - now);
    if (limits_.any()) left = std::min(left, kCountPeriod);
    pollfd ready[2] = {{socket_, events, 0}, {errors_, POLLIN, 0}};
    const int count = ::poll(ready, 2, static_cast<int>(std::max<long>(0, left.count())));
    if (count > 0 && ready[1].revents != 0) TakeMessages();
    if (count > 0 && ready[0].revents != 0) return Trouble::kNone;
    if (now >= deadline) return LateOrEnded();
  }
}

Trouble Process::Write(std::string_view bytes, Deadline deadline) {
  if (child_ < 0) return Trouble::kEnded;
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      const Trouble trouble = Wait(POLLOUT, deadline);
      if (trouble != Trouble::kNone) return trouble;
    } else if (errno != EINTR) {
      return Trouble::kEnded;
    }
  }
  return Trouble::kNone;
}

Trouble Process::Read(std::size_t count, Deadline deadline, std::string& into) {
  const std::size_t wanted = into.size() + count;
  std::size_t have = into.size();
  into.resize(wanted);
  while (have < wanted) {
    const ssize_t got = ::recv(socket_, into.data() + have, wanted - have, 0);
    if (got > 0) {
      have += static_cast<std::size_t>(got);
    } else if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      const Trouble trouble = Wait(POLLIN, deadline);
      if (trouble != Trouble::kNone) return trouble;
    } else if (got == 0 || errno != EINTR) {
      return Trouble::kEnded;
    }
  }
  return Trouble::kNone;
}

std::string Process::End(double limit_s) {
  if (child_ < 0) return ended_;
  ::shutdown(socket_, SHUT_WR);
  const Deadline deadline = DeadlineIn(limit_s);
  while (!HasEnded() && Clock::now() < deadline && !IsTooLarge()) {
    pollfd ready{errors_, POLLIN, 0};
    ::poll(&ready, 1, 1);
    if (ready.revents != 0) TakeMessages();
  }
  // Before the child's number is free for others, who may start a group of this number.
  ::kill(-child_, SIGKILL);
  ::kill(child_, SIGKILL);
  int status = 0;
  rusage usage{};
  while (::wait4(child_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  cpu_time_s_ = ProcessorSeconds(usage) + descendants_.End();
  while (TakeMessages()) {
  }
  for (const int descriptor : {socket_, errors_}) {
    if (descriptor >= 0) ::close(descriptor);
  }
  child_ = socket_ = errors_ = -1;
  ended_ = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "exit code " + std::to_string(WEXITSTATUS(status));
  return ended_;
}

void HideMemory() { ::prctl(PR_SET_DUMPABLE, 0); }

}  // namespace dockyard
