#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "bad_files.h"
#include "models/load_scenario.h"
#include "models/random.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

const char kGrid[] = "scenarios/mars_yard_40.yaml";

/// Message for the grid with one place of its table changed.
std::string TableMessage(const std::string& from, const std::string& to) {
  const ScratchFolder folder;
  for (const char* model : {"axel", "station", "soils"}) folder.CopyModel(model);
  folder.Write("scenarios/axel_typical.yaml", Slurp(SourceFile("scenarios/axel_typical.yaml")));
  folder.Write("scenarios/mars_yard_40.csv",
               Replaced(Slurp(SourceFile("scenarios/mars_yard_40.csv")), from, to));
  const std::string file = folder.Write(kGrid, Slurp(SourceFile(kGrid)));
  return MessageOf([&] { LoadCampaign(file); }, folder);
}

int Count(const Campaign& campaign, bool (*what)(const CampaignRun&)) {
  return static_cast<int>(std::count_if(campaign.runs.begin(), campaign.runs.end(), what));
}

TEST(MarsYardGrid, KeepsEveryCountThatIsPublished) {
  const Campaign grid = LoadCampaign(SourceFile(kGrid));
  EXPECT_EQ(grid.runs.size(), 40u);
  EXPECT_EQ(Count(grid, [](const CampaignRun& r) { return r.soil == "loose"; }), 20);
  EXPECT_EQ(Count(grid, [](const CampaignRun& r) { return r.region == "boundary"; }), 16);
  EXPECT_EQ(
      Count(grid, [](const CampaignRun& r) { return r.scenario.light == Light::kHardShadow; }), 15);
  EXPECT_EQ(Count(grid, [](const CampaignRun& r) { return r.day == 3; }), 15);
  for (const CampaignRun& run : grid.runs) {
    EXPECT_LE(run.scenario.start.r_m, 7.0);
    EXPECT_LE(std::abs(run.scenario.start.alpha_rad), Radians(40.0));
    EXPECT_LE(std::abs(run.scenario.start.heading_rad), Radians(25.0));
  }
}

TEST(MarsYardGrid, GivesEachRunASeedOfItsOwn) {
  const Campaign grid = LoadCampaign(SourceFile(kGrid));
  std::set<std::uint64_t> seeds;
  for (const CampaignRun& run : grid.runs) {
    EXPECT_EQ(run.scenario.seed, RunSeed(1, static_cast<std::uint64_t>(run.run)));
    seeds.insert(run.scenario.seed);
  }
  EXPECT_EQ(seeds.size(), 40u);
}

TEST(MarsYardGrid, TakesTheSoilFileByItsName) {
  const Campaign grid = LoadCampaign(SourceFile(kGrid));
  EXPECT_THAT(grid.runs[3].scenario.soil_file, HasSubstr("loose_sand.yaml"));
  EXPECT_THAT(grid.runs[0].scenario.soil_file, HasSubstr("compact_gravel.yaml"));
}

TEST(SmokeCampaign, HasRunsOfTheGrid) {
  const Campaign grid = LoadCampaign(SourceFile(kGrid));
  const Campaign smoke = LoadCampaign(SourceFile("scenarios/ci_4.yaml"));
  ASSERT_EQ(smoke.runs.size(), 4u);
  for (const CampaignRun& run : smoke.runs) {
    const CampaignRun& same = grid.runs[static_cast<std::size_t>(run.run - 1)];
    EXPECT_EQ(run.scenario.start.r_m, same.scenario.start.r_m);
    EXPECT_EQ(run.scenario.start.alpha_rad, same.scenario.start.alpha_rad);
    EXPECT_EQ(run.scenario.start.heading_rad, same.scenario.start.heading_rad);
    EXPECT_EQ(run.soil, same.soil);
    EXPECT_EQ(run.region, same.region);
    EXPECT_EQ(run.scenario.light, same.scenario.light);
    EXPECT_EQ(run.scenario.image_width, 640);
  }
}

TEST(CampaignTable, BadCellIsToldByLineAndColumn) {
  EXPECT_EQ(TableMessage("2,1,interior,compact,even,2.5,", "2,1,interior,compact,even,far,"),
            "scenarios/mars_yard_40.csv:3:27: r_m: expected a number from 0.5 to 100, found 'far'");
  EXPECT_EQ(TableMessage("2,1,interior,compact,even,", "2,1,interior,mud,even,"),
            "scenarios/mars_yard_40.csv:3:14: soil: expected one of loose, compact, found 'mud'");
  EXPECT_EQ(TableMessage("\n5,1,interior", "\n5,,interior"),
            "scenarios/mars_yard_40.csv:6:3: day: expected a whole number from 0 to 10000, found "
            "nothing");
  EXPECT_EQ(TableMessage("\n5,1,interior", "\n4,1,interior"),
            "scenarios/mars_yard_40.csv:6:1: run: expected a number that no other run has, found "
            "'4'");
}

TEST(CampaignTable, RowOfAnotherLengthIsRefused) {
  EXPECT_EQ(TableMessage("even,2.5,-30,-10", "even,2.5,-30"),
            "scenarios/mars_yard_40.csv:3:31: expected 8 cells as in the header, found 7");
}

TEST(CampaignTable, UnknownColumnNamesTheNearest) {
  EXPECT_EQ(TableMessage("heading_deg", "headings_deg"),
            "scenarios/mars_yard_40.csv:1:41: headings_deg: unknown key, did you mean "
            "'heading_deg'?");
}

TEST(Campaign, SetReachesEveryRun) {
  const Campaign grid = LoadCampaign(SourceFile(kGrid), {"scenario.camera.width_px=640", "seed=9"});
  EXPECT_EQ(grid.seed, 9u);
  for (const CampaignRun& run : grid.runs) EXPECT_EQ(run.scenario.image_width, 640);
}

TEST(Campaign, KeysThatEachRunBringsAreRefused) {
  const ScratchFolder folder;
  for (const std::string set : {"light=hard_shadow", "start.r_m=5", "seed=3", "soil=a.yaml"}) {
    EXPECT_THAT(MessageOf([&] { LoadCampaign(SourceFile(kGrid), {"scenario." + set}); }, folder),
                HasSubstr("expected only keys that all runs share"))
        << set;
  }
}

TEST(Campaign, NeedsExactlyOneTable) {
  const ScratchFolder folder;
  const auto message = [&](const std::string& set) {
    return MessageOf([&] { LoadCampaign(SourceFile(kGrid), {set}); }, folder);
  };
  EXPECT_THAT(message("runs=[]"),
              HasSubstr("expected one of the keys 'table' and 'runs', found both"));
  EXPECT_THAT(message("table="), HasSubstr("table: expected one line of text"));
}

TEST(Campaign, WithoutBaseOrScenarioIsRefused) {
  const ScratchFolder folder;
  const std::string file = folder.Write("c.yaml", "campaign: c\nsoils: {a: c.yaml}\nruns: []\n");
  EXPECT_EQ(MessageOf([&] { LoadCampaign(file); }, folder), "c.yaml:1:1: missing key 'scenario'");
}

}  // namespace
}  // namespace dockyard
