#include "models/read/guarded_work.h"

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
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>
#include <system_error>

namespace dockyard {
namespace {

using Clock = std::chrono::steady_clock;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kAddressSanitizer = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kAddressSanitizer = true;
#else
constexpr bool kAddressSanitizer = false;
#endif
#else
constexpr bool kAddressSanitizer = false;
#endif

constexpr int kExitThrew = 1, kExitOutOfMemory = 2;

void Limit(__rlimit_resource resource, rlim_t most) {
  const rlimit limit{most, most};
  ::setrlimit(resource, &limit);
}

/// The size of this process's address space; Linux gives it in pages.
std::size_t AddressSpaceBytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void SettleIn(pid_t parent, const WorkLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(kExitThrew);  // it died before we asked
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  for (const int signal : {SIGTERM, SIGABRT, SIGXCPU, SIGXFSZ, SIGALRM}) {
    std::signal(signal, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (nowhere < 0 || ::dup2(nowhere, stream) < 0) ::close(stream);
  }
  if (nowhere > STDERR_FILENO) ::close(nowhere);
  // An importer that catches std::bad_alloc would call it a fault of the file.
  std::set_new_handler([] { ::_exit(kExitOutOfMemory); });
  if (!kAddressSanitizer) Limit(RLIMIT_AS, AddressSpaceBytes() + limits.memory_bytes);
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_FSIZE, 0);
  // SIGXCPU comes at the first limit, SIGKILL, which says nothing, at the second.
  const auto cpu_s = static_cast<rlim_t>(limits.cpu_s);
  const rlimit cpu{cpu_s, cpu_s + 5};
  ::setrlimit(RLIMIT_CPU, &cpu);
}

[[noreturn]] void RunChild(int pipe, const std::function<std::string()>& work) {
  std::string answer;
  try {
    answer = work();
  } catch (const std::bad_alloc&) {
    ::_exit(kExitOutOfMemory);
  } catch (...) {
    ::_exit(kExitThrew);
  }
  std::string_view rest = answer;
  while (!rest.empty()) {
    const ssize_t sent = ::write(pipe, rest.data(), rest.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) ::_exit(kExitThrew);
    rest.remove_prefix(static_cast<std::size_t>(sent));
  }
  ::_exit(0);  // without the parent's destructors and buffers
}

/// The child and the reading end of its pipe. The child does not outlive it.
class Worker {
 public:
  Worker(const WorkLimits& limits, const std::function<std::string()>& work) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) Fail();
    const pid_t parent = ::getpid();
    child_ = ::fork();
    const int error = errno;
    if (child_ == 0) {
      ::close(ends[0]);
      SettleIn(parent, limits);
      RunChild(ends[1], work);
    }
    ::close(ends[1]);
    pipe_ = ends[0];
    if (child_ > 0) return;
    ::close(pipe_);
    errno = error;
    Fail();
  }
  ~Worker() {
    ::close(pipe_);
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    Wait();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Takes up to `most` bytes; false at the time limit. More than `most` are left unread.
  bool Read(Clock::time_point until, std::size_t most, std::string* answer) const {
    char block[65536];
    while (answer->size() <= most) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
      if (left <= 0) return false;
      pollfd readable{pipe_, POLLIN, 0};
      const int ready = ::poll(&readable, 1, static_cast<int>(std::min<long>(left, 60000)));
      if (ready == 0 || (ready < 0 && errno == EINTR)) continue;
      const ssize_t count = ::read(pipe_, block, sizeof block);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return true;
      answer->append(block, static_cast<std::size_t>(count));
    }
    return true;
  }

  /// How the child ended; 0 when it exited well, or nobody knows any more.
  int Wait() {
    int status = 0;
    while (::waitpid(child_, &status, 0) < 0) {
      if (errno == EINTR) continue;
      status = 0;
      break;
    }
    child_ = -1;
    return status;
  }

 private:
  [[noreturn]] static void Fail() {
    throw std::system_error(errno, std::generic_category(), "cannot start a process");
  }

  pid_t child_ = -1;
  int pipe_ = -1;
};

/// How a child that did not answer came to its end; empty when it did.
std::string FailureOf(int status, const WorkLimits& limits) {
  if (WIFEXITED(status)) {
    const int code = WEXITSTATUS(status);
    if (code == 0) return "";
    if (code != kExitOutOfMemory) return "crashed: ended with exit code " + std::to_string(code);
    return "took more than " + std::to_string(limits.memory_bytes >> 20) + " MiB of memory";
  }
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU) {
    return "took more than " + std::to_string(limits.cpu_s) + " s of processor time";
  }
  return "crashed: killed by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
}

}  // namespace

WorkResult RunGuarded(const WorkLimits& limits, const std::function<std::string()>& work) {
  const auto until = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(limits.wall_s));
  Worker worker(limits, work);
  std::string answer;
  if (!worker.Read(until, limits.answer_bytes, &answer)) {
    return {"", "took more than " + std::to_string(std::lround(limits.wall_s)) + " s"};
  }
  if (answer.size() > limits.answer_bytes) return {"", "answered with too much"};
  const std::string failure = FailureOf(worker.Wait(), limits);
  if (!failure.empty()) return {"", failure};
  return {std::move(answer), ""};
}

}  // namespace dockyard
