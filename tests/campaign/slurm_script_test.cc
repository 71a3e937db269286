// Bash runs the scripts in place of Slurm, with a program that stands in for dockyard.
// scripts/test-slurm has the real Slurm.
#include "sim/campaign/slurm_script.h"
#include "sim/campaign/slurm_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cmath>
#include <cstdlib>

#include "sim/base/shell_word.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

int Shell(const std::string& command) {
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

class SlurmScript : public testing::Test {
 protected:
  SlurmScript() {
    fs::create_directories(job_.work_dir);
    job_.limits.memory = "1G";
    job_.limits.time = "60";
  }
  /// The program of the script.
  void Program(const std::string& text) {
    WriteText(job_.program, "#!/bin/bash\n" + text);
    fs::permissions(job_.program, fs::perms::owner_all);
  }
  /// Bash with the script as task 3; `before` is put before it.
  int Run(const std::string& script, const std::string& before = "") {
    WriteText(Path("script.sh"), script);
    return Shell("cd / && export SLURM_ARRAY_TASK_ID=3 SLURM_CPUS_PER_TASK=2 && " + before +
                 "bash " + ShellWord(Path("script.sh")) + " 2>" + ShellWord(Path("err")));
  }
  std::string Path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  // Characters that a shell, sbatch or its patterns of file names read in a way of their own.
  const fs::path odd_ = folder_.path() / "it's \"odd\" $HOME %a #1";
  SlurmJob job_{.name = "yard",
                .program = odd_ / "dockyard",
                .file = odd_ / "a campaign.yaml",
                .out_dir = odd_ / "out",
                .work_dir = odd_,
                .options = {"--set", "vary={start.r_m: [1, 2]}"},
                .shards = 12,
                .limits = {}};
};

TEST_F(SlurmScript, HasNoFaultThatShellcheckSees) {
  job_.limits.partition = "long";
  job_.limits.further = {"--account=rover group", "--exclusive"};
  const auto [array, merge, submit] = ScriptsFor(job_);
  for (const std::string& script : {array, merge, submit}) {
    WriteText(Path("script.sh"), script);
    EXPECT_EQ(Shell("bash -n " + ShellWord(Path("script.sh"))), 0);
    // SC2016 is a $ between single quotes, which is meant.
    EXPECT_EQ(Shell("shellcheck --exclude=SC2016 " + ShellWord(Path("script.sh"))), 0) << script;
  }
}

TEST_F(SlurmScript, HandsEveryWordToTheProgramAsItIs) {
  Program("pwd; printf '%s\\n' \"$@\"");
  ASSERT_EQ(Run(ScriptsFor(job_).array, "exec >" + ShellWord(Path("out")) + " && "), 0)
      << Slurp(Path("err"));
  EXPECT_EQ(Slurp(Path("out")),
            odd_.string() + "\ncampaign\n" + job_.file.string() + "\n--out\n" +
                job_.out_dir.string() +
                "\n--set\nvary={start.r_m: [1, 2]}\n--shard\n3/12\n--jobs\n2\n");
  ASSERT_EQ(Run(ScriptsFor(job_).merge, "exec >" + ShellWord(Path("out")) + " && "), 0);
  EXPECT_EQ(Slurp(Path("out")), odd_.string() + "\nmerge\n" + job_.out_dir.string() + "\n");
}

TEST_F(SlurmScript, EndsAsItsProgramEnds) {
  for (const int code : {0, 10, 143}) {
    Program("exit " + std::to_string(code));
    EXPECT_EQ(Run(ScriptsFor(job_).array), code);
    EXPECT_EQ(Run(ScriptsFor(job_).merge), code);
  }
  Program("kill -9 $$");
  EXPECT_EQ(Run(ScriptsFor(job_).array), 137);
}

TEST_F(SlurmScript, PassesOnEveryTermAndWaitsForTheProgramsEnd) {
  // The program sends its script TERM twice, gets both back, and still works for a while.
  Program(R"(got=0
trap 'got=$((got + 1))' TERM
for expected in 1 2; do
  kill -TERM $PPID
  for _ in $(seq 500); do [ $got -ge $expected ] && break; sleep 0.01; done
done
sleep 0.2
echo "$got signals" >kept
exit 143)");
  EXPECT_EQ(Run(ScriptsFor(job_).array), 143) << Slurp(Path("err"));
  EXPECT_EQ(Slurp(odd_ / "kept"), "2 signals\n");
}

TEST_F(SlurmScript, PassesOnATermThatCameBeforeTheProgram) {
  Program("exec sleep 10");
  std::string script = ScriptsFor(job_).array;
  const std::string start = "\"$program\" campaign";
  script.insert(script.find(start), "kill -TERM $$\n");
  EXPECT_EQ(Run(script), 143) << Slurp(Path("err"));
}

TEST_F(SlurmScript, SaysWhatANodeLacks) {
  EXPECT_EQ(Run(ScriptsFor(job_).array), 50);
  EXPECT_THAT(Slurp(Path("err")), HasSubstr("it must be on a shared folder"));
  fs::remove_all(odd_);
  EXPECT_EQ(Run(ScriptsFor(job_).merge), 50);
  EXPECT_THAT(Slurp(Path("err")), HasSubstr("No such file or directory"));
}

TEST_F(SlurmScript, AsksSlurmForWhatWasSaid) {
  job_.limits = {.processors = 4,
                 .memory = "6G",
                 .time = "2:30:00",
                 .partition = "long",
                 .constraint = "avx2&intel",
                 .further = {"--account=rover group", "--exclusive"}};
  job_.out_dir = "/results/100% \"sure\"";
  const std::string script = ScriptsFor(job_).array;
  for (const char* line :
       {"#SBATCH --array=1-12\n", "--cpus-per-task=4\n", "#SBATCH --mem=\"6G\"\n",
        "#SBATCH --time=\"2:30:00\"\n", "#SBATCH --partition=\"long\"\n",
        "#SBATCH --constraint=\"avx2&intel\"\n", "#SBATCH --account=\"rover group\"\n",
        "#SBATCH --exclusive\n", "--signal=B:TERM@30 --requeue --open-mode=append\n",
        // %% is a percent sign for sbatch, \" a quotation mark.
        "#SBATCH --output=\"/results/100%% \\\"sure\\\"/submit/log/%A_%a.txt\"\n"}) {
    EXPECT_THAT(script, HasSubstr(line));
  }
  // sbatch reads options up to the first command.
  EXPECT_GT(script.find("\ncd "), script.rfind("#SBATCH"));
  EXPECT_THAT(script, Not(HasSubstr("##SBATCH --constraint")));
}

// The stand-in for sbatch writes down its words and answers as on a site with several clusters.
TEST_F(SlurmScript, SubmitsTheMergeToFollowAllTasks) {
  job_.program = odd_ / "sbatch";
  Program("printf '%s\\n' \"$@\" >>words; echo \"$(wc -l <words);alpha\"");
  const std::string before = "cd " + ShellWord(odd_.string()) +
                             " && PATH=\"$PWD:$PATH\" && exec >" + ShellWord(Path("out")) + " && ";
  ASSERT_EQ(Run(ScriptsFor(job_).submit, before), 0) << Slurp(Path("err"));
  const std::string dir = job_.out_dir.string() + "/submit/";
  EXPECT_EQ(Slurp(odd_ / "words"), "--parsable\n" + dir + "array.sh\n--parsable\n" +
                                       "--dependency=afterany:2\n" + dir + "merge.sh\n");
  EXPECT_EQ(Slurp(Path("out")), "2;alpha\n5;alpha\n");
  Program("echo 'sbatch: error: full' >&2; exit 1");
  EXPECT_EQ(Run(ScriptsFor(job_).submit, before), 1);
}

TEST_F(SlurmScript, RefusesWhatSbatchCannotTake) {
  SlurmJob line = job_, backslash = job_, word = job_;
  line.limits.partition = "a\n#SBATCH --uid=0";
  backslash.out_dir = "/results/a\\b";
  word.limits.further = {"-A rover"};
  for (const SlurmJob& job : {line, backslash, word}) {
    EXPECT_THROW(ScriptsFor(job), SlurmError);
  }
}

// sbatch's own parser is getopt_long(3): long, short, cut short, and several words on a line.
TEST(FurtherOptions, LeaveToTheScriptsWhatTheySet) {
  for (const char* option : {"--array=0-3",
                             "--array 0-3",
                             "--array",
                             "--arr=0-3",
                             "-a 0-3",
                             "-a0-3",
                             "-a=0-3",
                             "--exclusive --array=0-3",
                             "--exclusive -a 0-3",
                             "--output=x",
                             "-o x",
                             "--time=5",
                             "--mem-per-cpu=1G",
                             "--no-requeue",
                             "--nodes=2",
                             "--\"array\" 0-3",
                             "--wrap=ls",
                             "--a=1",
                             "-a 1",
                             "-a1",
                             "-a",
                             "-Qa1",
                             "-Q -a1",
                             "--exclusive -Qa1",
                             "--exclusive\t--arr\t1",
                             "--ARRAY=1",
                             "--Arr=1",
                             "--TIME=5"}) {
    EXPECT_THROW(CheckFurtherOptions({"--account=rover", option}), SlurmError) << option;
  }
}

TEST(FurtherOptions, TakeTheOthers) {
  EXPECT_NO_THROW(CheckFurtherOptions(
      {"--account=rover group", "--exclusive", "--qos=long", "--nice=-5", "--nice -5",
       "--mail-type=END,FAIL", "--comment=see --array", "--exclude=n[1-3]", "--gres=gpu:1",
       "--time-min=5", "--mem-bind=local", "--nodelist=n1", "--X11=all"}));
  EXPECT_THROW(CheckFurtherOptions({"account=rover"}), SlurmError);
  EXPECT_THROW(CheckFurtherOptions({"-A rover"}), SlurmError);
  EXPECT_THROW(CheckFurtherOptions({""}), SlurmError);
  EXPECT_THROW(CheckFurtherOptions({"--qos=a\n#SBATCH --uid=0"}), SlurmError);
}

TEST(Shards, TakeHalfAnHourEachAsFarAsTheyCan) {
  for (const std::int64_t runs : {1, 40, 1000, 100000}) {
    for (const int processors : {1, 4, 32}) {
      for (const double seconds : {0.01, 4.0, 60.0}) {
        const int shards = ChooseShards(runs, processors, seconds, 1000);
        const double task_s = ShardSeconds(runs, shards, processors, seconds);
        ASSERT_GE(shards, 1);
        ASSERT_LE(shards, std::min<std::int64_t>(runs, 1000));
        // Never above half an hour by more than a round of runs, but for too many; and a shard
        // fewer would be above.
        EXPECT_TRUE(task_s <= 1800.0 + seconds || shards == 1000) << runs << " " << processors;
        if (shards > 1) {
          EXPECT_GT(ShardSeconds(runs, shards - 1, processors, seconds), 1800.0 - seconds);
        }
      }
    }
  }
  // 10^4 runs of 4 s: 40 000 s, 22.2 half hours of one processor.
  EXPECT_EQ(ChooseShards(10000, 1, 4.0, 1000), 23);
  EXPECT_EQ(ChooseShards(10000, 1, 4.0, 20), 20);
}

TEST(Shards, HoldEveryRunInRoundsOfTheProcessors) {
  EXPECT_DOUBLE_EQ(ShardSeconds(12, 4, 1, 5.0), 15.0);
  EXPECT_DOUBLE_EQ(ShardSeconds(12, 4, 2, 5.0), 10.0);  // three runs on two processors
  EXPECT_DOUBLE_EQ(ShardSeconds(13, 4, 2, 5.0), 10.0);  // the longest has four
  EXPECT_EQ(TaskMinutes(10.0), 30);
  EXPECT_EQ(TaskMinutes(1800.0), 60);
}

TEST(HighestTask, IsOneLessThanMaxArraySize) {
  EXPECT_EQ(
      HighestTask("MailProg = /bin/mail\nMaxArraySize            = 1001\nMaxDBDMsgs = 20008\n"),
      1000);
  EXPECT_EQ(HighestTask("MaxArraySize=4097"), 4096);
  for (const char* text :
       {"", "MaxArraySize", "MaxArraySize = ", "MaxArraySize = 0", "MaxJobs = 3"}) {
    EXPECT_EQ(HighestTask(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace dockyard
