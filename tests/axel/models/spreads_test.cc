// The spreads of the model files: at both ends of each the model still loads.
#include "models/read/load_spreads.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

#include "models/axel/load_axel.h"
#include "models/axel/load_station.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_soil.h"
#include "models/read/yaml_reader.h"
#include "support/bad_files.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

using Load = std::function<void(const ModelChanges&)>;

YamlNode Keys(const std::string& assignment) {
  YamlNode tree;
  tree.kind = YamlNode::Kind::kMapping;
  SetYaml(tree, assignment);
  return tree;
}

std::vector<std::string> Values(const Limits& limits) {
  std::vector<std::string> values;
  for (const double value : limits.values) values.push_back("=" + NumberText(value));
  if (!values.empty()) return values;
  const std::string of = limits.of == Limits::Of::kTimes  ? ".times="
                         : limits.of == Limits::Of::kPlus ? ".plus="
                                                          : "=";
  return {of + NumberText(limits.low), of + NumberText(limits.high)};
}

/// How many spreads of each kind there are.
struct Count {
  int assumed = 0, tolerance = 0;
};

Count ExpectEndsLoad(const std::string& file, const Load& load) {
  Count count;
  for (const NumberSpread& spread : ReadSpreads(LoadModelYaml(SourceFile(file)))) {
    if (spread.assumed) {
      ++count.assumed;
      for (const std::string& value : Values(*spread.assumed)) {
        const YamlNode told = Keys(spread.key.name + value);
        EXPECT_NO_THROW(load({.nominal = &told})) << file << ": " << spread.key.name << value;
      }
    }
    if (spread.tolerance) {
      ++count.tolerance;
      for (const std::string& value : Values(*spread.tolerance)) {
        const YamlNode built = Keys(spread.key.name + value);
        EXPECT_NO_THROW(load({.built = &built})) << file << ": " << spread.key.name << value;
      }
    }
  }
  return count;
}

TEST(Spreads, AxelLoadsAtTheEndsOfEach) {
  const std::string file = "models/axel/axel.yaml";
  MeshStore meshes;
  const Count count = ExpectEndsLoad(
      file, [&](const ModelChanges& c) { LoadRover(SourceFile(file), 0, 0, c, &meshes); });
  EXPECT_GT(count.assumed, 50);
  EXPECT_GT(count.tolerance, 40);
}

// The filter of axel_field.yaml has no attitude errors of its own, so that their spreads go.
TEST(Spreads, AxelFieldLoadsAtTheEndsOfEachAndTakesAwayTwoOfItsBase) {
  const std::string file = "models/axel/axel_field.yaml";
  MeshStore meshes;
  const Count count = ExpectEndsLoad(
      file, [&](const ModelChanges& c) { LoadRover(SourceFile(file), 0, 0, c, &meshes); });
  EXPECT_GT(count.assumed, 70);
  std::vector<std::string> keys;
  for (const NumberSpread& spread : ReadSpreads(LoadModelYaml(SourceFile(file)))) {
    keys.push_back(spread.key.name);
  }
  EXPECT_THAT(keys, testing::Contains("imu.accel_bias_m_s2"));
  EXPECT_THAT(keys, testing::Contains("tether_sensor.tension_offset_n"));
  EXPECT_THAT(keys, testing::Not(testing::Contains("imu.attitude_noise_deg")));
  EXPECT_THAT(keys, testing::Not(testing::Contains("imu.attitude_bias_deg")));
}

TEST(Spreads, StationLoadsAtTheEndsOfEach) {
  const std::string file = "models/axel/station/station.yaml";
  MeshStore meshes;
  const Count count = ExpectEndsLoad(
      file, [&](const ModelChanges& c) { LoadStation(SourceFile(file), c, &meshes); });
  EXPECT_GT(count.assumed, 15);
  EXPECT_GT(count.tolerance, 15);
}

TEST(Spreads, SoilsLoadAtTheEndsOfEachAndShareTheirTolerances) {
  std::vector<std::string> first;
  for (const char* name : {"loose_sand", "compact_gravel", "fjs_1", "grc_1", "lete_sand",
                           "pavlov_90", "wong_dry_sand"}) {
    const std::string file = std::string("models/soils/") + name + ".yaml";
    ExpectEndsLoad(file, [&](const ModelChanges& c) { LoadSoil(SourceFile(file), c); });
    // Campaigns over several soils take a tolerance by its word only if the soils agree.
    std::vector<std::string> tolerances;
    for (const NumberSpread& spread : ReadSpreads(LoadYaml(SourceFile(file)))) {
      if (!spread.tolerance) continue;
      tolerances.push_back(spread.key.name + NumberText(spread.tolerance->low) + " to " +
                           NumberText(spread.tolerance->high));
    }
    std::sort(tolerances.begin(), tolerances.end());
    if (first.empty()) first = tolerances;
    EXPECT_EQ(tolerances, first) << name;
  }
}

TEST(Spreads, KeyMustBeANumberOfTheFile) {
  const auto message = [](const std::string& key) {
    const ScratchFolder folder;
    folder.CopyModel("axel");
    const std::string file = "models/axel/axel.yaml";
    const std::string text = Replaced(Slurp(SourceFile(file)), "spreads:\n",
                                      "spreads:\n  " + key + ": {tolerance: {percent: 1}}\n");
    const std::string bad = folder.Write(file, text);
    return MessageOf([&] { LoadRover(bad); }, folder);
  };
  EXPECT_THAT(message("wheels.radius"),
              HasSubstr(":3: spreads.wheels.radius: expected the dotted key of a number of this "
                        "file, found no such key"));
  EXPECT_THAT(message("wheels"), HasSubstr("found a mapping"));
  EXPECT_THAT(message("name"), HasSubstr("found 'axel'"));
  EXPECT_EQ(message("motors.left_wheel.counts_per_rev"), "(no error)");
  EXPECT_EQ(message("cameras.right_mounting.yaw_deg"), "(no error)");
}

}  // namespace
}  // namespace dockyard::axel
