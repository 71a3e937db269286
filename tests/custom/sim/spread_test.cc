// Tolerances of a dock's file as a campaign draws them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "custom/charger_rig.h"
#include "sim/plan/make_run.h"
#include "support/bad_files.h"

namespace dockyard::custom {
namespace {

/// What 40 runs build of the charger's dock, whose file ends with these spreads.
std::vector<DockModel> BuiltDocks(const std::string& spreads) {
  const ScratchFolder folder;
  std::string dock = Slurp(ChargerFile("dock/dock.yaml"));
  dock = Replaced(dock, "urdf: dock.urdf", "urdf: " + ChargerFile("dock/dock.urdf"));
  dock = Replaced(dock, "file: tag.yaml", "file: " + ChargerFile("dock/tag.yaml"));
  folder.Write("dock.yaml", dock + spreads);
  const std::string file = folder.Write(
      "campaign.yaml", "campaign: built\nbase: " + ChargerFile("scenario.yaml") +
                           "\nscenario: {dock: " + (folder.path() / "dock.yaml").string() +
                           "}\ndraw: {as_built: tolerance}\ndesign: {runs: 40}\n");
  const System system = CustomSystem({});
  KnownSystem known = system.scenario;
  known.name = system.name;
  known.controllers = {"graceful"};
  const Campaign campaign = LoadCampaign(file, {}, {{known}, {}});
  const std::vector<KnownSystem> systems{known};
  const RunMaker maker(campaign, systems);
  std::vector<DockModel> docks;
  for (std::int64_t i = 0; i < maker.run_count(); ++i) {
    docks.push_back(LoadModels(maker.Make(i).scenario).built.dock);
  }
  return docks;
}

TEST(CustomSpreads, DrawABoardsBowWithinItsTolerance) {
  double lowest_m = 0.0, highest_m = 0.0, widest_rad = 0.0;
  for (const DockModel& dock :
       BuiltDocks("  boards_as_built.flatness_m: {tolerance: {within: 0.002}}\n"
                  "  boards_as_built.bow_deg: {tolerance: {within: 90}}\n")) {
    lowest_m = std::min(lowest_m, dock.boards[0].flatness_m);
    highest_m = std::max(highest_m, dock.boards[0].flatness_m);
    widest_rad = std::max(widest_rad, std::abs(dock.boards[0].bow_rad));
  }
  // Of 40 uniform draws all are below 0.8 of a limit once in 68.
  EXPECT_LT(lowest_m, -0.0016);
  EXPECT_GE(lowest_m, -0.002);
  EXPECT_GT(highest_m, 0.0016);
  EXPECT_LE(highest_m, 0.002);
  EXPECT_GT(widest_rad, Radians(72.0));
  EXPECT_LE(widest_rad, Radians(90.0));
}

TEST(CustomSpreads, OfABowThatTheFileDoesNotStateLeaveItFlatAndAllElseAsItWas) {
  const std::vector<DockModel> flat = BuiltDocks("");
  const std::vector<DockModel> bent =
      BuiltDocks("  boards_as_built.flatness_m: {tolerance: {within: 0.002}}\n");
  for (std::size_t i = 0; i < flat.size(); ++i) {
    EXPECT_EQ(flat[i].boards[0].flatness_m, 0.0);
    EXPECT_NE(bent[i].boards[0].flatness_m, 0.0);
    EXPECT_EQ(flat[i].boards[0].X_LB.p, bent[i].boards[0].X_LB.p);
    EXPECT_EQ(flat[i].boards[0].X_LB.R, bent[i].boards[0].X_LB.R);
    EXPECT_EQ(flat[i].X_DD_built.y, bent[i].X_DD_built.y);
    EXPECT_EQ(flat[i].electrical.pins[0].p_L, bent[i].electrical.pins[0].p_L);
    EXPECT_EQ(flat[i].tree.mass_kg(), bent[i].tree.mass_kg());
  }
}

}  // namespace
}  // namespace dockyard::custom
