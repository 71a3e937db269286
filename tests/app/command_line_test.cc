// Help, suggestions, completion, manual pages, and the same report of failures by all commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <sstream>

#include "app/program.h"
#include "sim/base/json.h"
#include "support/fake_runs.h"
#include "support/program_path.h"

namespace dockyard {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
namespace fs = std::filesystem;

std::vector<std::string> LinesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Help, OfTheProgramFitsOneScreen) {
  const Ended help = Dockyard("--help");
  EXPECT_EQ(help.code, 0);
  const std::vector<std::string> lines = LinesOf(help.out);
  EXPECT_LE(lines.size(), 40u);
  for (const std::string& line : lines) {
    const bool shows_call = line.find(ProgramPath()) != line.npos;
    EXPECT_TRUE(shows_call || line.size() <= 100u) << line;
  }
  for (const char* group : {"\nRun:\n", "\nResults:\n", "\nVision:\n", "\nTools:\n"}) {
    EXPECT_THAT(help.out, HasSubstr(group));
  }
  EXPECT_THAT(help.out,
              testing::ContainsRegex(
                  "\nOf the system raposa:\n  alpha .*\n  belt .*\n  socket .*\n  tune "));
  EXPECT_THAT(help.out, testing::ContainsRegex("\n  campaign +Simulate all runs "));
  EXPECT_EQ(Dockyard("help").out, help.out);
}

TEST(Help, IsShortWithoutACommand) {
  const Ended none = Dockyard("");
  EXPECT_EQ(none.code, 2);
  EXPECT_EQ(none.err, "");
  EXPECT_LE(LinesOf(none.out).size(), 10u);
  EXPECT_THAT(none.out, HasSubstr("  " + ProgramPath() + " help "));
}

TEST(Help, OfACommandIsThatOfItsOption) {
  for (const std::string command : {"run", "camera", "camera project", "alpha", "help"}) {
    const Ended help = Dockyard("help " + command);
    EXPECT_EQ(help.code, 0) << command << help.err;
    EXPECT_EQ(help.out, Dockyard(command + " --help").out) << command;
    EXPECT_THAT(help.out, HasSubstr("Usage: " + ProgramPath() + " " + command)) << command;
  }
  const Ended slip = Dockyard("help camera projct");
  EXPECT_EQ(slip.code, 2);
  EXPECT_THAT(slip.err, HasSubstr("found 'projct', did you mean 'project'?"));
}

TEST(Help, SaysWhatAnOptionTakesInWords) {
  const std::string accept = Dockyard("accept --help").out;
  EXPECT_THAT(accept, HasSubstr("--reliability NUMBER from 1e-09 to 1 REQUIRED"));
  EXPECT_THAT(accept, HasSubstr("--trials INTEGER from 0 to 2000000000"));
  EXPECT_THAT(Dockyard("report --help").out, HasSubstr("--format html|json|markdown|junit"));
  for (const std::string command : {"run", "campaign", "replay", "accept", "compare", "report"}) {
    const std::string help = Dockyard(command + " --help").out;
    EXPECT_THAT(help, Not(testing::ContainsRegex("FLOAT|UINT|INT:|TEXT:"))) << command;
  }
}

TEST(DidYouMean, NamesTheCommandTheOptionAndTheFile) {
  const std::vector<std::pair<std::string, std::string>> slips{
      {"runn scenarios/axel_typical.yaml", "found 'runn', did you mean 'run'?"},
      {"camp scenarios/ci_4.yaml", "did you mean 'campaign'?"},
      {"camera projct models/cameras/navcam.yaml", "found 'projct', did you mean 'project'?"},
      {"run scenarios/axel_typical.yaml --sed 7",
       "unknown option '--sed' of run, did you mean '--seed'?"},
      {"run --sed=7", "unknown option '--sed' of run, did you mean '--seed'?"},
      {"view scenarios/axel_typical.yaml --ou x",
       "unknown option '--ou' of view, did you mean '--out'?"},
      {"tune a.png --robt models/raposa/raposa.yaml",
       "unknown option '--robt', did you mean '--robot'?"},
      {"run scenarios/axel_typcal.yaml", "did you mean 'scenarios/axel_typical.yaml'?"},
      {"run axel_typical", "did you mean 'scenarios/axel_typical.yaml'?"},
      {"campaign scenarios/ci4.yaml", "did you mean 'scenarios/ci_4.yaml'?"},
      {"check models/axle/axel.yaml", "did you mean 'models/axel/axel.yaml'?"},
      {"run scenarios/axel_typical.yaml --set robot=models/axel/axl.yaml",
       "did you mean 'models/axel/axel.yaml'?"},
      {"reproduce axel2031", "did you mean 'axel2013'?"}};
  for (const auto& [arguments, end] : slips) {
    const Ended ended = Dockyard(arguments);
    EXPECT_TRUE(ended.code == 2 || ended.code == 3) << arguments;
    EXPECT_THAT(ended.err, EndsWith(end + "\n")) << arguments;
  }
}

TEST(DidYouMean, LeadsToTheHelpWhereNothingIsNear) {
  EXPECT_THAT(Dockyard("xyzzy").err, HasSubstr("; " + ProgramPath() + " help lists them"));
  EXPECT_THAT(Dockyard("run x.yaml --quux").err,
              HasSubstr("; " + ProgramPath() + " help run lists"));
}

TEST(Program, SaysWhichOfScenarioAndCampaignAFileIs) {
  const Ended campaign = Dockyard("campaign scenarios/axel_typical.yaml");
  EXPECT_EQ(campaign.code, 3);
  EXPECT_THAT(campaign.err,
              HasSubstr("expected a campaign, found one scenario; simulate it with: " +
                        ProgramPath() + " run scenarios/axel_typical.yaml"));
  const Ended run = Dockyard("run scenarios/ci_4.yaml");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, HasSubstr("found a campaign; simulate it with: " + ProgramPath() +
                                 " campaign scenarios/ci_4.yaml"));
}

TEST(Program, EndsAlikeForEveryCommandWhoseResultsAreMissing) {
  const TemporaryFolder folder;
  const std::string none = (folder.path() / "none").string(), empty = folder.path().string();
  for (const std::string command :
       {"replay ", "replay @ 1", "report ", "report --svg ", "frames @ --out x",
        "accept --reliability 0.9 ", "compare @ a b", "merge ", "campaign --watch "}) {
    for (const std::string& dir : {none, empty}) {
      std::string arguments = command;
      const std::size_t at = command.find('@');
      if (at == command.npos)
        arguments += "'" + dir + "'";
      else
        arguments.replace(at, 1, "'" + dir + "'");
      const Ended ended = Dockyard(arguments);
      EXPECT_EQ(ended.code, 2) << arguments << ended.err;
      EXPECT_THAT(ended.err, StartsWith("error: DIR: expected the results folder of a campaign"))
          << arguments;
      EXPECT_THAT(ended.err,
                  HasSubstr((dir == none ? "found no folder '" : "found no results in '") + dir))
          << arguments;
    }
  }
}

TEST(Program, TellsAFailureAsJsonWhereJsonWasAsked) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "bad.yaml").string();
  WriteText(file, "name: bad\nsystem: axle\n");
  const Ended bad = Dockyard("run " + file + " --json");
  EXPECT_EQ(bad.code, 3);
  const Json answer = Json::parse(bad.out);
  EXPECT_EQ(answer["error"]["file"], file);
  EXPECT_EQ(answer["error"]["line"], 2);
  EXPECT_EQ(answer["error"]["column"], 9);
  EXPECT_EQ(answer["error"]["exit_code"], 3);
  EXPECT_EQ("error: " + answer["error"]["text"].get<std::string>() + "\n", bad.err);
  EXPECT_EQ(answer["warnings"], Json::array());

  const Json missing = Json::parse(Dockyard("run nowhere/none.yaml --json").out);
  EXPECT_EQ(missing["error"]["file"], "nowhere/none.yaml");
  EXPECT_TRUE(missing["error"]["line"].is_null());
  const Json usage = Json::parse(Dockyard("accept --json").out);
  EXPECT_EQ(usage["error"]["exit_code"], 2);
  EXPECT_TRUE(usage["error"]["file"].is_null());
}

TEST(Json, OfEveryAnswerHasItsWarnings) {
  for (const char* arguments :
       {"accept --trials 10 --failures 0 --reliability 0.5", "compare --only-a 1 --only-b 2",
        "columns", "doctor", "reproduce",
        "alpha --c-px 20.2 --g-px 16.2 --h-m 0.06 --m-m 0.098 --f-px 377"}) {
    const Json answer = Json::parse(Dockyard(std::string(arguments) + " --json").out);
    EXPECT_EQ(answer["warnings"], Json::array()) << arguments;
  }
}

TEST(Report, IsAskedForWithTheSameWordsOfARunAndACampaign) {
  const Ended nowhere = Dockyard("run scenarios/axel_typical.yaml --report");
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("--report: expected a file .html, or --out DIR"));
  // FILE of a campaign need not be there, so the option takes the next word.
  const Ended taken = Dockyard("campaign --report scenarios/ci_4.yaml");
  EXPECT_EQ(taken.code, 2) << taken.err;
  EXPECT_THAT(taken.err, HasSubstr("expected a file .html, found 'scenarios/ci_4.yaml'"));
  EXPECT_EQ(Dockyard("campaign scenarios/ci_4.yaml --report --dry-run").code, 0);
}

/// What bash offers for the last of the words.
std::set<std::string> Completed(const std::string& script, const std::string& words) {
  const TemporaryFolder folder;
  const fs::path bash = folder.path() / "dockyard.bash", out = folder.path() / "out";
  WriteText(bash, script + "COMP_WORDS=(" + words +
                      ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_dockyard\n"
                      "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  EXPECT_EQ(std::system(("bash '" + bash.string() + "' >'" + out.string() + "'").c_str()), 0);
  std::set<std::string> offered;
  for (const std::string& line : LinesOf(Slurp(out))) {
    if (!line.empty()) offered.insert(line);
  }
  return offered;
}

TEST(Completion, OffersCommandsOptionsAndWordsInBash) {
  const std::string script = Dockyard("completion bash").out;
  using Words = std::set<std::string>;
  EXPECT_EQ(Completed(script, "dockyard ru"), Words{"run"});
  EXPECT_EQ(Completed(script, "build/dockyard rep"), (Words{"replay", "report", "reproduce"}));
  EXPECT_EQ(Completed(script, "dockyard run a.yaml --se"), (Words{"--seed", "--set"}));
  EXPECT_EQ(Completed(script, "dockyard camera proj"), Words{"project"});
  EXPECT_EQ(Completed(script, "dockyard alpha --f"), Words{"--f-px"});
  EXPECT_EQ(Completed(script, "dockyard tune a.png --p"), Words{"--pyramid"});
  EXPECT_EQ(Completed(script, "dockyard report out --format j"), (Words{"json", "junit"}));
  EXPECT_EQ(Completed(script, "dockyard help camp"), Words{"campaign"});
  EXPECT_EQ(Completed(script, "dockyard completion z"), Words{"zsh"});
  EXPECT_EQ(Completed(script, "dockyard run scen"), Words{});  // files, by bash itself
}

TEST(Completion, NamesEveryCommandForEachShell) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string script = Dockyard(std::string("completion ") + shell).out;
    for (const char* word : {"campaign", "reproduce", "alpha", "project"}) {
      EXPECT_THAT(script, HasSubstr(word)) << shell;
    }
    EXPECT_THAT(script, HasSubstr("until-accepted")) << shell;
    EXPECT_THAT(script, HasSubstr("g-px")) << shell;
  }
  EXPECT_EQ(Dockyard("completion tcsh").code, 2);
}

TEST(Man, HasAPageForEachCommandThatTroffTakes) {
  const TemporaryFolder folder;
  const std::string make = "DOCKYARD='" + ProgramPath() + "' '" + SourceFile("scripts/man") +
                           "' '" + folder.path().string() + "' >/dev/null";
  ASSERT_EQ(std::system(make.c_str()), 0);
  for (const char* name :
       {"dockyard", "dockyard-run", "dockyard-camera-project", "dockyard-alpha"}) {
    const fs::path page = folder.path() / (std::string(name) + ".1");
    const std::string text = Slurp(page);
    EXPECT_THAT(text, StartsWith(".TH ")) << name;
    for (const char* section : {"\n.SH NAME\n", "\n.SH SYNOPSIS\n", "\n.SH EXAMPLES\n"}) {
      EXPECT_THAT(text, HasSubstr(section)) << name;
    }
    EXPECT_THAT(text, Not(HasSubstr(ProgramPath()))) << name;
    const fs::path said = folder.path() / "said";
    // 127 where no groff is installed.
    const int status = std::system(
        ("groff -man -ww -z '" + page.string() + "' 2>'" + said.string() + "'").c_str());
    EXPECT_TRUE(status != 0 || Slurp(said).empty()) << name << Slurp(said);
  }
}

}  // namespace
}  // namespace dockyard
