// A controller in another process: the same run as in our own, and what its faults come to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "app/program.h"
#include "sim/base/json.h"
#include "sim/base/shell_word.h"
#include "sim/base/text.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kScenario = "tests/toy/scenario.yaml --set start.r_m=1 ";

std::string Command(const std::string& words) {
  return "--set 'controller={command: [" + words + "], folder: " + SourceFile("tests/bridge") +
         "}' ";
}

Json RunWith(const std::string& words, const std::string& more = "") {
  const Ended ended =
      Dockyard("run " + kScenario + Command(words) + "--allow-commands --json " + more);
  EXPECT_THAT(ended.code, testing::AnyOf(0, 4)) << ended.err;
  Json json = Json::parse(ended.out, nullptr, false);
  json["said"] = ended.err + json.value("failure_note", "");
  return json;
}

TEST(CommandController, GivesTheSameRunAsTheSameControllerInOurProcess) {
  const Ended own = Dockyard("run " + kScenario + "--json");
  const Json inside = Json::parse(own.out), outside = RunWith("python3, counting.py");
  EXPECT_EQ(outside["state_hash"], inside["state_hash"]);
  EXPECT_EQ(outside["outcome"], inside["outcome"]);
  EXPECT_EQ(outside["miss_m"], inside["miss_m"]);
  EXPECT_EQ(outside["controller"], "command");
}

TEST(CommandController, OfAnotherProtocolIsRefused) {
  const Json run = RunWith("python3, counting.py, first_protocol");
  EXPECT_EQ(run["outcome"], "controller_error");
  EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("it speaks protocol 1, expected 4"));
}

TEST(CommandController, HelloOfAnyShapeIsAnOutcome) {
  for (const char* hello :
       {"deep_list", "deep_object", "real_protocol", "large_protocol", "text_protocol", "listed"}) {
    const Json run = RunWith(std::string("python3, counting.py, ") + hello);
    EXPECT_EQ(run["outcome"], "controller_error") << hello;
    EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("a bad hello: ")) << hello;
  }
}

TEST(CommandController, ExposureMustBeOneThatCamerasHave) {
  EXPECT_EQ(RunWith("python3, counting.py, stops")["outcome"], "at_flag");
  for (const char* fault : {"nan_stops", "far_stops"}) {
    const Json run = RunWith(std::string("python3, counting.py, ") + fault);
    EXPECT_EQ(run["outcome"], "controller_error") << fault;
    EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("within 6 stops")) << fault;
  }
}

TEST(CommandController, ReplaysFromItsLog) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  RunWith("python3, counting.py", "--out " + out);
  const Ended replay = Dockyard("replay " + out + " --allow-commands");
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("controller alone: same commands at all"));
}

TEST(CommandController, ThatNeverSaidHelloReplaysAsTheSameFailure) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  RunWith("no_such_program_here", "--out " + out);
  const Ended replay = Dockyard("replay " + out + " --allow-commands");
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("controller alone: fails as it did in the run"));
}

/// A folder with a table and a sweep of the toy whose controller is the given program.
void WriteCommandFiles(const fs::path& folder, const std::string& words) {
  const std::string base = "base: " + SourceFile("tests/toy/scenario.yaml") + "\n";
  const std::string command = "controller: {command: [" + words + "], folder: .}";
  WriteText(folder / "campaign.yaml", "campaign: c\nseed: 1\n" + base + "scenario: {" + command +
                                          "}\nruns: [{run: 1, start.r_m: 1}]\n");
  WriteText(folder / "sweep.yaml",
            "campaign: s\n" + base + "arms: {mine: {" + command + "}}\nvary: {start.r_m: [1]}\n");
}

TEST(CommandController, IsNeverStartedUnasked) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string();
  const std::string mark = in + "/started";
  const std::string command = Command("touch, " + mark);
  WriteCommandFiles(folder.path(), "touch, " + mark);
  RunWith("python3, counting.py", "--out " + in + "/run");
  const std::vector<std::string> refused{
      "run " + kScenario + command, "campaign " + in + "/campaign.yaml --out " + in + "/c",
      "campaign " + in + "/sweep.yaml --out " + in + "/s", "replay " + in + "/run"};
  for (const std::string& words : refused) {
    const Ended ended = Dockyard(words);
    EXPECT_EQ(ended.code, 3) << words << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("--allow-commands")) << words;
  }
  for (const char* file : {"/campaign.yaml", "/sweep.yaml"}) {
    EXPECT_EQ(Dockyard("check " + in + file).code, 0) << file;
  }
  EXPECT_FALSE(fs::exists(mark));
  Dockyard("campaign " + in + "/campaign.yaml --allow-commands --out " + in + "/c");
  EXPECT_TRUE(fs::exists(mark));
}

TEST(CommandController, ThatDiesIsAnOutcomeWithItsLastWords) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  const Json run = RunWith("python3, counting.py, crash", "--out " + out);
  EXPECT_EQ(run["outcome"], "controller_crashed");
  EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("RuntimeError: the wheel fell off"));
  EXPECT_THAT(Slurp(folder.path() / "run" / "messages.txt"), HasSubstr("the wheel fell off"));
  EXPECT_GT(run["sim_time_s"].get<double>(), 0.5);
}

TEST(CommandController, LastWordsThatAreNoTextAreKeptAsTheyAre) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  const Json run = RunWith("python3, counting.py, crash_in_bytes", "--out " + out);
  EXPECT_EQ(run["outcome"], "controller_crashed");
  EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("exit code 3, bad ?? words"));
  EXPECT_THAT(Slurp(folder.path() / "run" / "messages.txt"), HasSubstr("bad \xff\xfe words"));
}

TEST(CommandController, ThatDiesWhileItsChildLivesHasCrashed) {
  EXPECT_EQ(RunWith("python3, counting.py, child", "--answer-limit 20")["outcome"],
            "controller_crashed");
}

TEST(CommandController, ThatCannotBeStartedSaysWhy) {
  const Json run = RunWith("no_such_program_here");
  EXPECT_EQ(run["outcome"], "controller_crashed");
  EXPECT_THAT(run["said"].get<std::string>(), HasSubstr("cannot start no_such_program_here"));
}

TEST(CommandController, ThatHangsIsEndedAtTheAnswersLimit) {
  const Json run = RunWith("python3, counting.py, hang", "--answer-limit 0.5");
  EXPECT_EQ(run["outcome"], "controller_timeout");
  // Beliefs without end are no answer.
  EXPECT_EQ(RunWith("python3, counting.py, believe", "--answer-limit 1")["outcome"],
            "controller_timeout");
}

TEST(CommandController, IsStoppedAtTheRunsLimit) {
  const std::string run = "run " + kScenario + Command("python3, counting.py, hang") +
                          "--allow-commands --answer-limit 60 --json --run-limit ";
  const Ended ended = Dockyard(run + "1");
  EXPECT_EQ(ended.code, 10) << ended.err;
  const Json json = Json::parse(ended.out, nullptr, false);
  EXPECT_EQ(json["outcome"], "stopped");
  EXPECT_THAT(json["failure_note"].get<std::string>(), HasSubstr("more than 1 s of wall time"));
  EXPECT_GE(json["controller_wall_s"].get<double>(), 0.9);
  EXPECT_GT(json["controller_cpu_s"].get<double>(), 0.0);
}

TEST(CommandController, TimesItsProgramFromItsStart) {
  const Json run = RunWith("sh, -c, \"sleep 0.3; exec python3 counting.py\"");
  EXPECT_EQ(run["outcome"], "at_flag");
  EXPECT_GE(run["controller_wall_s"].get<double>(), 0.3);
  EXPECT_FALSE(
      Json::parse(Dockyard("run " + kScenario + "--json").out).contains("controller_wall_s"));
}

TEST(CommandController, LogsOfItsPhaseTheBeginning) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  RunWith("python3, counting.py, long_phase", "--out " + out);
  const std::string history = Slurp(folder.path() / "run" / "history.csv");
  std::string most;
  for (int i = 0; i < 100; ++i) most += "\u00e9";
  EXPECT_THAT(history, HasSubstr("," + most + " ...,"));
}

/// Cells of a table by its header, row by row.
std::vector<std::map<std::string, std::string>> TableOf(const fs::path& file) {
  std::vector<std::map<std::string, std::string>> rows;
  std::istringstream lines(Slurp(file));
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> header = SplitCsv(line).value();
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = SplitCsv(line).value();
    std::map<std::string, std::string>& row = rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = cells.at(i);
  }
  return rows;
}

// The robot goes on after each answer: at a sample it says how far it had come at this time.
TEST(CommandController, HasAllItsValuesInATableAtTheirTimes) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "run";
  RunWith("python3, counting.py, values", "--out " + out.string());
  const auto values = TableOf(out / "values.csv"), history = TableOf(out / "history.csv");
  ASSERT_EQ(values.size(), history.size());
  ASSERT_GT(values.size(), 10u);
  const double start_m = std::stod(history[0].at("believed_x_m"));
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(values[i].at("time_s"), history[i].at("time_s"));
    const double gone_m = std::stod(values[i].at("gone_m"));
    EXPECT_NEAR(gone_m, start_m - std::stod(history[i].at("believed_x_m")), 1e-9);
    EXPECT_EQ(values[i].at("'=late"), gone_m > start_m - gone_m ? "2" : "nan");
  }
  EXPECT_GT(std::stod(values.back().at("gone_m")), 0.9);
}

TEST(CommandController, ThatSaysWhatItFoundReplaysAsTheSame) {
  const TemporaryFolder folder;
  const std::string plain = (folder.path() / "plain").string();
  const Json without = RunWith("python3, counting.py", "--out " + plain);
  for (const char* what : {"values", "pose"}) {
    const std::string out = (folder.path() / what).string();
    const Json run = RunWith(std::string("python3, counting.py, ") + what, "--out " + out);
    EXPECT_EQ(run["state_hash"], without["state_hash"]);
    const Ended replay = Dockyard("replay " + out + " --allow-commands");
    EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
    EXPECT_THAT(replay.out, HasSubstr("same result row, bit for bit"));
    EXPECT_THAT(replay.out, HasSubstr("same commands at all"));
  }
  EXPECT_FALSE(fs::exists(fs::path(plain) / "values.csv"));
  EXPECT_EQ(Slurp(fs::path(plain) / "sightings.json"), "[]\n");
  const Json sightings = Json::parse(Slurp(folder.path() / "pose" / "sightings.json"));
  ASSERT_GT(sightings.size(), 10u);
  EXPECT_EQ(sightings[0]["accepted"], true);
  EXPECT_EQ(sightings[0]["X_RB"]["p_m"], Json::array({1.0, 0.0, 0.0}));
}

TEST(CommandController, WithMarksOrAPoseOfAnotherShapeIsAnError) {
  for (const auto& [fault, said] :
       {std::pair{"bad_pose", "a bad belief: a pose without p_m"},
        {"marks", "a bad belief: a mark, but the robot has no camera"}}) {
    const Json run = RunWith(std::string("python3, counting.py, ") + fault);
    EXPECT_EQ(run["outcome"], "controller_error") << fault;
    EXPECT_THAT(run["said"].get<std::string>(), HasSubstr(said)) << fault;
  }
}

TEST(CommandController, ThatAnswersNonsenseIsAnError) {
  EXPECT_EQ(RunWith("echo, hello world")["outcome"], "controller_error");
  EXPECT_EQ(RunWith("python3, counting.py, motors")["outcome"], "controller_error");
  EXPECT_EQ(RunWith("python3, counting.py, not_a_number")["outcome"], "controller_error");
}

TEST(CommandController, ThatHasChangedIsNotTheSameCampaign) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string();
  WriteCommandFiles(folder.path(), "sh, controller.sh");
  const std::string campaign =
      "campaign " + in + "/campaign.yaml --quiet --allow-commands --out " + in + "/out";
  WriteText(folder.path() / "controller.sh", "exit 1\n");
  EXPECT_EQ(Dockyard(campaign).code, 0);
  EXPECT_EQ(Dockyard(campaign).code, 0);
  WriteText(folder.path() / "controller.sh", "exit 2\n");
  const Ended changed = Dockyard(campaign);
  EXPECT_EQ(changed.code, 2);
  EXPECT_THAT(changed.err, HasSubstr("it was begun with another files/controller.sh"));
}

TEST(CommandController, CostsOneRunOfACampaign) {
  const TemporaryFolder folder;
  const std::string out = folder.path().string();
  const Ended end =
      Dockyard("campaign tests/toy/campaign.yaml --quiet --allow-commands --out " + out +
               " --set 'scenario={controller: {command: [python3, counting.py, crash], "
               "folder: " +
               SourceFile("tests/bridge") + "}}'");
  EXPECT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("controller_crashed"));
  EXPECT_THAT(Slurp(folder.path() / "runs" / "001" / "messages.txt"),
              HasSubstr("the wheel fell off"));
}

/// The data of a report's page, which are compressed in it.
std::string DataOf(const std::string& page) {
  const std::string text = page + ".txt";
  const std::string unpack =
      "import base64, gzip, re, sys; page = open(sys.argv[1]).read(); "
      "data = re.search('id=\"data\">([^<]*)<', page).group(1); "
      "open(sys.argv[2], 'wb').write(gzip.decompress(base64.b64decode(data)))";
  const std::string command = "python3 -c " + ShellWord(unpack) + " " + page + " " + text;
  EXPECT_EQ(std::system(command.c_str()), 0);
  return Slurp(text);
}

TEST(CommandController, IsReplayedWithTheLimitOfItsAnswers) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string(), out = in + "/out";
  WriteCommandFiles(folder.path(), "sh, controller.sh");
  WriteText(folder.path() / "controller.sh", "exit 1\n");
  const auto Ends = [&](const std::string& dir, int run) {
    return HasSubstr(" replay " + dir + " " + std::to_string(run) +
                     " --allow-commands --answer-limit 20 ");
  };
  const Ended campaign = Dockyard("campaign " + in + "/campaign.yaml --quiet --allow-commands " +
                                  "--answer-limit 20 --out " + out);
  EXPECT_THAT(campaign.out, Ends(out, 1)) << campaign.err;
  EXPECT_THAT(Dockyard("merge " + out).out, Ends(out, 1));
  const std::string page = in + "/page.html", single = in + "/run";
  RunWith("python3, counting.py", "--answer-limit 20 --out " + single + " --report=" + page);
  EXPECT_THAT(DataOf(page), HasSubstr(" replay " + single + " --allow-commands --answer-limit 20"));
}

TEST(CommandController, OfACampaignCanBeTerminated) {
  const TemporaryFolder folder;
  const std::string in = folder.path().string();
  WriteCommandFiles(folder.path(), "sh, terminated.sh");
  WriteText(folder.path() / "terminated.sh", "kill -TERM $$\nsleep 60\n");
  Dockyard("campaign " + in + "/campaign.yaml --quiet --allow-commands --out " + in + "/out");
  EXPECT_THAT(Slurp(folder.path() / "out/results.csv"), HasSubstr("controller_crashed"));
}

}  // namespace
}  // namespace dockyard
