#include "sim/campaign/worker.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <sstream>

#include "controller/base/check.h"
#include "sim/campaign/run_plots.h"
#include "sim/log/files.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

// The answer is lines of text: a kind, then what belongs to it, then kEnd, without which it was cut
// short.
constexpr const char* kRow = "row";
constexpr const char* kIoError = "io_error";
constexpr const char* kInputError = "input_error";
constexpr const char* kThrew = "threw";
constexpr const char* kEnd = "end";

std::string OneLine(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return text;
}

std::string Answer(const std::string& kind, const std::string& text) {
  return kind + "\n" + OneLine(text) + "\n" + kEnd + "\n";
}

std::string RunAndAnswer(const CampaignRun& run, const RunFunction& function,
                         const std::filesystem::path& run_dir) {
  try {
    const RunRecord record = function(run, run_dir);
    WriteRecordFiles(run_dir, record);
    WriteRunPlots(run_dir, record);
    return std::string(kRow) + "\n" + CsvRow(record.result) + "\n" +
           ExactNumber(record.timing.cpu_time_s) + " " + ExactNumber(record.timing.wall_time_s) +
           "\n" + kEnd + "\n";
  } catch (const IoError& error) {
    return Answer(kIoError, error.what());
  } catch (const InputError& error) {
    return Answer(kInputError, error.what());
  } catch (const std::exception& error) {
    return Answer(kThrew, error.what());
  }
}

void SettleIn(pid_t parent, const std::filesystem::path& run_dir) {
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
  const std::filesystem::path messages = run_dir / "messages.txt";
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

Worker::Worker(const CampaignRun& run, const RunFunction& function,
               const std::filesystem::path& run_dir, double time_limit_s,
               const std::vector<int>& close_in_child)
    : run_(run), run_dir_(run_dir), time_limit_s_(time_limit_s), started_(Clock::now()) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw IoErrorFromErrno("start a worker for", run_dir);
  std::fflush(nullptr);  // else the child would print the parent's lines again
  const pid_t parent = ::getpid();
  child_ = ::fork();
  if (child_ < 0) {
    const IoError error = IoErrorFromErrno("start a worker for", run_dir);
    ::close(ends[0]);
    ::close(ends[1]);
    throw error;
  }
  if (child_ == 0) {
    ::close(ends[0]);
    for (const int descriptor : close_in_child) ::close(descriptor);
    SettleIn(parent, run_dir);
    RunChild(ends[1], RunAndAnswer(run, function, run_dir));
  }
  ::close(ends[1]);
  pipe_ = ends[0];
  ::fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

Worker::~Worker() {
  if (pipe_ >= 0) ::close(pipe_);
  if (child_ <= 0) return;
  ::kill(child_, SIGKILL);
  while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool Worker::Read() {
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

double Worker::seconds_left() const {
  const std::chrono::duration<double> spent = Clock::now() - started_;
  return time_limit_s_ - spent.count();
}

void Worker::KillIfLate() {
  if (late_ || seconds_left() > 0.0) return;
  late_ = true;
  ::kill(child_, SIGKILL);
}

WorkerEnd Worker::Crashed(const std::string& note, double cpu_time_s) const {
  WorkerEnd end;
  end.crashed = true;
  end.note = note;
  end.run.result = StartOfRow(run_);
  end.run.result.outcome = Outcome::kCrashed;
  const std::chrono::duration<double> wall = Clock::now() - started_;
  end.run.timing = {cpu_time_s, wall.count()};
  RunRecord record;
  record.result = end.run.result;
  record.failure_note = note;
  WriteRecordFiles(run_dir_, record);
  return end;
}

WorkerEnd Worker::Finish() {
  int status = 0;
  rusage usage{};
  while (::wait4(child_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  child_ = -1;
  RemoveIfEmpty(run_dir_ / "messages.txt");
  const double cpu_time_s = Seconds(usage.ru_utime) + Seconds(usage.ru_stime);

  std::istringstream lines(answer_);
  std::string kind, text, timing, end;
  std::getline(lines, kind);
  std::getline(lines, text);
  if (kind == kRow) std::getline(lines, timing);
  std::getline(lines, end);
  if (end != kEnd) {
    return Crashed(late_ ? "killed: it took more than " +
                               std::to_string(std::lround(time_limit_s_)) + " s of wall time"
                         : HowItDied(status),
                   cpu_time_s);
  }
  if (kind == kIoError) throw IoError(text);
  if (kind == kInputError) throw InputError(text);
  if (kind == kThrew) return Crashed("threw: " + text, cpu_time_s);
  const auto row = RowFromCsv(text);
  DOCKYARD_CHECK(kind == kRow && row.has_value() && row->run == run_.run);
  WorkerEnd good;
  good.run.result = *row;
  const std::size_t space = timing.find(' ');
  good.run.timing.cpu_time_s = NumberFromText(timing.substr(0, space)).value_or(0.0);
  good.run.timing.wall_time_s = NumberFromText(timing.substr(space + 1)).value_or(0.0);
  return good;
}

}  // namespace dockyard
