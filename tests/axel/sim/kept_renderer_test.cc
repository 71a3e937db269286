// A renderer that serves many runs of one process: each run has the bits that it has alone.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "axel/sim/scenarios.h"
#include "sim/base/hash.h"
#include "support/source_tree.h"

namespace dockyard::axel {
namespace {

using Overrides = std::vector<std::string>;

/// They differ in image size, light, soil, board and lens: in all that a renderer could keep.
std::vector<Scenario> Scenarios() {
  const std::string cameras = SourceFile("models/cameras/");
  const std::string soils = SourceFile("models/soils/");
  std::vector<Scenario> scenarios;
  for (Overrides overrides :
       {Overrides{"start.r_m=2.5", "light=hard_shadow"},
        Overrides{"start.r_m=3", "camera.width_px=640", "camera.height_px=480", "seed=5",
                  "soil=" + soils + "loose_sand.yaml"},
        Overrides{"start.r_m=1.9", "start.alpha_deg=0", "controller=reel_only"},  // blind
        Overrides{"start.r_m=2.5", "light=speckled", "axel.board_dust=0.3", "seed=2",
                  "changes.station.mouth_height_m=0.4"},
        Overrides{"start.r_m=2.5", "camera.file=" + cameras + "navcam.yaml",
                  "light=hard_shadow"}}) {
    overrides.push_back("time_limit_s=6");
    scenarios.push_back(TypicalScenario(overrides));
  }
  return scenarios;
}

/// Of the images at the start.
std::uint64_t ImageHash(const System& system, const Scenario& scenario) {
  std::uint64_t hash = kHashSeed;
  for (const CameraImage& image : system.make_ready(scenario).plant->TakeImages({0, 1}, 0.0)) {
    for (const std::uint8_t pixel : std::get<GrayImage>(image.pixels).pixels) {
      hash = HashByte(hash, pixel);
    }
  }
  return hash;
}

TEST(KeptRenderer, ARunAfterOthersHasTheBitsOfTheRunAlone) {
  const std::vector<Scenario> scenarios = Scenarios();
  std::vector<std::uint64_t> states, images;
  for (const Scenario& scenario : scenarios) {
    const System alone = Systems().front();
    states.push_back(Simulate(alone, RunOf(scenario), {}).result.state_hash);
    images.push_back(ImageHash(Systems().front(), scenario));
  }
  EXPECT_EQ(std::set(images.begin(), images.end()).size(), images.size());
  const System kept = Systems().front();
  for (const std::size_t i : {0, 1, 2, 0, 3, 4, 1, 0}) {
    EXPECT_EQ(Simulate(kept, RunOf(scenarios[i]), {}).result.state_hash, states[i]) << i;
    EXPECT_EQ(ImageHash(kept, scenarios[i]), images[i]) << i;
  }
}

}  // namespace
}  // namespace dockyard::axel
