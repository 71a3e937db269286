// Written scenarios read back to the same, key by key.
#include <gmock/gmock.h>

#include <algorithm>

#include "scenario/toy_system.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;

/// A value other than the default for every key of a scenario.
const std::vector<std::pair<std::string, std::string>>& OtherValues() {
  static const std::vector<std::pair<std::string, std::string>> values{
      {"name", "'a \"b\" \\ : c'"},
      {"robot", "ROOT/models/lens.yaml"},
      {"soil", "ROOT/models/gravel.yaml"},
      {"camera.file", "ROOT/models/lens.yaml"},
      {"camera.width_px", "800"},
      {"camera.height_px", "600"},
      {"camera.colour", "true"},
      {"camera.stray.veil", "0.03"},
      {"camera.stray.core_deg", "0.7"},
      {"camera.stray.ghosts", "0.0003"},
      {"camera.delay_s", "0.35"},
      {"camera.lost", "0.2"},
      {"camera.clock_offset_s", "-0.02"},
      {"camera.clock_drift_ppm", "50"},
      {"camera.pupil_m", "0.001"},
      {"camera.window_m", "0.03"},
      {"camera.left.picture", "dark"},
      {"camera.left.cover", "0.5"},
      {"camera.left.cover_side_deg", "-33.333333333333336"},
      {"camera.left.dust", "0.1"},
      {"camera.left.dust_clump_m", "0.0005"},
      {"camera.left.dust_scatter", "0.4"},
      {"camera.right.picture", "none"},
      {"camera.right.cover", "0.25"},
      {"camera.right.cover_side_deg", "77.7"},
      {"camera.right.dust", "0.2"},
      {"camera.right.dust_clump_m", "0.0001"},
      {"camera.right.dust_scatter", "0.55"},
      {"controller", "straight"},
      {"start.r_m", "3.0000000000000004"},
      {"start.alpha_deg", "-33.333333333333336"},
      {"start.heading_deg", "7.2957795130823"},
      {"light", "hard_shadow"},
      {"sun.azimuth_deg", "0.1"},
      {"sun.elevation_deg", "89.99999"},
      {"sun.temperature_k", "4500"},
      {"sun.sky_temperature_k", "12000.5"},
      {"sun.opacity", "0.45"},
      {"sun.moving", "true"},
      {"sun.latitude_deg", "12.3"},
      {"sun.north_deg", "-33.333333333333336"},
      {"yard.length_m", "11"},
      {"yard.width_m", "10"},
      {"yard.cell_m", "0.0123"},
      {"yard.undulation_rms_m", "0"},
      {"yard.undulation_wavelength_m", "3"},
      {"yard.slope_deg", "7"},
      {"yard.slope_direction_deg", "-30"},
      {"yard.heights.file", "ROOT/models/lens.yaml"},
      {"yard.heights.cell_m", "0.5"},
      {"yard.heights.scale_m", "0.001"},
      {"yard.heights.x_m", "2.5"},
      {"yard.heights.y_m", "-1.25"},
      {"yard.heights.turn_deg", "-33.333333333333336"},
      {"yard.patches", "[{soil: ROOT/models/gravel.yaml, disc: {x_m: 1, y_m: 2, radius_m: 0.5}}]"},
      {"rocks.cover", "0.07"},
      {"rocks.least_m", "0.06"},
      {"rocks.largest_m", "0.4"},
      {"rocks.clear_m", "1.75"},
      {"rocks.flattest", "0.3"},
      {"rocks.steepest", "0.6"},
      {"rocks.buried", "0.25"},
      {"rocks.friction", "0.45"},
      {"rocks.given", "[{x_m: 2, y_m: 0.425, diameter_m: 0.2, height_m: 0.08, turn_deg: 30}]"},
      {"scenery", "[{kind: set, x_m: 3, y_m: -2, count: 5, radius_m: 4, colours: [blue, brick]}]"},
      {"time_limit_s", "12.5"},
      {"physics_step_s", "0.0005"},
      {"seed", "18446744073709551615"},
      {"site.x_m", "-1000.1"},
      {"site.y_m", "500"},
      {"site.heading_deg", "179.9"},
      {"log_images", "false"},
      {"log_image_gap_s", "1.5"},
      {"changes", "{soil: {k: 1e+3, name: 'x: \"y\"'}}"},
      {"as_built", "{soil: {k: {times: 0.9}}}"},
      {"script", "[{for_s: 1}, wait]"},
      {"toy", "{colour: blue}"},
  };
  return values;
}

class Resolved : public testing::Test {
 protected:
  Scenario Load(const std::vector<std::string>& overrides) const {
    return LoadScenario(folder_.scenario, overrides, ToySystems());
  }
  std::string Set(const std::string& key, std::string value) const {
    const std::size_t root = value.find("ROOT");
    if (root != std::string::npos) value.replace(root, 4, folder_.path().string());
    return key + "=" + value;
  }
  /// With every key that has a default at another value.
  Scenario Odd() const {
    std::vector<std::string> sets;
    for (const auto& [key, value] : OtherValues()) sets.push_back(Set(key, value));
    return Load(sets);
  }
  static Scenario Again(const Scenario& scenario) {
    const ScratchFolder elsewhere;
    return LoadScenario(elsewhere.Write("r.yaml", ResolvedYaml(scenario)), {}, ToySystems());
  }

  ToyFolder folder_;
};

TEST_F(Resolved, OtherValuesCoverEveryKeyOfAScenario) {
  std::vector<std::string> known, here;
  for (const KeyRow& row : ScenarioRows()) known.push_back(row.key);
  for (const auto& [key, value] : OtherValues()) here.push_back(key);
  here.insert(here.begin() + 1, "system");
  here.insert(here.begin() + 30, "controller.command");
  here.insert(here.begin() + 31, "controller.folder");
  here.insert(here.begin() + 32, "controller.files");
  here.insert(here.begin() + 33, "controller.seed");
  // Instead of the sun's angles: SunKeys.
  const auto yard = std::find(here.begin(), here.end(), "yard.length_m");
  here.insert(here.insert(yard, "sun.hour"), "sun.date");
  here.back() = "<system>";
  EXPECT_EQ(here, known);
}

TEST_F(Resolved, EveryKeyIsWrittenAndReadBack) {
  const Scenario odd = Odd();
  const YamlNode written = WriteScenario(odd);
  for (const auto& [key, value] : OtherValues()) {
    EXPECT_NE(FindPath(written, key), nullptr) << key;
  }
  EXPECT_THAT(DifferingKeys(odd, Again(odd)), ElementsAre());
}

TEST_F(Resolved, ReadsBackBitForBit) {
  const Scenario odd = Odd(), again = Again(odd);
  EXPECT_EQ(again.name, odd.name);
  EXPECT_EQ(again.seed, odd.seed);
  EXPECT_EQ(again.start.on_plane().r, odd.start.on_plane().r);
  EXPECT_EQ(again.start.on_plane().alpha, odd.start.on_plane().alpha);
  EXPECT_EQ(again.start.on_plane().h, odd.start.on_plane().h);
  EXPECT_EQ(again.X_WG, odd.X_WG);
  EXPECT_EQ(again.sun.azimuth_rad, odd.sun.azimuth_rad);
  EXPECT_EQ(FlowText(again.changes), FlowText(odd.changes));
  EXPECT_EQ(FlowText(again.as_built), FlowText(odd.as_built));
  EXPECT_EQ(FlowText(again.script), FlowText(odd.script));
  EXPECT_EQ(FlowText(again.of_system), FlowText(odd.of_system));
}

TEST_F(Resolved, WritesEveryDefaultOut) {
  const std::string text = ResolvedYaml(Load({}));
  for (const char* line :
       {"time_limit_s: 600\n", "physics_step_s: 0.001\n", "  cell_m: 0.02\n", "log_images: true\n",
        "controller: wave\n", "  colour: false\n", "  heading_deg: 0\n"}) {
    EXPECT_THAT(text, ::testing::HasSubstr(line));
  }
}

TEST_F(Resolved, KeepsAProgramAsController) {
  const Scenario s = Load({"controller={command: [python3, 'a b.py', \"-x\"]}"});
  EXPECT_THAT(Again(s).command, ElementsAre("python3", "a b.py", "-x"));
  EXPECT_EQ(Again(s).controller, "command");
  EXPECT_EQ(Again(s).command_folder, s.command_folder);
}

TEST_F(Resolved, HasNoFolderOfThisComputerForOthers) {
  const Scenario s = Load({"controller={command: [/usr/bin/python3, x.py]}"});
  const std::string folder = folder_.path().string();
  ASSERT_THAT(ResolvedYaml(s), ::testing::HasSubstr(folder));
  for (const std::string& dir : {std::string(), folder}) {
    const std::string text = YamlWithoutFolders(s, dir);
    EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr(folder)));
    EXPECT_THAT(text, ::testing::Not(::testing::HasSubstr("/usr/bin")));
    EXPECT_THAT(text, ::testing::HasSubstr("python3"));
  }
}

TEST_F(Resolved, EachKeyAloneIsTheOneThatDiffers) {
  // Keys that others need.
  const std::string size = "camera={width_px: 640, height_px: 480}",
                    heights = Set("yard.heights", "{file: ROOT/models/gravel.yaml}");
  const Scenario plain = Load({size, heights});
  for (const auto& [key, value] : OtherValues()) {
    const Scenario changed = Load({size, heights, Set(key, value)});
    const std::vector<std::string> differing = DifferingKeys(plain, changed);
    if (key == "changes") {
      EXPECT_THAT(differing, ElementsAre("changes.soil.k", "changes.soil.name"));
    } else if (key == "as_built") {
      EXPECT_THAT(differing, ElementsAre("as_built.soil.k.times"));
    } else if (key == "toy") {
      EXPECT_THAT(differing, ElementsAre("toy.colour"));
    } else {
      EXPECT_THAT(differing, ElementsAre(key));
    }
  }
}

}  // namespace
}  // namespace dockyard
