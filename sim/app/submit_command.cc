#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "sim/app/campaign_setup.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/number_option.h"
#include "sim/app/passing_folder.h"
#include "sim/app/slurm_client.h"
#include "sim/app/submit_answer.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/files.h"
#include "sim/campaign/campaign.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/progress.h"
#include "sim/campaign/slurm_options.h"
#include "sim/campaign/slurm_script.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

struct SubmitArguments {
  CampaignArguments campaign;
  int shards = 0;                // 0: from the time that a run takes
  double seconds_per_run = 0.0;  // 0: from the runs that the folder has, at least two
  bool dry_run = false, json = false;
  SlurmLimits limits;
};

constexpr const char* kSubmitHelp =
    R"(Submit a campaign to Slurm: an array of tasks, and a job that merges.

Examples:
  dockyard submit {campaign} --out results/yard --dry-run
  dockyard submit {campaign} --shards 4 --time 60 --dry-run --json
  dockyard submit {campaign} --seconds-per-run 5 --cpus-per-task 8 \
    --slurm=--account=rover --dry-run

Every mistake of the file is found first. The scripts go to submit/ in the results folder; --dry-run
prints them instead. --json has the jobs, their limits, and the scripts. --slurm adds an option of
sbatch that the scripts do not set themselves: tasks are numbered by --shards, not by --array.
Without --shards, the first two runs are timed: each task then lasts up to half an hour. The scripts
submitted again go on with the missing runs.)";

/// A signal ended the timing.
struct Stopped {
  int signal = 0;
};

/// Wall time of a run: the mean of those that the results folder has. Where it has none, the first
/// two are simulated into it. Throws Stopped.
double SecondsPerRun(const ReadyCampaign& ready) {
  const CampaignOptions& options = ready.options;
  const RowCheck check(ready.campaign);
  FinishedRuns runs = ReadShards(options.out_dir, check, options.columns);
  if (runs.empty()) {
    PrintNote("timing the first two runs");
    CampaignOptions two = options;
    two.enough = [wanted = 2](const RunResult&) mutable { return --wanted == 0; };
    const ShardEnd end = RunShard(ready.campaign, ready.run, two);
    if (end.signal != 0) throw Stopped{end.signal};
    runs = ReadShards(options.out_dir, check, options.columns);
  }
  double sum_s = 0.0;
  for (const RunTiming& timing : runs.timings) sum_s += timing.wall_time_s;
  return sum_s / static_cast<double>(runs.size());
}

/// The same without leaving anything.
double SecondsPerRunOf(const Campaign& campaign, const SubmitArguments& arguments,
                       const std::vector<System>& systems) {
  const PassingFolder scratch;
  CampaignArguments elsewhere = arguments.campaign;
  elsewhere.out_dir = scratch.path();
  return SecondsPerRun(MakeReady(campaign, elsewhere, systems));
}

/// Chooses the number of tasks and their time where they were not said.
void Divide(SlurmJob& job, const SubmitArguments& arguments, std::int64_t runs,
            const std::function<double()>& seconds_per_run) {
  const int highest = HighestTaskHere();
  const auto require_at_most = [&](std::int64_t most, const std::string& reason) {
    if (arguments.shards <= most) return;
    throw UsageError("--shards: expected at most " + std::to_string(most) + ", " + reason +
                     ", found " + std::to_string(arguments.shards));
  };
  require_at_most(highest, "as MaxArraySize is " + std::to_string(highest + 1) + " in Slurm");
  require_at_most(runs, "the number of runs");
  job.shards = arguments.shards;
  if (job.shards > 0 && !job.limits.time.empty()) return;
  const double run_s =
      arguments.seconds_per_run > 0.0 ? arguments.seconds_per_run : seconds_per_run();
  const int processors = job.limits.processors;
  if (job.shards == 0) job.shards = ChooseShards(runs, processors, run_s, highest);
  const double task_s = ShardSeconds(runs, job.shards, processors, run_s);
  if (job.limits.time.empty()) job.limits.time = std::to_string(TaskMinutes(task_s));
  char each[32];
  std::snprintf(each, sizeof each, "%.2g", run_s);
  PrintNote(CountText(runs, "run") + " of " + each + " s in " + CountText(job.shards, "task") +
            " of " + CountText(processors, "processor") + ": about " +
            DurationText(std::ceil(task_s)) + " each, time limit " + job.limits.time);
}

int RunSubmitCommand(const SubmitArguments& arguments, const Invocation& call) {
  const std::vector<System>& systems = call.systems;
  CheckFurtherOptions(arguments.limits.further);
  const Campaign campaign = LoadCampaign(arguments.campaign, systems);
  const ReadyCampaign ready = MakeReady(campaign, arguments.campaign, systems);
  SlurmJob job;
  job.name = campaign.name;
  job.program = fs::read_symlink("/proc/self/exe");
  job.file = fs::absolute(arguments.campaign.file);
  job.out_dir = fs::absolute(ready.options.out_dir).lexically_normal();
  job.work_dir = fs::current_path();
  job.options = OptionWords(arguments.campaign);
  job.limits = arguments.limits;
  if (job.limits.memory.empty()) job.limits.memory = std::to_string(job.limits.processors) + "G";
  Divide(job, arguments, campaign.run_count(), [&] {
    return arguments.dry_run ? SecondsPerRunOf(campaign, arguments, systems) : SecondsPerRun(ready);
  });
  const SlurmScripts scripts = ScriptsFor(job);
  std::optional<SubmittedJobs> jobs;
  if (!arguments.dry_run) {
    ClaimFolder(ready.options.out_dir, ready.options.identity, ready.options.facts);
    jobs = Submit(job, scripts);
  }
  if (arguments.json) {
    PrintSubmitJson(job, scripts, campaign.run_count(), jobs, call);
  } else {
    PrintSubmitText(job, scripts, jobs, call.program);
  }
  return kExitDone;
}

/// A check of an option whose text goes to sbatch.
CLI::Validator Like(const std::string& pattern, const std::string& expected) {
  return CLI::Validator(
      [=](const std::string& text) {
        return std::regex_match(text, std::regex(pattern))
                   ? std::string()
                   : "expected " + expected + ", found '" + text + "'";
      },
      "");
}

void AddSlurmOptions(CLI::App& command, SlurmLimits& limits) {
  command.add_option("--cpus-per-task", limits.processors, "runs of a task at once [1]")
      ->check(CLI::Range(1, 1024));
  command.add_option("--mem", limits.memory, "memory of a task [1 GiB a processor]")
      ->check(Like("[0-9]+[KMGT]?", "a size such as 4G"));
  command.add_option("--time", limits.time, "of a task [twice its estimate, at least 30 min]")
      ->check(Like("[0-9][0-9:-]*", "minutes, or a time such as 2:30:00"));
  command.add_option("--partition", limits.partition, "where the jobs run");
  command.add_option("--constraint", limits.constraint, "kind of nodes for the tasks");
  command
      .add_option("--slurm", limits.further, "any other option of sbatch: --slurm=--account=rover")
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

}  // namespace

void AddSubmitCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<SubmitArguments>();
  CLI::App* command = app.add_subcommand("submit", kSubmitHelp);
  command->add_option("FILE", arguments->campaign.file, "a campaign file")->required();
  AddCampaignOptions(*command, arguments->campaign);
  command->add_option("--shards", arguments->shards, "number of tasks [from the time of a run]")
      ->check(CLI::Range(1, 2000000000));
  command
      ->add_option("--seconds-per-run", arguments->seconds_per_run,
                   "wall time of a run [two runs are timed]")
      ->check(NumberWithin(1e-6, 1e6));
  AddSlurmOptions(*command, arguments->limits);
  command->add_flag("--dry-run", arguments->dry_run, "print the scripts, submit nothing");
  command->add_flag("--json", arguments->json, "print the jobs as JSON");
  command->callback([arguments, &call] {
    try {
      call.exit_code = RunSubmitCommand(*arguments, call);
    } catch (const SlurmError& error) {
      throw UsageError(error.what());
    } catch (const Stopped& stopped) {
      call.exit_code = kExitSignal + stopped.signal;
    }
  });
}

}  // namespace dockyard
