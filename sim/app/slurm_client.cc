#include "sim/app/slurm_client.h"

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

#include "sim/app/exit_codes.h"
#include "sim/base/folder.h"
#include "sim/base/shell_word.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

struct Answer {
  std::string text;
  int code = -1;
};

/// What a shell's command prints, and its exit code.
Answer AskShell(const std::string& command) {
  std::fflush(nullptr);
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw IoErrorFromErrno("start", "/bin/sh");
  Answer answer;
  char block[4096];
  for (std::size_t count; (count = std::fread(block, 1, sizeof block, pipe)) > 0;) {
    answer.text.append(block, count);
  }
  const int status = ::pclose(pipe);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : kExitSignal + WTERMSIG(status);
  return answer;
}

void Write(const SlurmJob& job, const SlurmScripts& scripts) {
  const Folder results = job.out_dir;
  results.Make(JobLogFolder(""));
  const fs::path dir = SubmitFolder("");
  results.Write(dir / "array.sh", scripts.array);
  results.Write(dir / "merge.sh", scripts.merge);
  results.Write(dir / "submit.sh", scripts.submit);
}

}  // namespace

int HighestTaskHere() {
  const Answer config = AskShell("scontrol show config 2>/dev/null");
  return HighestTask(config.text).value_or(kDefaultHighestTask);
}

SubmittedJobs Submit(const SlurmJob& job, const SlurmScripts& scripts) {
  Write(job, scripts);
  const std::string submit = SubmitCommandText(job);
  if (AskShell("command -v sbatch").code != 0) {
    throw IoError(
        "this machine has no sbatch. The scripts are written; on the cluster, where the " +
        std::string("same folders must be, run: ") + submit + "; --dry-run prints them");
  }
  const Answer answer = AskShell(submit);
  std::istringstream lines(answer.text);
  SubmittedJobs jobs;
  std::getline(lines, jobs.tasks);
  std::getline(lines, jobs.merge);
  if (answer.code != 0) {
    throw IoError(jobs.tasks.empty() ? "sbatch refused the tasks"
                                     : "sbatch refused the merge; the tasks are job " + jobs.tasks);
  }
  return jobs;
}

std::string SubmitCommandText(const SlurmJob& job) {
  return "bash " + ShellWord((SubmitFolder(job.out_dir) / "submit.sh").string());
}

}  // namespace dockyard
