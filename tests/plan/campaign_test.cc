#include <gmock/gmock.h>

#include <optional>
#include <set>

#include "plan/toy_campaign.h"
#include "sim/base/random.h"
#include "sim/plan/file_keys.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kCampaign = R"(campaign: c
seed: 9
base: toy.yaml
vary:
  soil: {loose: ../models/sand.yaml, hard: ../models/gravel.yaml}
tags: [day, region]
table: c.csv
)";
constexpr const char* kTable = R"(run,day,region,soil,light,start.r_m,toy.colour,changes.soil.k
1,1,interior,hard,even,2,red,0.5
4,2,edge,loose,hard_shadow,2.50,blue,1e3
)";

class CampaignFile : public testing::Test {
 protected:
  CampaignFile() { WriteTable(kTable); }
  void WriteTable(const std::string& text) const { folder_.Write("scenarios/c.csv", text); }
  Campaign Load(const std::string& text = kCampaign,
                const std::vector<std::string>& overrides = {}) const {
    return LoadAndCheck(folder_.Write("scenarios/c.yaml", text), overrides);
  }
  std::string Message(const std::string& from, const std::string& to) const {
    return MessageOf([&] { Load(Replaced(kCampaign, from, to)); }, folder_);
  }
  std::string TableMessage(const std::string& from, const std::string& to) const {
    WriteTable(Replaced(kTable, from, to));
    return MessageOf([&] { Load(); }, folder_);
  }
  std::string SetMessage(const std::string& set) const {
    return MessageOf([&] { Load(kCampaign, {set}); }, folder_);
  }
  void ExpectReadsBack(const Campaign& campaign) const {
    const ScratchFolder elsewhere;
    const std::string resolved = CampaignYaml(WithAbsolutePaths(campaign, ToySystems()));
    const Campaign again =
        LoadCampaign(elsewhere.Write("resolved.yaml", resolved), {}, ToyCampaigns());
    EXPECT_EQ(again.name, campaign.name);
    EXPECT_EQ(again.seed, campaign.seed);
    EXPECT_EQ(again.labels, campaign.labels);
    const std::vector<CampaignRun> runs = AllRuns(campaign), same = AllRuns(again);
    ASSERT_EQ(same.size(), runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
      EXPECT_EQ(same[i].run, runs[i].run);
      EXPECT_EQ(same[i].labels, runs[i].labels);
      EXPECT_EQ(same[i].scenario.seed, runs[i].scenario.seed);
      EXPECT_THAT(DifferingKeys(same[i].scenario, runs[i].scenario), ElementsAre());
    }
    EXPECT_EQ(CampaignYaml(WithAbsolutePaths(again, ToySystems())), resolved);
  }

  ToyFolder folder_;
};

TEST_F(CampaignFile, ColumnsSetKeysOfTheScenario) {
  const Campaign campaign = Load();
  const std::vector<CampaignRun> runs = AllRuns(campaign);
  ASSERT_EQ(runs.size(), 2u);
  const Scenario& run = runs[1].scenario;
  EXPECT_EQ(run.name, "c run 4");
  EXPECT_EQ(run.soil_file, (folder_.path() / "models/sand.yaml").string());
  EXPECT_EQ(run.light, Light::kHardShadow);
  EXPECT_EQ(run.start.on_plane().r, 2.5);
  EXPECT_EQ(run.start.on_plane().alpha, Radians(15.0));  // of the base
  EXPECT_EQ(run.of_system.Find("colour")->scalar, "blue");
  EXPECT_EQ(FindPath(run.changes, "soil.k")->scalar, "1e3");
}

// Every text either reads back to the same, or is refused before the first run.
TEST_F(CampaignFile, WithAnyTextReadsBackOrIsRefused) {
  int read_back = 0, refused = 0;
  const auto Try = [&](const std::string& campaign) {
    std::optional<Campaign> loaded;
    const std::string message = MessageOf([&] { loaded = Load(campaign); }, folder_);
    if (loaded) {
      ++read_back;
      ExpectReadsBack(*loaded);
    } else {
      ++refused;
      EXPECT_THAT(message, testing::StartsWith("scenarios/c.")) << campaign;
    }
  };
  for (const char* text : {"a\\x1b[32mb",
                           "a\\eb",
                           "a\\0b",
                           "a\\tb",
                           "a\\nb",
                           "a\\rb",
                           "a\\x7fb",
                           "a\\Nb",
                           "a\\Lb",
                           "a\\Pb",
                           "a\\u009bb",
                           "a\\uFEFFb",
                           "a\\_b",
                           "a\\u20acb",
                           "a\\\\b",
                           "a\\\"b",
                           "a: b, {c} #d",
                           " a ",
                           "null",
                           "~",
                           "1e3",
                           "-",
                           "a'b",
                           "\xC3\xA9",
                           "\xF0\x9F\x9A\x80"}) {
    const std::string quoted = "\"" + std::string(text) + "\"";
    Try("campaign: c\nbase: toy.yaml\ntags: [day]\nruns: [{run: 1, day: " + quoted + "}]\n");
    Try("campaign: c\nbase: toy.yaml\ntags: [" + quoted + "]\nruns: [{run: 1, " + quoted +
        ": x}]\n");
    Try("campaign: " + quoted + "\nbase: toy.yaml\n");
    Try("campaign: c\nbase: toy.yaml\narms: {" + quoted + ": {start.r_m: 2}}\n");
    Try("campaign: c\nbase: toy.yaml\nvary: {start.r_m: {" + quoted + ": 2, b: 3}}\n");
    Try("campaign: c\nbase: toy.yaml\nscenario: {controller: {command: [sh, " + quoted + "]}}\n");
  }
  EXPECT_GT(read_back, 50);
  EXPECT_GT(refused, 50);
}

TEST_F(CampaignFile, ThatNamesAControlCharacterIsRefusedAtItsPlace) {
  const auto message = [&](const std::string& day) {
    return MessageOf(
        [&] {
          Load("campaign: c\nbase: toy.yaml\ntags: [day]\nruns:\n  - {run: 1, day: " + day + "}\n");
        },
        folder_);
  };
  EXPECT_EQ(message("\"\\x1b[32m\""),
            "scenarios/c.yaml:5:19: expected text without control characters, found U+001B");
  EXPECT_EQ(
      message("\"a\\nb\""),
      "scenarios/c.yaml:5:19: day: expected one line without control characters, found U+000A");
}

TEST_F(CampaignFile, WhosePathsHoldControlCharactersIsRefused) {
  EXPECT_THAT(MessageOf([] { AbsolutePath("/tmp/a\x1b[31m/b.yaml"); }, folder_),
              HasSubstr("'/tmp/a?[31m/b.yaml': expected a path in UTF-8 without control "
                        "characters, found U+001B"));
  EXPECT_THAT(MessageOf([] { AbsolutePath("/tmp/caf\xE9.yaml"); }, folder_), HasSubstr("U+00E9"));
  EXPECT_EQ(AbsolutePath("/tmp/caf\xC3\xA9.yaml"), "/tmp/caf\xC3\xA9.yaml");
}

TEST_F(CampaignFile, LabelsAreTheCellsAsWritten) {
  const Campaign campaign = Load();
  EXPECT_THAT(campaign.labels, ElementsAre("day", "region", "soil", "light", "start.r_m",
                                           "toy.colour", "changes.soil.k"));
  EXPECT_THAT(AllRuns(campaign)[1].labels,
              ElementsAre("2", "edge", "loose", "hard_shadow", "2.50", "blue", "1e3"));
}

TEST_F(CampaignFile, GivesEachRunASeedOfItsOwn) {
  std::set<std::uint64_t> seeds;
  for (const CampaignRun& run : AllRuns(Load())) {
    EXPECT_EQ(run.scenario.seed, WorldSeed(9, static_cast<std::uint64_t>(run.run), 0));
    seeds.insert(run.scenario.seed.number);
  }
  EXPECT_EQ(seeds.size(), 2u);
}

TEST_F(CampaignFile, ResolvedReadsBackToTheSame) { ExpectReadsBack(Load()); }

TEST_F(CampaignFile, ResolvedReadsBackFromAListWithMappingsAndFiles) {
  const Campaign campaign = Load(
      "campaign: list\nbase: toy.yaml\nscenario: {yard: {cell_m: 0.03}}\n"
      "vary: {start: {near: {r_m: 2}, aside: {alpha_deg: 20}}}\nruns:\n"
      "  - {run: 3, start: near, soil: ../models/gravel.yaml, controller: straight,\n"
      "     toy: {flag: ../models/lens.yaml}, sun: {elevation_deg: 12.3}}\n"
      "  - {run: 2, start: aside, soil: ../models/sand.yaml, controller: {command: [a, b]},\n"
      "     toy: {colour: null}, sun: {}}\n");
  EXPECT_THAT(campaign.labels, ElementsAre("start", "soil", "toy", "sun"));
  const std::vector<CampaignRun> runs = AllRuns(campaign);
  EXPECT_EQ(runs[0].labels[1], "../models/gravel.yaml");
  EXPECT_EQ(runs[1].scenario.start.on_plane().r, 4.0);
  EXPECT_EQ(runs[1].scenario.controller, "command");
  ExpectReadsBack(campaign);
}

TEST_F(CampaignFile, BadCellIsToldByLineAndColumn) {
  EXPECT_EQ(TableMessage("hard,even,2,", "hard,even,far,"),
            "scenarios/c.csv:2:24: start.r_m: expected a number from 0.1 to 100, found 'far'");
  EXPECT_EQ(TableMessage("interior,hard", "interior,mud"),
            "scenarios/c.csv:2:14: soil: expected one of loose, hard, found 'mud'");
  EXPECT_EQ(TableMessage("\n4,2,edge", "\n4,,edge"),
            "scenarios/c.csv:3:3: day: expected a value, found nothing");
  EXPECT_EQ(TableMessage("\n4,2,edge", "\n1,2,edge"),
            "scenarios/c.csv:3:1: run: expected a number that no other run has, found '1'");
  EXPECT_EQ(TableMessage("even,2,red,0.5", "even,2,red"),
            "scenarios/c.csv:2:26: expected 8 cells as in the header, found 7");
}

TEST_F(CampaignFile, UnknownColumnsAreToldByPlace) {
  EXPECT_EQ(TableMessage("start.r_m", "start.rm"),
            "scenarios/c.csv:1:27: start.rm: unknown key, did you mean 'r_m'?");
  EXPECT_EQ(TableMessage(",light,", ",lihgt,"),
            "scenarios/c.csv:1:21: lihgt: expected a key of the scenario or one of the campaign's "
            "tags; did you mean 'light'?");
  EXPECT_EQ(TableMessage(",light,", ",crew,"),
            "scenarios/c.csv:1:21: crew: expected a key of the scenario or one of the campaign's "
            "tags");
}

TEST_F(CampaignFile, ColumnsInTheWrongCaseAreNamedByWhatTheyMean) {
  EXPECT_EQ(TableMessage("run,", "Run,"),
            "scenarios/c.csv:1:1: Run: unknown column, did you mean 'run'?");
  EXPECT_EQ(TableMessage(",light,", ",Light,"),
            "scenarios/c.csv:1:21: Light: expected a key of the scenario or one of the campaign's "
            "tags; did you mean 'light'?");
  EXPECT_THAT(TableMessage(",day,", ",Day,"),
              HasSubstr("tags: expected a column of the table, found 'day', did you mean 'Day'?"));
}

TEST_F(CampaignFile, FormerKeysAndColumnsSayWhereTheyAreNow) {
  EXPECT_EQ(Message("vary:\n  soil:", "soils:"),
            "scenarios/c.yaml:4:1: soils: expected vary: {soil: {NAME: FILE, ...}} instead");
  EXPECT_EQ(Message("vary:\n", "values:\n"), "scenarios/c.yaml:4:1: values: expected vary instead");
  for (const std::string key : {"r_m", "alpha_deg", "heading_deg"}) {
    EXPECT_EQ(TableMessage("start.r_m", key),
              "scenarios/c.csv:1:27: " + key + ": expected the key 'start." + key + "' instead");
  }
}

TEST_F(CampaignFile, ColumnsThatCannotBeAreRefused) {
  EXPECT_THAT(TableMessage(",light,", ",name,"), HasSubstr("seeds follow from the runs' numbers"));
  EXPECT_THAT(TableMessage(",light,", ",system,"), HasSubstr("all runs are of one system"));
  EXPECT_THAT(TableMessage(",light,", ",start,"),
              HasSubstr("start.r_m: expected a key that is not set by 'start' as well"));
}

TEST_F(CampaignFile, AFileAsItsScenarioIsRefusedAtItsPlace) {
  EXPECT_EQ(
      Message("base: toy.yaml", "scenario: toy.yaml"),
      "scenarios/c.yaml:3:11: scenario: expected a mapping of keys; a scenario's file is named "
      "by base");
}

TEST_F(CampaignFile, TagsAreColumnsAndNoKeys) {
  EXPECT_EQ(Message("[day, region]", "[day, weather]"),
            "scenarios/c.yaml:6:13: tags: expected a column of the table, found 'weather'");
  EXPECT_THAT(Message("[day, region]", "[day, region, light]"),
              HasSubstr("light: expected a tag that is no key of a scenario"));
  WriteTable("run,outcome\n1,x\n");
  EXPECT_THAT(MessageOf([&] { Load("campaign: c\nbase: toy.yaml\ntags: [outcome]\ntable: c.csv"); },
                        folder_),
              HasSubstr("outcome: expected a tag that is no column of every result"));
}

TEST_F(CampaignFile, ATagVariesNothing) {
  EXPECT_EQ(Message("  soil: {", "  day: {"),
            "scenarios/c.yaml:5:3: vary.day: expected none; it is a tag");
}

TEST_F(CampaignFile, SetReachesEveryRun) {
  const Campaign campaign = Load(kCampaign, {"scenario.time_limit_s=33", "seed=10"});
  EXPECT_EQ(campaign.seed, 10u);
  for (const CampaignRun& run : AllRuns(campaign)) EXPECT_EQ(run.scenario.time_limit_s, 33.0);
}

TEST_F(CampaignFile, KeysThatEachRunBringsAreRefused) {
  for (const std::string set : {"light=hard_shadow", "start.r_m=5", "seed=3", "soil=a.yaml",
                                "name=x", "toy.colour=red", "changes.soil.k=3"}) {
    EXPECT_THAT(SetMessage("scenario." + set), HasSubstr("expected only keys that all runs share"))
        << set;
  }
  EXPECT_EQ(SetMessage("scenario.start.alpha_deg=5"), "(no error)");
}

TEST_F(CampaignFile, HasOneTableAtMost) {
  EXPECT_THAT(SetMessage("runs=[]"),
              HasSubstr("expected one of the keys 'table' and 'runs', found both"));
  EXPECT_THAT(SetMessage("table="), HasSubstr("table: expected one line of text"));
  EXPECT_EQ(Message("table: c.csv", "runs: []"),
            "scenarios/c.yaml:7:7: expected 1 to 1000000 runs, found 0");
}

TEST_F(CampaignFile, RowsOfAListHaveTheSameColumns) {
  const std::string head = "campaign: c\nbase: toy.yaml\nruns:\n  - {run: 1, light: even}\n";
  const auto message = [&](const std::string& row) {
    return MessageOf([&] { Load(head + row); }, folder_);
  };
  EXPECT_EQ(message("  - {run: 2}\n"), "scenarios/c.yaml:5:5: runs[1]: missing key 'light'");
  EXPECT_THAT(message("  - {run: 2, light: even, soil: a}\n"), HasSubstr("runs[1].soil: unknown"));
}

TEST_F(CampaignFile, WithoutBaseOrScenarioIsRefused) {
  EXPECT_EQ(MessageOf([&] { Load("campaign: c\nruns: [{run: 1}]\n"); }, folder_),
            "scenarios/c.yaml:1:1: missing key 'scenario'");
}

TEST_F(CampaignFile, TableAloneIsCheckedAsFarAsItCanBe) {
  const std::string file = (folder_.path() / "scenarios/c.csv").string();
  const TableCheck check = CheckRunTable(file);
  EXPECT_EQ(check.runs, 2);
  EXPECT_THAT(check.checked, ElementsAre("light", "start.r_m"));
  EXPECT_THAT(check.left_to_campaign,
              ElementsAre("day", "region", "soil", "toy.colour", "changes.soil.k"));
  WriteTable("run,start.r_m\n1,2\n2,far\n");
  EXPECT_EQ(MessageOf([&] { CheckRunTable(file); }, folder_),
            "scenarios/c.csv:3:3: start.r_m: expected a number from 0.1 to 100, found 'far'");
  WriteTable("run,start.r_m\n1,near\n2,far\n");
  EXPECT_THAT(CheckRunTable(file).left_to_campaign, ElementsAre("start.r_m"));
  WriteTable("run,r_m\n1,2\n");
  EXPECT_THAT(MessageOf([&] { CheckRunTable(file); }, folder_), HasSubstr("'start.r_m'"));
}

}  // namespace
}  // namespace dockyard
