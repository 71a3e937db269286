#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "bad_files.h"
#include "models/load_scenario.h"

namespace dockyard {
namespace {

std::string Absolute(const std::string& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

bool SameOrBothNaN(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void ExpectSame(const Scenario& a, const Scenario& b) {
  // Does not compile once a Scenario has another field: compare it below, and add its key to
  // HoldsEveryKeyThatAScenarioMaySet.
  [[maybe_unused]] const auto& [name, rover, station, soil, controller, vision, start, light, sun,
                                board_dust, yard, camera, width, height, colour, time_limit, step,
                                tip_angle, changes, seed, X_WG, log_images] = a;
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(Absolute(a.rover_file), Absolute(b.rover_file));
  EXPECT_EQ(Absolute(a.station_file), Absolute(b.station_file));
  EXPECT_EQ(Absolute(a.soil_file), Absolute(b.soil_file));
  EXPECT_EQ(a.controller, b.controller);
  EXPECT_EQ(a.vision, b.vision);
  EXPECT_TRUE(SameOrBothNaN(a.sun.azimuth_rad, b.sun.azimuth_rad));
  EXPECT_TRUE(SameOrBothNaN(a.sun.elevation_rad, b.sun.elevation_rad));
  EXPECT_EQ(a.sun.temperature_k, b.sun.temperature_k);
  EXPECT_EQ(a.sun.sky_temperature_k, b.sun.sky_temperature_k);
  EXPECT_EQ(a.board_dust, b.board_dust);
  EXPECT_EQ(a.colour, b.colour);
  EXPECT_EQ(FlowText(a.changes), FlowText(b.changes));
  EXPECT_EQ(a.start.r_m, b.start.r_m);
  EXPECT_EQ(a.start.alpha_rad, b.start.alpha_rad);
  EXPECT_EQ(a.start.heading_rad, b.start.heading_rad);
  EXPECT_EQ(a.light, b.light);
  EXPECT_EQ(a.yard.length_m, b.yard.length_m);
  EXPECT_EQ(a.yard.width_m, b.yard.width_m);
  EXPECT_EQ(a.yard.cell_m, b.yard.cell_m);
  EXPECT_EQ(a.yard.undulation_rms_m, b.yard.undulation_rms_m);
  EXPECT_EQ(a.yard.undulation_wavelength_m, b.yard.undulation_wavelength_m);
  EXPECT_EQ(a.camera_file.empty(), b.camera_file.empty());
  if (!a.camera_file.empty()) {
    EXPECT_EQ(Absolute(a.camera_file), Absolute(b.camera_file));
  }
  EXPECT_EQ(a.image_width, b.image_width);
  EXPECT_EQ(a.image_height, b.image_height);
  EXPECT_EQ(a.time_limit_s, b.time_limit_s);
  EXPECT_EQ(a.physics_step_s, b.physics_step_s);
  EXPECT_EQ(a.tip_angle_rad, b.tip_angle_rad);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.X_WG, b.X_WG);
  EXPECT_EQ(a.log_images, b.log_images);
}

TEST(ResolvedScenario, ReadsBackToTheSameValues) {
  const Scenario typical = LoadScenario(SourceFile("scenarios/axel_typical.yaml"));
  const ScratchFolder folder;
  ExpectSame(typical, LoadScenario(folder.Write("r.yaml", ResolvedYaml(typical))));
}

// Each key alone, at another value than its default.
TEST(ResolvedScenario, HoldsEveryKeyThatAScenarioMaySet) {
  const std::string file = SourceFile("scenarios/axel_typical.yaml");
  const std::string models = SourceFile("models/");
  const std::string typical = ResolvedYaml(LoadScenario(file));
  const ScratchFolder folder;
  const std::vector<std::string> keys{"name=other",
                                      "rover=" + folder.Write("other.yaml", "name: x\n"),
                                      "station=" + folder.Write("other.yaml", "name: x\n"),
                                      "soil=" + models + "soils/grc_1.yaml",
                                      "controller=reel_only",
                                      "vision.pipeline=tsai2013",
                                      "vision.min_points=5",
                                      "start.r_m=3",
                                      "start.alpha_deg=-7",
                                      "start.heading_deg=11",
                                      "light=speckled",
                                      "sun.azimuth_deg=0",
                                      "sun.elevation_deg=33",
                                      "sun.temperature_k=4300",
                                      "sun.sky_temperature_k=9100",
                                      "board_dust=0.2",
                                      "yard.length_m=13",
                                      "yard.width_m=11",
                                      "yard.cell_m=0.03",
                                      "yard.undulation_rms_m=0.004",
                                      "yard.undulation_wavelength_m=3.5",
                                      "camera.file=" + models + "cameras/axel_640.yaml",
                                      "camera={width_px: 800, height_px: 768}",
                                      "camera={width_px: 1024, height_px: 600}",
                                      "camera.colour=true",
                                      "time_limit_s=77",
                                      "physics_step_s=0.002",
                                      "tip_angle_deg=0",
                                      "seed=8",
                                      "site.x_m=2",
                                      "site.y_m=-3",
                                      "site.heading_deg=90",
                                      "log_images=false",
                                      "changes.rover.mass_scale=1.5"};
  for (const std::string& key : keys) {
    const Scenario changed = LoadScenario(file, {key});
    const std::string resolved = ResolvedYaml(changed);
    EXPECT_NE(resolved, typical) << key << " is not written";
    const Scenario again = LoadScenario(folder.Write("r.yaml", resolved));
    ExpectSame(changed, again);
    EXPECT_EQ(ResolvedYaml(again), resolved) << key;
  }
}

TEST(ResolvedScenario, ReadsBackOddValuesBitForBit) {
  for (const char* degrees :
       {"0.1", "-33.333333333333336", "1e-9", "7.2957795130823", "89.99999"}) {
    const Scenario odd = LoadScenario(
        SourceFile("scenarios/axel_typical.yaml"),
        {std::string("start.alpha_deg=") + degrees, "start.r_m=3.0000000000000004",
         std::string("start.heading_deg=-") + (degrees[0] == '-' ? degrees + 1 : degrees),
         "seed=18446744073709551615", "name='a \"b\" \\ : c'", "log_images=false",
         "tip_angle_deg=0.3", "site={x_m: -1000.1, y_m: 500, heading_deg: 179.9}",
         "controller=reel_only", "light=hard_shadow", "yard={cell_m: 0.0123, length_m: 11}"});
    const ScratchFolder folder;
    ExpectSame(odd, LoadScenario(folder.Write("r.yaml", ResolvedYaml(odd))));
  }
}

TEST(ResolvedCampaign, ReadsBackToTheSameRuns) {
  const Campaign grid = LoadCampaign(SourceFile("scenarios/mars_yard_40.yaml"),
                                     {"seed=12345", "scenario.tip_angle_deg=3"});
  const ScratchFolder folder;
  const Campaign again = LoadCampaign(folder.Write("resolved.yaml", grid.resolved_yaml));
  EXPECT_EQ(again.name, grid.name);
  EXPECT_EQ(again.seed, grid.seed);
  ASSERT_EQ(again.runs.size(), grid.runs.size());
  for (std::size_t i = 0; i < grid.runs.size(); ++i) {
    EXPECT_EQ(again.runs[i].run, grid.runs[i].run);
    EXPECT_EQ(again.runs[i].day, grid.runs[i].day);
    EXPECT_EQ(again.runs[i].region, grid.runs[i].region);
    EXPECT_EQ(again.runs[i].soil, grid.runs[i].soil);
    ExpectSame(again.runs[i].scenario, grid.runs[i].scenario);
  }
  EXPECT_EQ(again.resolved_yaml, grid.resolved_yaml);
}

}  // namespace
}  // namespace dockyard
