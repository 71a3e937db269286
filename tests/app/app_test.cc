// The program as its users meet it: arguments, streams and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "app/program.h"
#include "support/fake_runs.h"
#include "support/program_path.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace fs = std::filesystem;

TEST(Program, OpensTheHelpOfEachCommandWithExamples) {
  for (const std::string command :
       {"", "run", "campaign", "replay", "report", "help", "schema", "completion", "view", "check",
        "wheel", "plan", "camera", "detect", "pose", "accept", "compare", "columns"}) {
    const Ended ended = Dockyard(command + " --help");
    EXPECT_EQ(ended.code, 0) << command;
    EXPECT_LT(ended.out.find("Examples:\n  " + ProgramPath() + " "), 120u) << ended.out;
    EXPECT_THAT(ended.out, HasSubstr("\n  " + ProgramPath() + " " + command));
    EXPECT_EQ(ended.err, "") << command;
  }
}

TEST(Program, PrintsThePageOfColumns) {
  EXPECT_EQ(Dockyard("columns").out, Slurp(SourceFile("docs/reference/columns.md")))
      << "renew it with: build/dockyard columns > docs/reference/columns.md";
}

TEST(Program, EndsWithTwoForArgumentsThatMakeNoSense) {
  for (const char* arguments : {"dock",
                                "run",
                                "run a b",
                                "run --sead 3 x.yaml",
                                "campaign x.yaml --jobs 0",
                                "campaign x.yaml --jobs many",
                                "replay",
                                "view scenarios/axel_typical.yaml",
                                "run scenarios/axel_typical.yaml --seed -1",
                                "run scenarios/axel_typical.yaml --set start",
                                "run scenarios/axel_typical.yaml --set =5",
                                "run scenarios/axel_typical.yaml --seed 18446744073709551616",
                                "view scenarios/axel_typical.yaml --seed -1 --out x",
                                "view scenarios/axel_typical.yaml --time 3 --out x",
                                "view scenarios/axel_typical.yaml --outside --size 1x1 --out x",
                                "view scenarios/axel_typical.yaml --outside --size 321x180 --out x",
                                "view scenarios/axel_typical.yaml --outside --from 1,2 --out x",
                                "view scenarios/axel_typical.yaml --at tip --out x",
                                "view scenarios/axel_typical.yaml --from 1,2,3 --out x",
                                "frames x"}) {
    const Ended ended = Dockyard(arguments);
    EXPECT_EQ(ended.code, 2) << arguments << "\n" << ended.err;
    EXPECT_EQ(ended.out, "") << arguments;
    EXPECT_THAT(ended.err, StartsWith("error: ")) << arguments;
  }
}

TEST(Program, SaysWhichWordIsNoSubcommand) {
  EXPECT_THAT(Dockyard("dock scenarios/axel_typical.yaml").err, HasSubstr("found 'dock'"));
}

TEST(Program, EndsWithThreeForABadInputFile) {
  const TemporaryFolder folder;
  const fs::path bad = folder.path() / "bad.yaml";
  WriteText(bad, "start: [\n");
  for (const std::string command : {"run ", "campaign ", "check "}) {
    for (const std::string& file : {bad.string(), std::string("/no/such/file.yaml")}) {
      const Ended ended = Dockyard(command + file);
      EXPECT_EQ(ended.code, 3) << command << file << "\n" << ended.err;
      EXPECT_THAT(ended.err, HasSubstr("error: " + file));
    }
  }
}

TEST(Program, NamesTheNearestKeyForAnUnknownOne) {
  const Ended ended = Dockyard("run scenarios/axel_typical.yaml --set start.rm=5");
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("start.r_m"));
}

TEST(Program, EndsWithFiftyForAFolderThatCannotBeWritten) {
  for (const char* arguments : {"run scenarios/axel_typical.yaml --out /proc/nothing/here",
                                "view scenarios/axel_typical.yaml --out /proc/nothing/here",
                                "campaign scenarios/ci_4.yaml --out /proc/nothing/here"}) {
    const Ended ended = Dockyard(arguments);
    EXPECT_EQ(ended.code, 50) << arguments << "\n" << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("/proc/nothing/here")) << arguments;
  }
}

TEST(Program, EndsWithFiftyWhenItsOutputCannotBeWritten) {
  EXPECT_EQ(Dockyard("check scenarios/axel_typical.yaml", "/dev/full").code, 50);
}

TEST(Program, ChecksAGoodFile) {
  const Ended ended = Dockyard("check scenarios/axel_typical.yaml scenarios/mars_yard_40.yaml");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("scenarios/axel_typical.yaml: scenario: "));
  EXPECT_THAT(ended.out, HasSubstr("scenarios/mars_yard_40.yaml: campaign: "));
}

TEST(Program, ChecksThatImagesOfAScenarioCanBeDrawn) {
  const TemporaryFolder folder;
  const fs::path wide = folder.path() / "wide.yaml";
  std::string text = Slurp(SourceFile("scenarios/axel_typical.yaml"));
  for (std::size_t at = 0; (at = text.find("../models", at)) != std::string::npos; at += 9) {
    text.replace(at, 9, SourceFile("models"));
  }
  WriteText(wide, text + "camera: {width_px: 1200, height_px: 1400}\n");
  const Ended ended = Dockyard("check " + wide.string());
  EXPECT_EQ(ended.code, 3) << ended.out;
  const auto line = 1 + std::count(text.begin(), text.end(), '\n');
  EXPECT_THAT(ended.err, HasSubstr("error: " + wide.string() + ":" + std::to_string(line) +
                                   ":20: camera: expected all pixels within 65 deg"));
}

TEST(Program, WritesNoColorsIntoAFile) {
  EXPECT_THAT(Dockyard("check /no/such/file.yaml").err, StartsWith("error: "));
}

TEST(Program, RefusesAFolderThatHoldsSomethingElse) {
  const TemporaryFolder folder;
  WriteText(folder.path() / "thesis.tex", "five years of work");
  for (const char* command : {"run scenarios/axel_typical.yaml", "campaign scenarios/ci_4.yaml"}) {
    const Ended ended = Dockyard(std::string(command) + " --out " + folder.path().string());
    EXPECT_EQ(ended.code, 2) << ended.err;
  }
  EXPECT_EQ(Slurp(folder.path() / "thesis.tex"), "five years of work");
}

TEST(Program, RefusesToReplayWhatIsNotThere) {
  const Ended ended = Dockyard("replay /no/such/folder 3");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("/no/such/folder"));
}

const std::string kWheel =
    "wheel --wheel models/wheels/pavlov_smooth.yaml --soil models/soils/pavlov_90.yaml ";

TEST(WheelCommand, GivesForcesTorqueSinkageAndSteps) {
  const Ended ended = Dockyard(kWheel + "--slip 0.75 --beta 0 --load 24 --json");
  EXPECT_EQ(ended.code, 0) << ended.err;
  for (const char* key : {"Fx_N", "Fy_N", "Fz_N", "torque_Nm", "sinkage_m", "steps"}) {
    EXPECT_THAT(ended.out, HasSubstr("\"" + std::string(key) + "\":"));
  }
}

TEST(WheelCommand, SweepsListsIntoATableAndPlots) {
  const TemporaryFolder folder;
  const Ended ended = Dockyard(kWheel + "--sweep --slip 0.75,0.9 --beta 0,15 --load 24 --out '" +
                               folder.path().string() + "'");
  EXPECT_EQ(ended.code, 0) << ended.err;
  const std::string table = Slurp(folder.path() / "sweep.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  EXPECT_EQ(ended.out, table);
  for (const char* plot : {"drawbar.svg", "sinkage.svg"}) {
    EXPECT_THAT(Slurp(folder.path() / plot), HasSubstr("15 deg, 24 N"));
  }
}

TEST(WheelCommand, DrawsMeasuredRowsOverTheCurvesOfTheirSideSlip) {
  const TemporaryFolder folder;
  const std::string data = (folder.path() / "data.csv").string();
  const std::string out = (folder.path() / "out").string();
  const std::string sweep = kWheel + "--sweep --slip 0.75,0.9 --load 24 --data '" + data + "'";
  const std::string head = "# a comment\nwheel,beta_deg,slip,Fx_N,Fz_N,sinkage_mm\n";
  const std::string rows = "smooth,0,0.75,0.82,24.0,25.4\nsmooth,15,0.75,0.84,23.7,25.5\n";
  WriteText(data, head + rows + "smooth,0,0.9,1.5,25.7,25.7\n");
  ASSERT_EQ(Dockyard(sweep + " --out '" + out + "'").code, 0);
  for (const char* plot : {"drawbar.svg", "sinkage.svg"}) {
    const std::string svg = Slurp(folder.path() / "out" / plot);
    int polygons = 0;
    for (std::size_t at = 0; (at = svg.find("<polygon", at)) != std::string::npos; ++at) ++polygons;
    EXPECT_EQ(polygons, 1 + 2) << plot;  // the frame; the row at 15 deg has no curve
  }
  EXPECT_EQ(Dockyard(sweep).code, 2);  // no --out
  WriteText(data, head + rows + "smooth,0,two,1,24,20\n");
  const Ended word = Dockyard(sweep + " --out '" + out + "'");
  EXPECT_EQ(word.code, 3);
  EXPECT_THAT(word.err, HasSubstr("data.csv:5:10: row 3.slip: expected"));
  WriteText(data, head + rows + "grouser,0,0.9,1,24,20\n");
  const Ended two = Dockyard(sweep + " --out '" + out + "'");
  EXPECT_EQ(two.code, 3);
  EXPECT_THAT(two.err, HasSubstr("--data-wheel, found smooth, grouser"));
  const Ended none = Dockyard(sweep + " --data-wheel round --out '" + out + "'");
  EXPECT_EQ(none.code, 3);
  EXPECT_THAT(none.err, HasSubstr("expected rows of 'round', found smooth, grouser"));
}

TEST(WheelCommand, RefusesWhatItCannotDrive) {
  const std::string soil = "models/soils/grc_1.yaml";
  EXPECT_EQ(Dockyard(kWheel).code, 2);
  EXPECT_EQ(Dockyard(kWheel + "--load 24 --slip 1.5").code, 2);
  EXPECT_EQ(Dockyard(kWheel + "--load 24 --slip 0.1,0.2").code, 2);
  EXPECT_EQ(Dockyard(kWheel + "--load -3").code, 2);
  const Ended no_number = Dockyard(kWheel + "--load 24 --slip nan");
  EXPECT_EQ(no_number.code, 2);
  EXPECT_THAT(no_number.err, HasSubstr("expected a number from -1 to 1, found 'nan'"));
  const Ended narrow =
      Dockyard("wheel --wheel models/wheels/pavlov_smooth.yaml --load 24 --soil " + soil);
  EXPECT_EQ(narrow.code, 3);
  EXPECT_THAT(narrow.err, HasSubstr(soil + ": k_c: expected k_c / width + k_phi > 0"));
  const Ended wrong = Dockyard("wheel --load 24 --soil " + soil + " --wheel " + soil);
  EXPECT_EQ(wrong.code, 3);
  EXPECT_THAT(wrong.err, HasSubstr("grc_1.yaml:7:1: n: unknown key"));
}

}  // namespace
}  // namespace dockyard
