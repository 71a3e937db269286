#include "sim/jobs/worker.h"

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
#include <ctime>
#include <fstream>
#include <new>

#include "controller/base/check.h"
#include "sim/base/descendants.h"
#include "sim/base/files.h"

namespace dockyard {
namespace {

constexpr int kExitOutOfMemory = 77;

// What goes over the pipes: a job's number and the name of its file, an answer. Each text stands
// behind its length.
struct TaskHeader {
  std::int64_t job = 0;
  std::uint64_t length = 0;
};

bool ReadAll(int pipe, void* to, std::size_t count) {
  auto* at = static_cast<char*>(to);
  while (count > 0) {
    const ssize_t got = ::read(pipe, at, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

bool WriteAll(int pipe, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t sent = ::write(pipe, bytes.data() + done, bytes.size() - done);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    done += static_cast<std::size_t>(sent);
  }
  return true;
}

template <class T>
std::string BytesOf(const T& value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Bytes of data that the process has now; 0 where the system does not tell.
rlim_t DataBytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  rlim_t kib = 0;
  while (status >> word) {
    if (word == "VmData:" && status >> kib) return kib * 1024;
  }
  return 0;
}

void SettleIn(pid_t parent, const JobLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it died before we asked
  // A terminal or a batch system sends these to all processes. The parent stops its workers itself:
  // else a run would be lost that only has to wait for the next call.
  for (const int signal : {SIGINT, SIGHUP, SIGTERM, SIGPIPE}) std::signal(signal, SIG_IGN);
  std::signal(SIGABRT, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
  const rlim_t most = DataBytes() + (static_cast<rlim_t>(limits.memory_mib) << 20);
  const rlimit data{most, most};
  ::setrlimit(RLIMIT_DATA, &data);
  std::set_new_handler([] { ::_exit(kExitOutOfMemory); });
}

void PrintInto(const std::string& messages) {
  const int file = ::open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0644);
  if (file < 0) return;
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  ::close(file);
}

/// Ends without the parent's destructors and buffers.
[[noreturn]] void Work(const JobWork& work, int tasks, int answers) {
  TaskHeader task;
  while (ReadAll(tasks, &task, sizeof task)) {
    std::string messages(task.length, '\0');
    if (!ReadAll(tasks, messages.data(), messages.size())) break;
    PrintInto(messages);
    const std::string answer = work(task.job, messages);
    std::fflush(nullptr);
    const auto length = static_cast<std::uint64_t>(answer.size());
    if (!WriteAll(answers, BytesOf(length) + answer)) break;
  }
  ::_exit(0);
}

JobEnd HowItDied(int status) {
  JobEnd end;
  end.loss = Loss::kCrashed;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    // A run does not send itself this: a user, a batch system or the kernel short of memory did.
    if (signal == SIGKILL) end.loss = Loss::kStopped;
    end.how_it_died = "killed by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
  } else {
    end.how_it_died =
        "ended with exit code " + std::to_string(WEXITSTATUS(status)) + " before its result";
  }
  return end;
}

}  // namespace

Worker::Worker(const JobWork& work, const JobLimits& limits,
               const std::vector<int>& close_in_worker)
    : limits_(limits) {
  int tasks[2], answers[2];
  if (::pipe2(tasks, O_CLOEXEC) != 0) throw IoErrorFromErrno("start", "a worker");
  if (::pipe2(answers, O_CLOEXEC) != 0) {
    const IoError error = IoErrorFromErrno("start", "a worker");
    for (const int end : tasks) ::close(end);
    throw error;
  }
  std::fflush(nullptr);  // else the worker would print the parent's lines again
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) {
    const IoError error = IoErrorFromErrno("start", "a worker");
    for (const int end : {tasks[0], tasks[1], answers[0], answers[1]}) ::close(end);
    throw error;
  }
  if (process_ == 0) {
    ::close(tasks[1]);
    ::close(answers[0]);
    for (const int descriptor : close_in_worker) ::close(descriptor);
    SettleIn(parent, limits);
    Work(work, tasks[0], answers[1]);
  }
  ::close(tasks[0]);
  ::close(answers[1]);
  tasks_ = tasks[1];
  answers_ = answers[0];
  ::fcntl(answers_, F_SETFL, O_NONBLOCK);
}

Worker::~Worker() {
  for (const int descriptor : descriptors()) ::close(descriptor);
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void Worker::Start(std::int64_t job, const std::filesystem::path& messages) {
  received_.clear();
  started_ = Clock::now();
  deadline_ = started_ + std::chrono::duration_cast<Clock::duration>(
                             std::chrono::duration<double>(limits_.wall_s));
  cpu_at_start_s_ = CpuTime();
  const std::string& name = messages.native();
  const TaskHeader header{job, name.size()};
  // A worker that is gone does not take it: Read will tell.
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  WriteAll(tasks_, BytesOf(header) + name);
  std::signal(SIGPIPE, before);
}

bool Worker::Read() {
  char block[4096];
  for (;;) {
    const ssize_t count = ::read(answers_, block, sizeof block);
    if (count > 0) {
      received_.append(block, static_cast<std::size_t>(count));
    } else if (count < 0 && errno == EINTR) {
      continue;
    } else {
      gone_ = count == 0 || (errno != EAGAIN && errno != EWOULDBLOCK);
      break;
    }
  }
  std::uint64_t length = 0;
  if (received_.size() < sizeof length) return gone_;
  std::memcpy(&length, received_.data(), sizeof length);
  return gone_ || received_.size() == sizeof length + length;
}

double Worker::seconds_left() const {
  return std::chrono::duration<double>(deadline_ - Clock::now()).count();
}

void Worker::KillIfLate() {
  if (late_ || seconds_left() > 0.0) return;
  late_ = true;
  ::kill(process_, SIGKILL);
}

void Worker::Extend(double seconds) {
  deadline_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// Of the process so far; 0 when it is gone.
double Worker::CpuTime() const {
  clockid_t clock;
  timespec time;
  if (::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
    return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

JobEnd Worker::Lost(double wall_s) {
  int status = 0;
  rusage usage{};
  while (::wait4(process_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  process_ = -1;
  JobEnd end = HowItDied(status);
  const bool out_of_memory = WIFEXITED(status) && WEXITSTATUS(status) == kExitOutOfMemory;
  if (late_ || out_of_memory) {
    end.loss = Loss::kStopped;
    end.how_it_died =
        late_ ? "killed: it took more than " + std::to_string(std::lround(limits_.wall_s)) +
                    " s of wall time"
              : "out of memory: it took more than " + std::to_string(limits_.memory_mib) + " MiB";
  }
  end.wall_time_s = wall_s;
  end.cpu_time_s = ProcessorSeconds(usage) - cpu_at_start_s_;
  return end;
}

JobEnd Worker::Finish() {
  const double wall_s = std::chrono::duration<double>(Clock::now() - started_).count();
  std::uint64_t length = 0;
  const bool headed = received_.size() >= sizeof length;
  if (headed) std::memcpy(&length, received_.data(), sizeof length);
  if (!headed || received_.size() != sizeof length + length) {
    DOCKYARD_CHECK(gone_);
    return Lost(wall_s);
  }
  JobEnd end;
  end.answer = received_.substr(sizeof length);
  end.wall_time_s = wall_s;
  end.cpu_time_s = CpuTime() - cpu_at_start_s_;
  return end;
}

}  // namespace dockyard
