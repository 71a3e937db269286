// A campaign as jobs of Slurm: an array whose tasks are shards, and a job that merges their rows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/campaign/slurm_options.h"

namespace dockyard {

/// What a task may use, in sbatch's own words (man sbatch). Empty: the cluster's default.
struct SlurmLimits {
  int processors = 1;  // of a task, >= 1
  std::string memory;  // of a task: "4G", "4000M"
  std::string time;    // of a task: "60" minutes, "2:30:00", "1-12"
  std::string partition{};
  std::string constraint{};
  std::vector<std::string> further{};  // whole options: "--account=rover"
};

struct SlurmJob {
  std::string name;                              // of the campaign
  std::filesystem::path program, file, out_dir;  // absolute
  std::filesystem::path work_dir;                // in which the campaign's options were given
  std::vector<std::string> options;              // of `campaign`, beside --out, --shard and --jobs
  int shards = 1;
  SlurmLimits limits;
};

/// Tasks of the array are numbered from 1. The default where no cluster is asked: slurm.conf(5) has
/// MaxArraySize 1001, whose highest number is 1000.
constexpr int kDefaultHighestTask = 1000;

/// The highest number of a task, from the text of `scontrol show config`; none if it does not say.
std::optional<int> HighestTask(std::string_view config);

/// Wall time of a shard, its runs spread over the task's processors.
double ShardSeconds(std::int64_t runs, int shards, int processors, double seconds_per_run);

/// The least number of shards whose tasks take up to half an hour: long beside the scheduler's
/// seconds, short beside a partition's hours. At most `highest` and the number of runs.
int ChooseShards(std::int64_t runs, int processors, double seconds_per_run, int highest);

/// Minutes that a task is given: twice its estimate, at least 30. Both are assumed: 1.5 to 4 times,
/// as nodes differ and starts vary; 10 to 60 minutes, of which one late run takes 15.
int TaskMinutes(double shard_seconds);

/// Folders of the scripts and of what the jobs print, below the campaign's.
std::filesystem::path SubmitFolder(const std::filesystem::path& out_dir);
std::filesystem::path JobLogFolder(const std::filesystem::path& out_dir);

struct SlurmScripts {
  std::string array, merge;  // for sbatch
  // For a shell: submits both, and prints the number of the array's job and of the merge's, a line
  // each.
  std::string submit;
};

/// Throws SlurmError for what an option of sbatch cannot hold.
SlurmScripts ScriptsFor(const SlurmJob& job);

}  // namespace dockyard
