// A system that no generic room names goes through the whole program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "app/program.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "support/fake_runs.h"
#include "support/program_path.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kToy = "tests/toy/";

class Toy : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = fs::temp_directory_path() / ("dockyard_toy_" + std::to_string(::getpid()));
    fs::remove_all(dir_);
  }
  void TearDown() override { fs::remove_all(dir_); }
  std::string Text(const std::string& name) const { return ReadWhole(dir_ / name).value_or(""); }
  fs::path dir_;
};

TEST_F(Toy, RunsIsCheckedAndReplays) {
  EXPECT_EQ(Dockyard("check " + kToy + "scenario.yaml").code, 0);
  const auto run = Dockyard("run " + kToy + "scenario.yaml --out " + dir_.string());
  EXPECT_THAT(run.out, HasSubstr("  miss  "));
  EXPECT_THAT(Text("history.csv"), HasSubstr("wheel_rad"));
  const auto replay = Dockyard("replay " + dir_.string());
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("same commands at all"));
}

TEST_F(Toy, DetectsWithAPerceptionOfItsOwn) {
  EXPECT_EQ(Dockyard("check " + kToy + "point.yaml").code, 0);
  const auto own = Dockyard("detect a.png --robot " + kToy + "point.yaml --blinking 3");
  EXPECT_EQ(own.code, 0) << own.err;
  EXPECT_EQ(own.out, "a lamp seen by a point, asked with 5 words\n");
  EXPECT_EQ(Dockyard("detect a.png --robot=" + kToy + "point.yaml").out,
            "a lamp seen by a point, asked with 2 words\n");
  // A file of another system is the program's matter, which misses --board.
  EXPECT_EQ(Dockyard("detect a.png --robot models/axel/axel.yaml").code, 2);
}

TEST_F(Toy, ListsWhatItReproduces) {
  const auto list = Dockyard("reproduce");
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.out, testing::StartsWith("toy: Drives to the flag.\ntoy_never: "));
  const auto unknown = Dockyard("reproduce tay");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("expected one of toy, toy_never, toy_drawn, found 'tay'"));
}

// Half of the drives end at the flag, which 6 of 12 agrees with.
TEST_F(Toy, ReproducesACountThatItsRunsPredict) {
  const std::string command = "reproduce toy --quiet --out " + dir_.string();
  const auto end = Dockyard(command);
  EXPECT_EQ(end.code, 0) << end.out << end.err;
  EXPECT_THAT(end.out, HasSubstr("36 runs, 3 replications"));
  EXPECT_THAT(end.out,
              HasSubstr("inside: the paper's total, and each row and measure that counts"));
  EXPECT_THAT(end.out, HasSubstr("what was chosen"));
  EXPECT_THAT(end.out, HasSubstr("system: toy"));  // of the file of choices
  EXPECT_THAT(Text("grid/results.csv"), HasSubstr("start.r_m"));
  EXPECT_THAT(Text("other/results.csv"), HasSubstr("toy.speed_m_s"));
  const Json json = Json::parse(Text("reproduction.json"));
  EXPECT_EQ(json.at("verdict"), "inside");
  EXPECT_EQ(json.at("rows").at(1).at("runs"), 18);
  EXPECT_EQ(json.at("measures").at(1).at("runs"), 2);
  for (const char* figure : {"starts", "one_path", "one_history"}) {
    EXPECT_THAT(Text("figures/" + std::string(figure) + ".svg"), HasSubstr("<svg")) << figure;
  }
  // Again: nothing is simulated, the table is the same.
  EXPECT_EQ(Dockyard(command).out, end.out);
  EXPECT_EQ(Dockyard(command + " --replications 4").code, 2);  // another campaign
}

TEST_F(Toy, ReplicatesAllRunsOfACampaignThatDrawsThem) {
  const auto end = Dockyard("reproduce toy_drawn --quiet --out " + dir_.string());
  EXPECT_NE(end.code, 10) << end.out << end.err;
  EXPECT_THAT(end.out, HasSubstr("120 runs, 2 replications"));
  const Json json = Json::parse(Text("reproduction.json"));
  EXPECT_EQ(json.at("rows").at(0).at("runs"), 120);
  EXPECT_NE(json.at("verdict"), "not judged");
  const auto plan = Dockyard("reproduce toy_drawn --replications 3 --dry-run");
  EXPECT_EQ(std::count(plan.out.begin(), plan.out.end(), '\n'), 1 + 180);
}

TEST_F(Toy, EndsWithItsCodeWhereACountIsOutside) {
  const auto end = Dockyard("reproduce toy_never --quiet --json --out " + dir_.string());
  EXPECT_EQ(end.code, 30) << end.out << end.err;
  EXPECT_THAT(end.out, HasSubstr("\"verdict\":\"outside\""));
  EXPECT_THAT(Text("reproduction.txt"), HasSubstr("\noutside: all\n"));
}

TEST_F(Toy, DoesNotJudgeOtherRunsThanThePapers) {
  const std::string out = " --quiet --out " + dir_.string();
  const auto part =
      Dockyard("reproduce toy_never --replications 1 --set 'vary={start.r_m: [1, 2]}'" + out);
  EXPECT_EQ(part.code, 10) << part.err;
  EXPECT_THAT(part.out, HasSubstr("2 of 12 runs: not judged"));
  EXPECT_THAT(part.out, HasSubstr("not judged: these runs are not those of the paper: all, near"));
}

TEST_F(Toy, ReproducesInShardsAndParts) {
  const std::string command = "reproduce toy --quiet --out " + dir_.string();
  EXPECT_EQ(Dockyard(command + " --only grid --shard 1/2").code, 0);
  EXPECT_EQ(Dockyard(command + " --only grid --shard 2/2").code, 0);
  EXPECT_FALSE(fs::exists(dir_ / "reproduction.json"));
  const auto grid = Dockyard(command + " --only grid");
  EXPECT_EQ(grid.code, 0) << grid.err;
  EXPECT_THAT(grid.out, testing::ContainsRegex("other drives +1-6 s +not run"));
  EXPECT_THAT(Dockyard(command + " --only other").out, testing::Not(HasSubstr("not run")));
  EXPECT_EQ(Dockyard(command + " --only athor").code, 2);
}

TEST_F(Toy, KeepsTheSightingsOfEveryRunWithoutItsLog) {
  const std::string campaign =
      "campaign " + kToy +
      "twelve.yaml --quiet --set 'keep={failures_per_cause: 1, every_nth_success: 0, sightings: "
      "true}' --out " +
      dir_.string();
  EXPECT_EQ(Dockyard(campaign).code, 0);
  const auto files = [](const fs::path& dir) {
    return std::distance(fs::directory_iterator(dir), fs::directory_iterator());
  };
  EXPECT_EQ(files(dir_ / "sightings"), 12);
  EXPECT_EQ(Text("sightings/012.json"), "[]\n");  // the toy sees nothing
  EXPECT_EQ(files(dir_ / "runs"), 1);
  fs::remove_all(dir_ / "all");
  EXPECT_EQ(Dockyard("merge " + (dir_ / "all").string() + " " + dir_.string()).code, 0);
  EXPECT_EQ(files(dir_ / "all" / "sightings"), 12);
}

TEST_F(Toy, RefusesReproductionsThatMakeNoSense) {
  EXPECT_EQ(Dockyard("reproduce toy --replications 0").code, 2);
  EXPECT_EQ(Dockyard("reproduce toy --shard 1/2 --report").code, 2);
  fs::create_directories(dir_);
  WriteText(dir_ / "mine.txt", "not to be touched");
  EXPECT_EQ(Dockyard("reproduce toy --out " + dir_.string()).code, 2);
  EXPECT_FALSE(fs::exists(dir_ / "grid"));
  const auto plan = Dockyard("reproduce toy --replications 2 --dry-run");
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_EQ(std::count(plan.out.begin(), plan.out.end(), '\n'), 1 + 24);
}

TEST_F(Toy, ChecksWhatIsPublishedOfIt) {
  const auto good = Dockyard("check " + kToy + "published.yaml");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_THAT(good.out, HasSubstr("published experiment: toy: 3 rows, 1 of them judged"));
  std::string text = Slurp(SourceFile(kToy + "published.yaml"));
  for (const char* file : {"twelve.yaml", "campaign.yaml", "scenario.yaml"}) {
    text = Replaced(text, file, SourceFile(kToy + file));
  }
  fs::create_directories(dir_);
  WriteText(dir_ / "p.yaml", Replaced(text, "counted: [at_flag]", "counted: [at_flog]"));
  const auto bad = Dockyard("check " + (dir_ / "p.yaml").string());
  EXPECT_EQ(bad.code, 3);
  EXPECT_THAT(bad.err,
              HasSubstr("p.yaml:8:11: counted[0]: expected an outcome of the system, found "
                        "'at_flog'; nearest is 'at_flag'"));
}

TEST_F(Toy, IsTheOnlySystemThatItsProgramsHelpNames) {
  EXPECT_THAT(Dockyard("--help").out, HasSubstr(" run tests/toy/scenario.yaml"));
  for (const char* command :
       {"", "run ", "campaign ", "replay ", "view ", "camera ", "detect ", "pose ", "board ",
        "check ", "wheel ", "reproduce ", "submit ", "stereo ", "plan "}) {
    const auto help = Dockyard(std::string(command) + "--help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_THAT(help.out, testing::Not(testing::AnyOf(HasSubstr("axel"), HasSubstr(" scenarios/"))))
        << command;
  }
}

TEST_F(Toy, TheTruthDecidesNotTheClaim) {
  int hits = 0, misses = 0;
  for (int seed = 1; seed <= 20; ++seed) {
    const auto run = Dockyard("run " + kToy + "scenario.yaml --seed " + std::to_string(seed));
    hits += run.code == 0;
    misses += run.code == 4;
  }
  // Put down within +-10 cm and judged at +-5 cm: half of 20 each on the mean.
  EXPECT_EQ(hits + misses, 20);
  EXPECT_GT(hits, 3);
  EXPECT_GT(misses, 3);
}

TEST_F(Toy, GoesThroughACampaignWithKeysAndTagsOfItsOwn) {
  EXPECT_EQ(Dockyard("check " + kToy + "campaign.yaml").code, 0);
  const auto end = Dockyard("campaign " + kToy + "campaign.yaml --quiet --out " + dir_.string());
  EXPECT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(Text("results.csv"),
              HasSubstr("run,seed,system,controller,weather,start.r_m,"
                        "toy.speed_m_s,success,success_word,docked,outcome,sim_time_s,images,"
                        "miss_m,margin.miss_m,state_hash\n"));
  EXPECT_THAT(Text("results.csv"), HasSubstr(",toy,counting,windy,3,1,"));
  EXPECT_THAT(end.out, HasSubstr("weather"));
  EXPECT_EQ(Dockyard("replay " + dir_.string() + " 3").code, 0);
}

TEST_F(Toy, GoesThroughASweepOfAKey) {
  const auto end = Dockyard("campaign " + kToy + "sweep.yaml --quiet --out " + dir_.string());
  EXPECT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(Text("points.csv"), HasSubstr("miss_m_mean"));
  EXPECT_THAT(Text("plots/curves.svg"), HasSubstr("toy_sweep, 9 runs"));
  EXPECT_FALSE(fs::exists(dir_ / "runs"));
  const auto former = Dockyard("study " + kToy + "sweep.yaml");
  EXPECT_EQ(former.code, 2);
  EXPECT_THAT(former.err, HasSubstr("a study is a campaign: dockyard campaign FILE"));
}

TEST_F(Toy, ASuccessHasAPositiveMarginAndAMissANegativeOne) {
  const auto end = Dockyard("campaign " + kToy + "arms.yaml --quiet --out " + dir_.string() +
                            " --require 'margin.miss_m.min >= 0' --require 'docked >= 0'");
  EXPECT_EQ(end.code, 22) << end.err;
  EXPECT_THAT(end.out, HasSubstr("not met: margin.miss_m.min >= 0, found -0."));
  EXPECT_THAT(end.out, HasSubstr("met: docked >= 0, found "));
  EXPECT_THAT(end.out, HasSubstr("\nlimits: runs that broke them, and the least margin of those "
                                 "that at flag\n  miss_m  "));
}

TEST_F(Toy, ReadsTheResultsOfAnEarlierProgram) {
  const std::string dir = dir_.string();
  fs::copy(SourceFile(kToy + "former_results"), dir_, fs::copy_options::recursive);
  ASSERT_THAT(Text("results.csv"), HasSubstr(",toy.speed_m_s,docked,outcome,"));
  const auto audit = Dockyard("audit " + dir + " --sample 4");  // each run again, and each line
  EXPECT_EQ(audit.code, 0) << audit.out << audit.err;
  EXPECT_THAT(audit.out, HasSubstr("4 of 4 runs the same"));
  EXPECT_THAT(Dockyard("replay " + dir + " 3").out, HasSubstr("run 3: same result row, bit for"));
  EXPECT_EQ(Dockyard("report " + dir + " --out " + dir + "/page.html").code, 0);
  const auto on = Dockyard("campaign " + kToy + "campaign.yaml --quiet --out " + dir);
  EXPECT_EQ(on.code, 2);
  EXPECT_THAT(on.err, HasSubstr("another program"));
  const auto merge = Dockyard("merge " + dir + " --require 'success >= 0.2'");
  EXPECT_EQ(merge.code, 0) << merge.err;
  EXPECT_THAT(merge.out, HasSubstr("toy_campaign: at flag "));
  EXPECT_THAT(Text("results.csv"), HasSubstr(",success,success_word,docked,outcome,"));
  EXPECT_EQ(Dockyard("audit " + dir + " --sample 4").code, 0);  // of the table as it is now
}

// The page's lines for Python's standard library, as they stand there.
TEST_F(Toy, IsReadByThePythonOfThePage) {
  ASSERT_EQ(Dockyard("campaign " + kToy + "sweep.yaml --quiet --out " + dir_.string()).code, 0);
  const std::string page = Slurp(SourceFile("docs/reference/run_log.md")), fence = "```python\n";
  const std::size_t from = page.find(fence) + fence.size();
  std::string code = page.substr(from, page.find("```\n", from) - from);
  const std::string folder = "results/yard";
  ASSERT_NE(code.find(folder), std::string::npos);
  code.replace(code.find(folder), folder.size(), dir_.string());
  WriteText(dir_ / "read.py", code);
  const std::string out = (dir_ / "read.txt").string();
  EXPECT_EQ(std::system(("python3 " + (dir_ / "read.py").string() + " >" + out).c_str()), 0);
  EXPECT_THAT(Text("read.txt"), testing::StartsWith("(9, "));
}

TEST_F(Toy, IsJudgedAndItsArmsAreCompared) {
  const auto end = Dockyard("campaign " + kToy + "arms.yaml --quiet --out " + dir_.string());
  ASSERT_EQ(end.code, 0) << end.err;
  const std::string judge = "accept " + dir_.string() + " --reliability 0.9 --json";
  EXPECT_EQ(Dockyard(judge).code, 2);  // which arm?
  const auto verdict = Dockyard(judge + " --arm slow");
  EXPECT_THAT(verdict.out, HasSubstr("\"trials\": 10"));
  EXPECT_THAT(verdict.out, HasSubstr("\"planned\": 10"));
  EXPECT_TRUE(verdict.code == 20 || verdict.code == 21) << verdict.code;
  const auto compared = Dockyard("compare " + dir_.string() + " slow fast");
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_THAT(compared.out, HasSubstr("slow less fast: "));
  EXPECT_EQ(Dockyard("compare " + dir_.string() + " slow quick").code, 2);
}

TEST_F(Toy, JudgesNoGridAsOneSampleButEachPointOfIt) {
  ASSERT_EQ(Dockyard("campaign " + kToy + "sweep.yaml --quiet --set design.runs=20 --out " +
                     dir_.string())
                .code,
            0);
  const std::string judge = "accept " + dir_.string() + " --reliability 0.05 ";
  const auto refused = Dockyard(judge);
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("points of a grid (vary); --by start.r_m judges each"));
  EXPECT_EQ(Dockyard(judge + "--by start.alpha_deg").code, 2);
  const auto by = Dockyard(judge + "--json --by start.r_m");
  const Json json = Json::parse(by.out);
  ASSERT_EQ(json["points"].size(), 3u) << by.out;
  EXPECT_EQ(json["points"][0]["value"], "1");
  EXPECT_EQ(json["trials"], 60);
  EXPECT_NEAR(json["family_error"].get<double>(), 0.05, 1e-15);
  EXPECT_NEAR(json["confidence_of_each"].get<double>(), 1.0 - 0.05 / 3, 1e-15);
  for (const Json& point : json["points"]) {
    EXPECT_EQ(point["runs"], 20);
    // Of the bound's equation: P(X <= failures; 20, 1 - lower) = 0.05 / 3.
    const double lower = point["lower"];
    double chance = 0.0, term = std::pow(lower, 20);
    for (int k = 0; k <= point["failures"].get<int>(); ++k) {
      chance += term;
      term *= (1.0 - lower) / lower * (20 - k) / (k + 1);
    }
    EXPECT_NEAR(chance, 0.05 / 3, 1e-9);
  }
  EXPECT_EQ(by.code, json["verdict"] == "accepted" ? 0 : json["verdict"] == "undecided" ? 21 : 20);
  EXPECT_EQ(Dockyard(judge + "--by start.r_m").code, by.code);
  EXPECT_THAT(Dockyard(judge + "--by start.r_m").out, HasSubstr("Bonferroni"));
}

TEST_F(Toy, CountsNoRunsWithAKeyChangedAloneAsTheRest) {
  ASSERT_EQ(Dockyard("campaign " + kToy +
                     "draws.yaml --quiet --set design.runs=20 --set "
                     "'one_at_a_time={time_limit_s: [0.1]}' --out " +
                     dir_.string())
                .code,
            0);
  const auto refused = Dockyard("accept " + dir_.string() + " --reliability 0.5");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("it sets keys one at a time; --by changed --by changed_to"));
  EXPECT_THAT(Text("summary.txt"), HasSubstr("not counted there: 20 runs in which a key was"));
  EXPECT_THAT(Text("summary.txt"), HasSubstr("/20 ("));
  // Of the changed runs none docks: they are paired with the others by their seeds.
  const auto compared =
      Dockyard("compare " + dir_.string() + " changed= changed=time_limit_s --json");
  const Json json = Json::parse(compared.out);
  EXPECT_EQ(json["paired"], true);
  EXPECT_EQ(json["only_a"].get<int>() + json["neither"].get<int>(), 20);
  EXPECT_EQ(json["only_b"], 0);
}

TEST_F(Toy, RefusesToJudgeStratifiedDesigns) {
  for (const char* kind : {"latin_hypercube", "sobol"}) {
    const std::string out = (dir_ / kind).string();
    ASSERT_EQ(Dockyard("campaign " + kToy + "draws.yaml --quiet --set design.kind=" + kind +
                       " --out " + out)
                  .code,
              0);
    const auto refused = Dockyard("accept " + out + " --reliability 0.5");
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.err, HasSubstr("depend on each other"));
    EXPECT_EQ(Dockyard("accept " + out + " --reliability 0.5 --by toy.speed_m_s").code, 2);
  }
}

TEST_F(Toy, ComparesGroupsThatALabelTellsApart) {
  ASSERT_EQ(Dockyard("campaign " + kToy + "draws.yaml --quiet --out " + dir_.string()).code, 0);
  const std::string compare = "compare " + dir_.string();
  const auto groups = Dockyard(compare + " toy.speed_m_s=slow toy.speed_m_s=fast --json");
  const Json json = Json::parse(groups.out);
  EXPECT_EQ(json["paired"], false);
  EXPECT_EQ(json["a"]["runs"].get<int>() + json["b"]["runs"].get<int>(), 60);
  EXPECT_THAT(Dockyard(compare + " toy.speed_m_s=slow toy.speed_m_s=fast").out,
              HasSubstr("exact (Fisher)"));
  const auto unknown = Dockyard(compare + " toy.speed_m_s=slow toy.speed_m_s=quick");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("(slow, fast), found 'quick'"));
  EXPECT_EQ(Dockyard(compare + " soil=a soil=b").code, 2);
  EXPECT_EQ(Dockyard(compare + " toy.speed_m_s=slow start.r_m=1").code, 2);
}

TEST_F(Toy, RunsUntilASequentialTestHasDecided) {
  const std::string campaign = "campaign " + kToy + "draws.yaml --quiet --until-accepted ";
  const std::string bad = campaign + "--reliability 0.8 --design-reliability 0.95 --out ";
  const fs::path serial = dir_ / "serial", parallel = dir_ / "parallel";
  const auto ended = Dockyard(bad + serial.string() + " --jobs 1");
  EXPECT_EQ(ended.code, 20) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("not accepted after "));
  EXPECT_THAT(ended.out, HasSubstr("a system at 0.8: accepted with the chance 0.0"));
  const std::string kept = ReadWhole(serial / "acceptance.json").value_or("");
  EXPECT_THAT(kept, HasSubstr("\"verdict\": \"not accepted\""));
  EXPECT_EQ(Dockyard(bad + parallel.string() + " --jobs 3").code, 20);
  EXPECT_EQ(ReadWhole(parallel / "acceptance.json"), kept);
  for (const char* file : {"results.csv", "summary.txt", "sensitivity.csv"}) {
    EXPECT_EQ(ReadWhole(parallel / file), ReadWhole(serial / file)) << file;
  }
  EXPECT_EQ(Dockyard("merge " + parallel.string()).code, 10);
  EXPECT_EQ(ReadWhole(parallel / "results.csv"), ReadWhole(serial / "results.csv"));
  // The same command again finds it decided; other aims are refused.
  EXPECT_EQ(Dockyard(bad + serial.string()).code, 20);
  EXPECT_EQ(ReadWhole(serial / "acceptance.json"), kept);
  const auto other =
      Dockyard(campaign + "--reliability 0.1 --design-reliability 0.9 --out " + serial.string());
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("has other aims"));
  EXPECT_THAT(Dockyard("accept " + serial.string() + " --reliability 0.1").err,
              HasSubstr("a sequential test ended this campaign"));
  const auto good = Dockyard(campaign + "--reliability 0.1 --design-reliability 0.5 --json --out " +
                             (dir_ / "good").string());
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_THAT(good.out, HasSubstr("{\"verdict\":\"accepted\""));
  EXPECT_EQ(Dockyard(campaign + "--reliability 0.4 --design-reliability 0.5 --max-runs 3 --out " +
                     (dir_ / "open").string())
                .code,
            21);
}

TEST_F(Toy, RefusesASequentialTestThatWouldNotHold) {
  const std::string aims = " --until-accepted --reliability 0.8 --design-reliability 0.9 ";
  for (const std::string& arguments :
       {"arms.yaml" + aims, "sweep.yaml" + aims, "campaign.yaml" + aims,
        std::string("draws.yaml --until-accepted"), std::string("draws.yaml --reliability 0.9"),
        "draws.yaml --max-runs 61" + aims, "draws.yaml --require 'success >= 0'" + aims,
        "draws.yaml --shard 1/2" + aims, "draws.yaml --retry-crashed" + aims,
        std::string("draws.yaml --until-accepted --reliability 0.9 --design-reliability 0.8")}) {
    EXPECT_EQ(Dockyard("campaign " + kToy + arguments + " --out " + dir_.string()).code, 2)
        << arguments;
  }
  EXPECT_FALSE(fs::exists(dir_));
}

TEST_F(Toy, MeetsRequirementsOrEndsWithTheirCode) {
  const std::string campaign = "campaign " + kToy + "arms.yaml --quiet --out " + dir_.string();
  const auto unknown = Dockyard(campaign + " --require 'dockd >= 0.5'");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("expected one of success, sim_time_s, miss_m"));
  EXPECT_FALSE(fs::exists(dir_));
  const std::string junit = (dir_ / "junit.xml").string();
  const auto met = Dockyard(campaign +
                            " --require 'success >= 0' --require 'miss_m[arm=fast].max "
                            "<= 1' --junit " +
                            junit);
  EXPECT_EQ(met.code, 0) << met.err;
  EXPECT_THAT(met.out, HasSubstr("met: success >= 0, found "));
  EXPECT_THAT(Text("junit.xml"), HasSubstr("<testcase classname=\"toy_arms.fast\" name=\"run 2"));
  EXPECT_THAT(Text("junit.xml"), HasSubstr("again: " + ProgramPath() + " replay " + dir_.string()));
  const std::string merge = "merge " + dir_.string();
  const auto missed = Dockyard(merge + " --require 'success.lower95 >= 0.99' --json");
  EXPECT_EQ(missed.code, 22);
  EXPECT_THAT(missed.out, HasSubstr("\"met\":false"));
  EXPECT_EQ(Dockyard(merge + " --require 'success[arm=slow] >= 0'").code, 0);
  EXPECT_EQ(Dockyard(merge + " --require 'success[arm=slw] >= 0'").code, 2);
  EXPECT_EQ(Dockyard("campaign " + kToy + "arms.yaml --shard 1/2 --require 'success >= 0'").code,
            2);
}

TEST_F(Toy, TellsWhatItsSuccessDependsOn) {
  const auto end = Dockyard("campaign " + kToy + "draws.yaml --quiet --out " + dir_.string());
  ASSERT_EQ(end.code, 0) << end.err;
  EXPECT_THAT(end.out, HasSubstr("sensitivity of success to the draws, 60 runs"));
  EXPECT_THAT(Text("summary.txt"), HasSubstr("slow "));
  EXPECT_THAT(Text("sensitivity.csv"), HasSubstr("\n,miss_m,start.r_m,numbers,60,"));
  EXPECT_THAT(Text("sensitivity_levels.csv"), HasSubstr("\n,toy.speed_m_s,fast,,,"));
  EXPECT_THAT(Text("plots/sensitivity.svg"), HasSubstr(">toy.speed_m_s<"));
}

TEST_F(Toy, IsComparedWithAKeptBaseline) {
  const std::string here = (dir_ / "here").string(), there = (dir_ / "there").string();
  const auto campaign = [&](const std::string& file, const std::string& out) {
    return Dockyard("campaign " + kToy + file + " --quiet --out " + out).code;
  };
  ASSERT_EQ(campaign("arms.yaml", there), 0);
  ASSERT_EQ(campaign("arms.yaml --set design.runs=12", here), 0);
  const std::string compare = "compare " + here + " --baseline " + there;
  const auto same = Dockyard(compare + " --fail-if-worse 0.05");
  EXPECT_EQ(same.code, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("20 pairs, 20 of them the same bit for bit"));
  EXPECT_THAT(same.out, HasSubstr("4 runs are not in the baseline"));
  EXPECT_THAT(same.err, HasSubstr("not shown to be worse"));
  EXPECT_THAT(Dockyard("compare " + here + " slow --baseline " + there).out, HasSubstr("10 pairs"));
  const auto json = Dockyard(compare + " --json");
  EXPECT_THAT(json.out, HasSubstr("\"same_bits\": 20"));
  ASSERT_EQ(campaign("sweep.yaml", (dir_ / "other").string()), 0);
  EXPECT_EQ(Dockyard("compare " + here + " --baseline " + (dir_ / "other").string()).code, 2);
  EXPECT_EQ(Dockyard("compare " + here).code, 2);
  EXPECT_EQ(Dockyard(compare + " slow fast").code, 2);
}

TEST_F(Toy, FailsWhereItIsWorse) {
  const auto worse = Dockyard("compare --only-a 0 --only-b 5 --fail-if-worse 0.05");
  EXPECT_EQ(worse.code, 23);
  EXPECT_THAT(worse.err, HasSubstr("A is worse than B: p = 0.03125"));
  EXPECT_EQ(Dockyard("compare --only-a 0 --only-b 4 --fail-if-worse 0.05").code, 0);
  EXPECT_EQ(Dockyard("compare --only-a 5 --only-b 0 --fail-if-worse 0.05").code, 0);
  EXPECT_EQ(Dockyard("compare --only-a 0 --only-b 5 --fail-if-worse 2").code, 2);
}

// The published rows of Hanson and Beard's table and of Fagerland et al. (2013) by the program.
TEST_F(Toy, BareCountsAreJudgedToo) {
  const std::string at = " --reliability 0.99 --confidence 0.95 --json";
  const auto accepted = Dockyard("accept --trials 628 --failures 2" + at);
  EXPECT_EQ(accepted.code, 0);
  EXPECT_THAT(accepted.out, HasSubstr("\"further_runs\": 0"));
  const auto undecided = Dockyard("accept --trials 627 --failures 2" + at);
  EXPECT_EQ(undecided.code, 21);
  EXPECT_THAT(undecided.out, HasSubstr("\"further_runs\": 1"));
  EXPECT_EQ(Dockyard("accept --trials 100 --failures 10" + at).code, 20);
  EXPECT_EQ(Dockyard("accept --trials 1 --failures 2" + at).code, 2);
  EXPECT_EQ(Dockyard("accept --trials 1" + at).code, 2);
  EXPECT_EQ(Dockyard("accept --trials 1 --failures 0 --reliability 1.5").code, 2);
  const auto compared = Dockyard("compare --only-a 1 --only-b 7");
  EXPECT_THAT(compared.out, HasSubstr("p = 0.0703 exact, 0.0391 mid-p"));
  EXPECT_EQ(Dockyard("compare --only-a 1").code, 2);
}

TEST_F(Toy, BringsACommandOfItsOwn) {
  EXPECT_EQ(Dockyard("way 7").out, "the flag is 7 m away\n");
  EXPECT_THAT(Dockyard("--help").out, HasSubstr("Say how far the flag is."));
}

TEST_F(Toy, RefusesTheKeysOfAnotherSystem) {
  const auto run = Dockyard("run " + kToy + "scenario.yaml --set system=axel");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("toy"));
}

}  // namespace
}  // namespace dockyard
