#include "sim/jobs/child.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "sim/base/files.h"

namespace dockyard {
namespace {

// Closes every answer; without it the answer was cut short.
constexpr std::string_view kEnd = "end\n";

void SettleIn(pid_t parent, const std::filesystem::path& messages) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it died before we asked
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
  for (const int signal : {SIGTERM, SIGABRT}) std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int file = ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0644);
  if (file < 0) return;
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::close(file);
}

[[noreturn]] void RunChild(int pipe, const std::string& answer) {
  std::fflush(nullptr);
  std::string_view rest = answer;
  while (!rest.empty()) {
    const ssize_t sent = ::write(pipe, rest.data(), rest.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) break;
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
  ::_exit(0);  // without the parent's destructors and buffers
}

void RemoveIfEmpty(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::file_size(path, ignored) == 0) std::filesystem::remove(path, ignored);
}

std::string HowItDied(int status) {
  if (WIFSIGNALED(status)) {
    return std::string("killed by signal ") + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  }
  return "ended with exit code " + std::to_string(WEXITSTATUS(status)) + " before its result";
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Child::Child(const std::function<std::string()>& work, const std::filesystem::path& messages,
             double time_limit_s, const std::vector<int>& close_in_child)
    : messages_(messages), time_limit_s_(time_limit_s), started_(Clock::now()) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw IoErrorFromErrno("start a worker for", messages);
  std::fflush(nullptr);  // else the child would print the parent's lines again
  const pid_t parent = ::getpid();
  child_ = ::fork();
  if (child_ < 0) {
    const IoError error = IoErrorFromErrno("start a worker for", messages);
    ::close(ends[0]);
    ::close(ends[1]);
    throw error;
  }
  if (child_ == 0) {
    ::close(ends[0]);
    for (const int descriptor : close_in_child) ::close(descriptor);
    SettleIn(parent, messages);
    RunChild(ends[1], work() + std::string(kEnd));
  }
  ::close(ends[1]);
  pipe_ = ends[0];
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Child::~Child() {
  if (pipe_ >= 0) ::close(pipe_);
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool Child::Read() {
  char block[4096];
  for (;;) {
    const ssize_t count = ::read(pipe_, block, sizeof block);
    if (count > 0) {
      answer_.append(block, static_cast<std::size_t>(count));
    } else if (count == 0) {
      return true;
    } else if (errno != EINTR) {
      return errno != EAGAIN && errno != EWOULDBLOCK;
    }
  }
}

double Child::seconds_left() const {
  const std::chrono::duration<double> spent = Clock::now() - started_;
  return time_limit_s_ - spent.count();
}

void Child::KillIfLate() {
  if (late_ || seconds_left() > 0.0) return;
  late_ = true;
  ::kill(child_, SIGKILL);
}

Child::End Child::Finish() {
  int status = 0;
  rusage usage{};
  while (::wait4(child_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  child_ = -1;
  RemoveIfEmpty(messages_);
  End end;
  end.cpu_time_s = Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
  end.wall_time_s = std::chrono::duration<double>(Clock::now() - started_).count();
  const bool whole = answer_.size() >= kEnd.size() &&
                     answer_.compare(answer_.size() - kEnd.size(), kEnd.size(), kEnd) == 0;
  if (whole) {
    end.answer = answer_.substr(0, answer_.size() - kEnd.size());
  } else if (late_) {
    end.how_it_died = "killed: it took more than " + std::to_string(std::lround(time_limit_s_)) +
                      " s of wall time";
  } else {
    end.how_it_died = HowItDied(status);
  }
  return end;
}

}  // namespace dockyard
