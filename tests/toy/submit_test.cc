// `dockyard submit` with fakes of Slurm's commands. scripts/test-slurm has the real ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "app/program.h"
#include "sim/base/json.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class Submit : public testing::Test {
 protected:
  Submit() { fs::create_directory(bin_); }
  ~Submit() override { ::setenv("PATH", path_.c_str(), 1); }

  void Command(const std::string& name, const std::string& text) {
    WriteText(bin_ / name, "#!/bin/bash\n" + text);
    fs::permissions(bin_ / name, fs::perms::owner_all);
  }
  /// Found first, or, with `alone`, as the only commands.
  void UseCommands(bool alone = false) {
    ::setenv("PATH", (bin_.string() + (alone ? "" : ":" + path_)).c_str(), 1);
  }
  /// A Slurm of one node without a queue: a job is done when sbatch ends.
  void FakeSlurm() {
    Command("sbatch", R"(script=${*: -1}
echo "$*" >>)" + (folder_.path() / "asked").string() +
                          R"(
echo 7
count=$(sed -n 's/^#SBATCH --array=1-//p' "$script")
for task in $(seq "${count:-1}"); do
  SLURM_ARRAY_TASK_ID=$task SLURM_CPUS_PER_TASK=2 bash "$script" >/dev/null 2>&1
done
exit 0
)");
    Command("scontrol", "echo 'MaxArraySize            = 6'");
    UseCommands();
  }
  Ended Run(const std::string& words) {
    return Dockyard("submit tests/toy/sweep.yaml " + words + " --out '" + out_.string() + "'");
  }

  const std::string path_ = std::getenv("PATH");
  const TemporaryFolder folder_;
  const fs::path bin_ = folder_.path() / "bin", out_ = folder_.path() / "an odd $folder";
};

TEST_F(Submit, GivesTheResultsOfOneProgram) {
  FakeSlurm();
  const Ended end = Run("--set design.runs=4 --shards 5 --time 10");
  EXPECT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("tasks: job 7, 5 of them; merge: job 7\n"));
  EXPECT_THAT(end.out, HasSubstr("cancel:       scancel 7 7\n"));
  const fs::path whole = folder_.path() / "whole";
  EXPECT_EQ(
      Dockyard("campaign tests/toy/sweep.yaml --set design.runs=4 --quiet --out " + whole.string())
          .code,
      0);
  EXPECT_EQ(Slurp(out_ / "results.csv"), Slurp(whole / "results.csv"));
  for (int k = 1; k <= 5; ++k) {
    EXPECT_TRUE(fs::exists(out_ / "shards" / (std::to_string(k) + "-of-5.rows"))) << k;
  }
  EXPECT_THAT(Slurp(folder_.path() / "asked"), HasSubstr("--dependency=afterany:7 "));
}

TEST_F(Submit, KeepsTheRunsThatItTimes) {
  FakeSlurm();
  Command("sbatch", "echo 7");
  const Ended end = Run("");
  EXPECT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(end.err, HasSubstr("9 runs of "));
  EXPECT_THAT(end.err, HasSubstr(" in 1 task of 1 processor: about "));
  EXPECT_THAT(end.err, HasSubstr("time limit 30\n"));
  const std::string rows = Slurp(out_ / "shards/1-of-1.rows");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 2 + 2);  // beside two lines of a head
  EXPECT_THAT(Run("").err, Not(HasSubstr("timing")));
}

TEST_F(Submit, DividesByTheTimeOfARunAndWhatSlurmTakes) {
  FakeSlurm();
  // 9 runs of 10 minutes are three half hours; of 2 hours they are more tasks than the 5 of Slurm.
  EXPECT_THAT(Run("--seconds-per-run 600 --dry-run").out, HasSubstr("#SBATCH --array=1-3\n"));
  EXPECT_THAT(Run("--seconds-per-run 7200 --dry-run").out, HasSubstr("#SBATCH --array=1-5\n"));
  const Ended many = Run("--shards 6");
  EXPECT_EQ(many.code, 2);
  EXPECT_THAT(many.err, HasSubstr("--shards: expected at most 5, as MaxArraySize is 6 in Slurm, "
                                  "found 6"));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Submit, PrintsTheScriptsAndLeavesNothingInADryRun) {
  FakeSlurm();
  const Ended dry = Run("--dry-run");
  EXPECT_EQ(dry.code, 0) << dry.err;
  EXPECT_THAT(dry.out, HasSubstr("#SBATCH --array=1-1\n"));
  EXPECT_THAT(dry.out, HasSubstr("\nexec \"$program\" merge '" + out_.string() + "'\n"));
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_FALSE(fs::exists(folder_.path() / "asked"));
}

TEST_F(Submit, SaysInJsonWhatItWouldSubmit) {
  FakeSlurm();
  const std::string words = "--shards 4 --time 10 --dry-run";
  const Ended text = Run(words), json = Run(words + " --json");
  ASSERT_EQ(json.code, 0) << json.err;
  const Json answer = Json::parse(json.out);
  EXPECT_EQ(answer["submitted"], false);
  EXPECT_EQ(answer["folder"], out_.string());
  EXPECT_EQ(answer["runs"], 9);
  EXPECT_EQ(answer["tasks"], 4);
  EXPECT_EQ(answer["time"], "10");
  EXPECT_EQ(answer["mem"], "1G");
  EXPECT_TRUE(answer["jobs"].is_null());
  EXPECT_TRUE(answer["commands"].is_null());
  EXPECT_EQ(answer["warnings"], Json::array());
  std::string scripts;
  for (const char* name : {"array", "merge", "submit"}) {
    const Json& script = answer["scripts"][name];
    EXPECT_EQ(script["file"], (out_ / "submit" / (std::string(name) + ".sh")).string());
    scripts += (scripts.empty() ? "" : "\n") + script["text"].get<std::string>();
  }
  EXPECT_EQ(scripts, text.out);
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(Submit, SaysInJsonWhatItSubmitted) {
  FakeSlurm();
  Command("sbatch", "echo 7");
  const Ended json = Run("--shards 3 --time 10 --json"), text = Run("--shards 3 --time 10");
  ASSERT_EQ(json.code, 0) << json.err;
  const Json answer = Json::parse(json.out);
  EXPECT_EQ(answer["submitted"], true);
  EXPECT_EQ(answer["jobs"], (Json{{"array", "7"}, {"merge", "7"}}));
  EXPECT_EQ(answer["warnings"], Json::array());
  for (const Json& script : answer["scripts"]) {
    EXPECT_EQ(Slurp(script["file"].get<std::string>()), script["text"]);
  }
  for (const Json& command : answer["commands"]) {
    EXPECT_THAT(text.out, HasSubstr(" " + command.get<std::string>() + "\n"));
  }
}

TEST_F(Submit, TellsARefusalAsJson) {
  FakeSlurm();
  Command("sbatch", "exit 1");
  const Ended refused = Run("--shards 3 --time 10 --json");
  EXPECT_EQ(refused.code, 50);
  EXPECT_EQ(Json::parse(refused.out)["error"]["text"], "sbatch refused the tasks");
}

TEST_F(Submit, LeavesTheScriptsWhereThereIsNoSlurm) {
  UseCommands(/*alone=*/true);
  const Ended end = Run("--shards 3 --time 10");
  EXPECT_EQ(end.code, 50);
  EXPECT_THAT(end.err, HasSubstr("this machine has no sbatch"));
  EXPECT_THAT(end.err, HasSubstr("submit/submit.sh'; --dry-run prints them"));
  EXPECT_THAT(Slurp(out_ / "submit/array.sh"), HasSubstr("#SBATCH --array=1-3\n"));
}

TEST_F(Submit, SaysWhatSlurmRefused) {
  Command("sbatch", "[ $# = 2 ] && echo 7 || { echo 'sbatch: error: no' >&2; exit 1; }");
  UseCommands();
  const Ended end = Run("--shards 3 --time 10");
  EXPECT_EQ(end.code, 50);
  EXPECT_THAT(end.err, HasSubstr("sbatch: error: no\n"));
  EXPECT_THAT(end.err, HasSubstr("refused the merge; the tasks are job 7"));
}

TEST_F(Submit, FindsEveryMistakeBefore) {
  FakeSlurm();
  EXPECT_EQ(Run("--set start.r_m=far").code, 3);
  for (const char* words : {"--shards 0", "--shards 10", "--mem lots", "--time soon", "--slurm=-A",
                            "--partition 'a\\b'", "--cpus-per-task 0"}) {
    EXPECT_EQ(Run(words + std::string(" --seconds-per-run 1")).code, 2) << words;
  }
  EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace dockyard
