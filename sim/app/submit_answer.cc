#include "sim/app/submit_answer.h"

#include <cstdio>

#include "sim/base/json.h"
#include "sim/base/shell_word.h"

namespace dockyard {
namespace {

/// What can be done next, as commands to be pasted.
struct NextSteps {
  std::string progress, cancel, again;
};

NextSteps NextStepsOf(const SlurmJob& job, const SubmittedJobs& jobs, const std::string& program) {
  return {CommandText(program, {"campaign", "--watch", job.out_dir.string()}),
          "scancel " + jobs.tasks + " " + jobs.merge, SubmitCommandText(job)};
}

}  // namespace

void PrintSubmitText(const SlurmJob& job, const SlurmScripts& scripts,
                     const std::optional<SubmittedJobs>& jobs, const std::string& program) {
  if (!jobs) {
    std::printf("%s\n%s\n%s", scripts.array.c_str(), scripts.merge.c_str(), scripts.submit.c_str());
    return;
  }
  const NextSteps next = NextStepsOf(job, *jobs, program);
  std::printf("tasks: job %s, %d of them; merge: job %s\n", jobs->tasks.c_str(), job.shards,
              jobs->merge.c_str());
  std::printf("progress:     %s\n", next.progress.c_str());
  std::printf("cancel:       %s\n", next.cancel.c_str());
  std::printf("submit again: %s\n", next.again.c_str());
}

void PrintSubmitJson(const SlurmJob& job, const SlurmScripts& scripts, std::int64_t runs,
                     const std::optional<SubmittedJobs>& jobs, const Invocation& call) {
  const auto script = [&](const char* name, const std::string& text) {
    return Json{{"file", (SubmitFolder(job.out_dir) / name).string()}, {"text", text}};
  };
  Json json{{"submitted", jobs.has_value()},
            {"folder", job.out_dir.string()},
            {"runs", runs},
            {"tasks", job.shards},
            {"cpus_per_task", job.limits.processors},
            {"mem", job.limits.memory},
            {"time", job.limits.time},
            {"scripts",
             {{"array", script("array.sh", scripts.array)},
              {"merge", script("merge.sh", scripts.merge)},
              {"submit", script("submit.sh", scripts.submit)}}},
            {"jobs", nullptr},
            {"commands", nullptr},
            {"warnings", call.warnings}};
  if (jobs) {
    const NextSteps next = NextStepsOf(job, *jobs, call.program);
    json["jobs"] = {{"array", jobs->tasks}, {"merge", jobs->merge}};
    json["commands"] = {
        {"progress", next.progress}, {"cancel", next.cancel}, {"submit_again", next.again}};
  }
  std::printf("%s\n", json.dump(1).c_str());
}

}  // namespace dockyard
