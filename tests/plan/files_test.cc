// The files of scenarios/, read as the program does.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "plan/toy_campaign.h"
#include "sim/base/random.h"
#include "sim/plan/file_keys.h"
#include "sim/plan/published.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<KnownSystem>& Known() {
  static const std::vector<KnownSystem> known{
      {.name = "axel",
       .controllers = {"dockyard", "tsai2013", "reel_only"},
       .file_keys = {"station"},
       .model_roots = {{"robot", "robot"}, {"station", "axel.station"}, {"soil", "soil"}}},
      {.name = "raposa",
       .controllers = {"ferreira2009", "dockyard"},
       .file_keys = {"pyramid"},
       .model_roots = {{"robot", "robot"}, {"pyramid", "raposa.pyramid"}, {"soil", "soil"}}},
      {.name = "rocky7",
       .controllers = {"dockyard", "nesnas2000"},
       .file_keys = {},
       .model_roots = {{"robot", "robot"}, {"soil", "soil"}},
       .spoiled_pictures = false,
       .rocks = true}};
  return known;
}
CampaignSystems Systems() {
  return {Known(), [](const std::string&) {
            return std::vector<std::string>{
                "success",           "tip_depth_m",        "station_shift_m",      "tension_peak_n",
                "rock_force_peak_n", "entry_force_peak_n", "entry_current_peak_a", "rightings",
                "sim_time_s",        "arm_up_peak_deg",    "spool_current_mean_a", "advance_m",
                "turned_deg"};
          }};
}
Campaign Load(const std::string& file) { return LoadCampaign(SourceFile(file), {}, Systems()); }
Campaign Grid() { return Load("scenarios/mars_yard_40.yaml"); }
std::vector<CampaignRun> Runs(const Campaign& campaign) { return AllRuns(campaign, Known()); }

std::string Label(const Campaign& campaign, const CampaignRun& run, const std::string& name) {
  const auto at = std::find(campaign.labels.begin(), campaign.labels.end(), name);
  return run.labels.at(static_cast<std::size_t>(at - campaign.labels.begin()));
}
int Count(const Campaign& campaign, const std::string& name, const std::string& value) {
  const std::vector<CampaignRun> runs = Runs(campaign);
  return static_cast<int>(std::count_if(runs.begin(), runs.end(), [&](const CampaignRun& run) {
    return Label(campaign, run, name) == value;
  }));
}

TEST(TypicalScenario, IsTheOneOfFigure10) {
  const Scenario s = LoadScenario(SourceFile("scenarios/axel_typical.yaml"), {}, Known());
  EXPECT_EQ(s.start.on_plane().r, 4.0);
  EXPECT_EQ(s.start.on_plane().alpha, Radians(15.0));
  EXPECT_EQ(s.start.on_plane().h, 0.0);
  EXPECT_EQ(s.controller, "dockyard");
  EXPECT_EQ(s.of_system.Find("station")->scalar,
            AbsolutePath(SourceFile("models/axel/station/station.yaml")));
}

TEST(MarsYardGrid, KeepsEveryCountThatIsPublished) {
  const Campaign grid = Grid();
  EXPECT_EQ(grid.run_count(), 40);
  EXPECT_THAT(grid.labels, ElementsAre("day", "region", "soil", "light", "start.r_m",
                                       "start.alpha_deg", "start.heading_deg"));
  EXPECT_EQ(Count(grid, "soil", "loose"), 20);
  EXPECT_EQ(Count(grid, "region", "boundary"), 16);
  EXPECT_EQ(Count(grid, "light", "hard_shadow"), 15);
  EXPECT_EQ(Count(grid, "day", "3"), 15);
  for (const CampaignRun& run : Runs(grid)) {
    EXPECT_LE(run.scenario.start.on_plane().r, 7.0);
    EXPECT_LE(std::abs(run.scenario.start.on_plane().alpha), Radians(40.0));
    EXPECT_LE(std::abs(run.scenario.start.on_plane().h), Radians(25.0));
  }
}

TEST(MarsYardGrid, GivesEachRunASeedOfItsOwn) {
  std::set<std::uint64_t> seeds;
  for (const CampaignRun& run : Runs(Grid())) {
    EXPECT_EQ(run.scenario.seed, WorldSeed(1, static_cast<std::uint64_t>(run.run), 0));
    EXPECT_EQ(run.scenario.name, "mars_yard_40 run " + std::to_string(run.run));
    seeds.insert(run.scenario.seed.number);
  }
  EXPECT_EQ(seeds.size(), 40u);
}

TEST(MarsYardGrid, TakesTheSoilFileByItsName) {
  const Campaign grid = Grid();
  EXPECT_THAT(Runs(grid)[3].scenario.soil_file, HasSubstr("loose_sand.yaml"));
  EXPECT_THAT(Runs(grid)[0].scenario.soil_file, HasSubstr("compact_gravel.yaml"));
}

TEST(MarsYardGrid, ResolvedReadsBackToTheSame) {
  const Campaign grid = Grid();
  const ScratchFolder folder;
  const std::string resolved = CampaignYaml(WithAbsolutePaths(grid, Known()));
  const Campaign again = LoadCampaign(folder.Write("r.yaml", resolved), {}, Systems());
  EXPECT_EQ(CampaignYaml(WithAbsolutePaths(again, Known())), resolved);
}

TEST(SmokeCampaign, HasRunsOfTheGrid) {
  const Campaign grid = Grid();
  const Campaign smoke = Load("scenarios/ci_4.yaml");
  const std::vector<CampaignRun> runs = Runs(grid);
  ASSERT_EQ(smoke.run_count(), 4);
  EXPECT_EQ(smoke.labels, grid.labels);
  for (const CampaignRun& run : Runs(smoke)) {
    const CampaignRun& same = runs[static_cast<std::size_t>(run.run - 1)];
    EXPECT_EQ(run.labels, same.labels);
    EXPECT_EQ(run.scenario.start.on_plane().r, same.scenario.start.on_plane().r);
    EXPECT_EQ(run.scenario.start.on_plane().alpha, same.scenario.start.on_plane().alpha);
    EXPECT_EQ(run.scenario.start.on_plane().h, same.scenario.start.on_plane().h);
    EXPECT_EQ(run.scenario.light, same.scenario.light);
    EXPECT_EQ(run.scenario.image_width, 640);
  }
}

// Tsai et al., V-B and V-D: what they count is what the table has.
TEST(Axel2013, HasTheRunsOfEachPublishedRow) {
  const Published published = LoadPublished(SourceFile("scenarios/axel2013_published.yaml"));
  const Campaign grid = LoadCampaign(published.campaigns.at(0).file, {}, Systems());
  const std::vector<CampaignRun> runs = Runs(grid);
  int failures = 0;
  for (const PublishedRow& row : published.rows) {
    const auto count = std::count_if(runs.begin(), runs.end(), [&](const CampaignRun& run) {
      return std::all_of(row.where.begin(), row.where.end(), [&](const LabelFilter& filter) {
        const std::string text = Label(grid, run, filter.label.text);
        return std::find(filter.texts.begin(), filter.texts.end(), text) != filter.texts.end();
      });
    });
    EXPECT_EQ(count, row.paper ? row.paper->runs : 20) << row.name;  // half on each soil
    if (row.paper) failures += row.paper->runs - row.paper->count;
  }
  EXPECT_EQ(failures, 3 * 11);  // all, by the workspace, by the light
  EXPECT_EQ(published.judged.size(), 4u);
  int of_a_cause = 0;
  for (const FailureClass& failure : published.failures) {
    EXPECT_EQ(failure.judged, failure.paper.has_value()) << failure.name;
    if (failure.paper) of_a_cause += failure.paper->count;
  }
  EXPECT_EQ(of_a_cause, 5 + 2 + 1);  // V-D, V-F; the other 3 of the 11 have no count
  EXPECT_EQ(Runs(grid).front().scenario.seed, Runs(Grid()).front().scenario.seed);
}

/// Points of each study, as its factors multiply.
const std::vector<std::pair<std::string, std::int64_t>> kStudies{
    {"assisted.yaml", 2 * 2 * 10},
    {"axel2013_sweep.yaml", 40 * (1 + 57)},
    {"cone_height.yaml", 2 * 2 * 11},
    {"mating_holds.yaml", 2 * 5 * 5},
    {"mating_map.yaml", 2 * 9 * 6},
    {"raposa_any_start.yaml", 2},
    {"raposa_built.yaml", 2 * 4},
    {"raposa_calibrated.yaml", 5 * (1 + 12)},
    {"raposa_sand.yaml", 1},
    {"raposa_unpublished.yaml", 2 * (1 + 23)},
    {"reel_alpha.yaml", 2 * 3 * 15},
    {"reel_heading.yaml", 2 * 2 * 9},
    {"rock_map.yaml", 2 * 2},
    {"rocks.yaml", 4 * 2},
    {"rocky7_unpublished.yaml", 1 + 25},
    {"sensitivity.yaml", 8 * (1 + 48)},
    {"sensitivity_compact.yaml", 4 * (1 + 20)},
    {"sensitivity_loose.yaml", 4 * (1 + 20)},
    {"slack_arc.yaml", 6 * 3 * 2},
    {"slope.yaml", 5 * 3 * 2},
    {"tether_arc.yaml", 4 * 2},
    {"turned_over.yaml", 2 * 2 * 4},
    {"weak_motors.yaml", 2},
};

TEST(Studies, OfTheTreeHaveTheirPoints) {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(SourceFile("scenarios/studies"))) {
    files.insert(entry.path().filename().string());
  }
  for (const auto& [file, points] : kStudies) {
    EXPECT_EQ(files.erase(file), 1u) << file;
    EXPECT_EQ(Load("scenarios/studies/" + file).point_count(), points) << file;
  }
  EXPECT_THAT(files, ElementsAre());
}

TEST(CampaignFiles, OfTheListsOfPatchesAndSceneryAreFoundAndMoved) {
  const std::string soil = AbsolutePath(SourceFile("models/soils/loose_sand.yaml")),
                    mesh = AbsolutePath(SourceFile("models/axel/meshes/wheel.obj"));
  Campaign campaign = Load("scenarios/ci_4.yaml");
  SetYaml(campaign.base,
          "yard={patches: [{soil: " + soil + ", disc: {x_m: 1, y_m: 0, radius_m: 1}}]}");
  SetYaml(campaign.base,
          "scenery=[{kind: set, x_m: 0, y_m: 0, count: 1, radius_m: 1}, {kind: mesh, file: " +
              mesh + ", x_m: 1, y_m: 1}]");
  campaign = WithAbsolutePaths(campaign, Known());
  std::vector<std::string> found;
  for (const NamedFile& file : FilesOf(campaign, Known()).files) found.push_back(file.path);
  EXPECT_THAT(found, ::testing::IsSupersetOf({soil, mesh}));
  const Campaign moved = WithMovedFiles(
      campaign, Known(), [](const std::string& path) { return "/copy" + path; }, false);
  EXPECT_EQ(FindPath(moved.base.Find("yard")->Find("patches")->items[0], "soil")->scalar,
            "/copy" + soil);
  EXPECT_EQ(FindPath(moved.base.Find("scenery")->items[1], "file")->scalar, "/copy" + mesh);
}

}  // namespace
}  // namespace dockyard
