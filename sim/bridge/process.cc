#include "sim/bridge/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
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

/// Whether the socket became ready for this before the deadline.
bool Wait(int socket, short events, Deadline deadline) {
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        deadline - std::chrono::steady_clock::now());
    pollfd ready{socket, events, 0};
    const int count = ::poll(&ready, 1, static_cast<int>(std::max<long>(0, left.count())));
    if (count > 0) return true;
    if (count == 0 || errno != EINTR) return false;
  }
}

std::vector<std::string> ReducedEnvironment() {
  std::vector<std::string> environment{"DOCKYARD_CONTROLLER=1"};
  for (const char* name : {"PATH", "HOME", "LANG"}) {
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

/// In the child: becomes the program. Only calls that are safe after a fork.
[[noreturn]] void Become(char* const* words, char* const* environment, const char* folder,
                         int socket, int messages, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  ::setpgid(0, 0);  // Ctrl-C is the parent's matter
  for (const int signal : {SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(socket, STDIN_FILENO);
  ::dup2(socket, STDOUT_FILENO);
  ::dup2(messages, STDERR_FILENO);
  if (::chdir(folder) == 0) ::execvpe(words[0], words, environment);
  const char* reason = std::strerror(errno);
  ::dprintf(STDERR_FILENO, "cannot start %s: %s\n", words[0], reason);
  ::_exit(127);
}

}  // namespace

Deadline DeadlineIn(double seconds) {
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<Deadline::duration>(std::chrono::duration<double>(seconds));
}

Process::Process(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  int ends[2] = {-1, -1};
  messages_ = ::memfd_create("messages", MFD_CLOEXEC);
  if (messages_ < 0 || ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw IoErrorFromErrno("start", words[0]);
  }
  const int bytes = 4 << 20;  // a pair of images in one go
  ::setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &bytes, sizeof bytes);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  std::vector<std::string> program = words, environment = ReducedEnvironment();
  const auto argv = Pointers(program), envp = Pointers(environment);
  const std::string where = folder.empty() ? "." : folder.string();
  const pid_t parent = ::getpid();
  child_ = ::fork();
  if (child_ == 0) Become(argv.data(), envp.data(), where.c_str(), ends[1], messages_, parent);
  ::close(ends[1]);
  socket_ = ends[0];
  if (child_ < 0) throw IoErrorFromErrno("start", words[0]);
}

Process::~Process() {
  End(0.0);
  ::close(messages_);
}

Trouble Process::LateOrEnded() const {
  siginfo_t info{};
  const int flags = WEXITED | WNOHANG | WNOWAIT;
  const bool ended =
      ::waitid(P_PID, static_cast<id_t>(child_), &info, flags) == 0 && info.si_pid == child_;
  return ended ? Trouble::kEnded : Trouble::kLate;
}

Trouble Process::Write(std::string_view bytes, Deadline deadline) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (!Wait(socket_, POLLOUT, deadline)) return LateOrEnded();
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
      if (!Wait(socket_, POLLIN, deadline)) return LateOrEnded();
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
  int status = 0;
  while (::waitpid(child_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() >= deadline) {
      ::kill(-child_, SIGKILL);
      ::kill(child_, SIGKILL);
      ::waitpid(child_, &status, 0);
      break;
    }
    ::usleep(1000);
  }
  ::close(socket_);
  child_ = -1;
  ended_ = WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                               : "exit code " + std::to_string(WEXITSTATUS(status));
  return ended_;
}

std::string Process::Messages() const {
  constexpr off_t kMost = 64 << 10;
  const off_t size = ::lseek(messages_, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(size, 0, kMost)), '\0');
  const ssize_t got =
      ::pread(messages_, text.data(), text.size(), std::max<off_t>(0, size - kMost));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
  return text;
}

}  // namespace dockyard
