#include "sim/campaign/slurm_script.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/count_text.h"
#include "sim/base/shell_word.h"

namespace dockyard {
namespace {

constexpr double kTaskSeconds = 1800.0;

/// The text as one value of an #SBATCH line. Those are read by sbatch, not by a shell: quotation
/// marks are escaped by backslashes, and nothing is expanded.
std::string Value(const std::string& option, const std::string& text) {
  std::string value;
  for (const char c : text) {
    // In a path, a backslash would switch off the replacement of %a.
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\') {
      throw SlurmError(option + ": sbatch cannot take a backslash or control character, as in '" +
                       text + "'");
    }
    if (c == '"') value += '\\';
    value += c;
  }
  return "\"" + value + "\"";
}

std::string Line(const std::string& option, const std::string& text) {
  if (text.empty()) return "";
  return "#SBATCH --" + option + "=" + Value("--" + option, text) + "\n";
}

/// A folder in which % is no pattern of sbatch.
std::string PlainFolder(const std::filesystem::path& dir) {
  std::string plain;
  for (const char c : dir.string()) plain += c == '%' ? "%%" : std::string(1, c);
  return plain;
}

std::string Further(const SlurmLimits& limits) {
  CheckFurtherOptions(limits.further);
  std::string lines = Line("partition", limits.partition) + Line("constraint", limits.constraint);
  for (const std::string& option : limits.further) {
    const std::size_t equals = option.find('=');
    lines += equals == option.npos ? "#SBATCH " + option + "\n"
                                   : Line(option.substr(2, equals - 2), option.substr(equals + 1));
  }
  return lines;
}

std::string Words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += " " + ShellWord(word);
  return text;
}

/// To the folder in which `submit` was called, and a check of what a node may lack.
std::string Enter(const SlurmJob& job) {
  return "cd -- " + ShellWord(job.work_dir.string()) +
         " || exit 50\n"
         "program=" +
         ShellWord(job.program.string()) +
         "\n"
         "[ -x \"$program\" ] || {\n"
         "  echo \"error: $(hostname) has no program $program; it must be on a shared folder\" "
         ">&2\n"
         "  exit 50\n"
         "}\n";
}

std::string ArrayScript(const SlurmJob& job) {
  const std::string shards = std::to_string(job.shards);
  const std::string log = PlainFolder(JobLogFolder(job.out_dir)) + "/%A_%a.txt";
  std::string text =
      "#!/bin/bash\n"
      "# The runs of a campaign in " +
      CountText(job.shards, "task") +
      ", written by `dockyard submit`.\n"
      "# A task that was stopped or killed goes on where it was: submit this file again.\n";
  text += Line("job-name", "dockyard " + job.name);
  text += "#SBATCH --array=1-" + shards + "\n";
  text += "#SBATCH --nodes=1 --ntasks=1 --cpus-per-task=" + std::to_string(job.limits.processors) +
          "\n";
  text += Line("mem", job.limits.memory) + Line("time", job.limits.time);
  text +=
      "# The script gets TERM half a minute before the time is over. A task that lost its node\n"
      "# starts again, and its log goes on.\n"
      "#SBATCH --signal=B:TERM@30 --requeue --open-mode=append\n";
  text += Line("output", log);
  if (job.limits.constraint.empty()) {
    text +=
        "# Where a partition mixes makers of processors, choose one: rows hold bit for bit on "
        "one.\n"
        "##SBATCH --constraint=intel\n";
  }
  text += Further(job.limits);
  text += "\n" + Enter(job);
  text +=
      "stopped=\n"
      "trap 'stopped=yes; kill -TERM \"$!\" 2>/dev/null' TERM\n"
      "\"$program\" campaign" +
      Words({job.file.string(), "--out", job.out_dir.string()}) + Words(job.options) +
      " \\\n  --shard \"$SLURM_ARRAY_TASK_ID/" + shards +
      "\" --jobs \"$SLURM_CPUS_PER_TASK\" &\n"
      "[ -z \"$stopped\" ] || kill -TERM \"$!\"  # it came before the program\n"
      "# A signal ends `wait` before the program, which keeps its finished runs first.\n"
      "while\n"
      "  stopped=\n"
      "  wait \"$!\"\n"
      "  code=$?\n"
      "  [ -n \"$stopped\" ]\n"
      "do :; done\n"
      "exit \"$code\"\n";
  return text;
}

std::string MergeScript(const SlurmJob& job) {
  std::string text =
      "#!/bin/bash\n"
      "# Merges the rows of a campaign's tasks, written by `dockyard submit`.\n"
      "# Exit code 10: runs are missing or crashed; the log says which.\n";
  text += Line("job-name", "dockyard merge " + job.name);
  text +=
      "#SBATCH --nodes=1 --ntasks=1 --cpus-per-task=1 --mem=2G --time=60\n"
      "#SBATCH --requeue --open-mode=append\n";
  text += Line("output", PlainFolder(JobLogFolder(job.out_dir)) + "/merge_%j.txt");
  text += Further(job.limits);
  text += "\n" + Enter(job);
  return text + "exec \"$program\" merge" + Words({job.out_dir.string()}) + "\n";
}

std::string SubmitScript(const std::filesystem::path& out_dir) {
  const std::filesystem::path dir = SubmitFolder(out_dir);
  return "#!/bin/bash\n"
         "# Submits the tasks of a campaign and the merge of their rows, written by `dockyard "
         "submit`.\n"
         "# The merge waits for every task's end, of whatever kind: it reports gaps too.\n"
         "set -euo pipefail\n"
         "tasks=$(sbatch --parsable " +
         ShellWord((dir / "array.sh").string()) +
         ")\n"
         "echo \"$tasks\"\n"
         "sbatch --parsable --dependency=\"afterany:${tasks%%;*}\" " +
         ShellWord((dir / "merge.sh").string()) + "\n";
}

}  // namespace

std::optional<int> HighestTask(std::string_view config) {
  constexpr std::string_view kName = "MaxArraySize";
  const std::size_t at = config.find(kName);
  if (at == config.npos) return std::nullopt;
  const std::size_t digit = config.find_first_not_of(" =", at + kName.size());
  if (digit == config.npos) return std::nullopt;
  int size = 0;
  const auto read = std::from_chars(config.data() + digit, config.data() + config.size(), size);
  if (read.ec != std::errc() || size < 2) return std::nullopt;
  return size - 1;
}

double ShardSeconds(std::int64_t runs, int shards, int processors, double seconds_per_run) {
  const std::int64_t longest = (runs + shards - 1) / shards;
  const std::int64_t rounds = (longest + processors - 1) / processors;
  return static_cast<double>(rounds) * seconds_per_run;
}

int ChooseShards(std::int64_t runs, int processors, double seconds_per_run, int highest) {
  DOCKYARD_CHECK(runs >= 1 && processors >= 1 && highest >= 1);
  const double all_s = static_cast<double>(runs) * seconds_per_run / processors;
  const double most = static_cast<double>(std::min<std::int64_t>(runs, highest));
  return static_cast<int>(std::clamp(std::ceil(all_s / kTaskSeconds), 1.0, most));
}

int TaskMinutes(double shard_seconds) {
  return static_cast<int>(std::max(30.0, std::ceil(2.0 * shard_seconds / 60.0)));
}

std::filesystem::path SubmitFolder(const std::filesystem::path& out_dir) {
  return out_dir / "submit";
}

std::filesystem::path JobLogFolder(const std::filesystem::path& out_dir) {
  return SubmitFolder(out_dir) / "log";
}

SlurmScripts ScriptsFor(const SlurmJob& job) {
  return {ArrayScript(job), MergeScript(job), SubmitScript(job.out_dir)};
}

}  // namespace dockyard
