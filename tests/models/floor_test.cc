#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/read/load_floor.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_tyre.h"
#include "support/loader_walk.h"

namespace dockyard {
namespace {

using testing::HasSubstr;

std::string NameOf(const std::string& floor) { return "models/floors/" + floor + ".yaml"; }

class FloorFile : public testing::TestWithParam<const char*> {
 protected:
  std::string name() const { return NameOf(GetParam()); }
  std::string file() const { return SourceFile(name()); }
  LoadChanged load() const {
    return [file = file()](const ModelChanges& changes) { LoadFloor(file, changes); };
  }
};

TEST_P(FloorFile, IsReadAsItIsWritten) {
  const FloorModel floor = LoadFloor(file());
  ExpectReadAsWritten(LoadModelYaml(file()), {{"friction", floor.friction},
                                              {"stiffness_n_per_m", floor.stiffness_n_per_m},
                                              {"damping_ns_per_m", floor.damping_ns_per_m},
                                              {"rolling_resistance_m", floor.rolling_resistance_m},
                                              {"grain", floor.grain}});
}

TEST_P(FloorFile, BadNumbersAndUnknownKeysAreRefusedAtTheirPlace) {
  ExpectBadNumbersRefused(LoadModelYaml(file()), load());
  ExpectUnknownKeysRefused(LoadModelYaml(file()), load());
}

TEST_P(FloorFile, EachNumberIsNeeded) {
  const ScratchFolder folder;
  ExpectNumbersNeeded(LoadModelYaml(file()), {},
                      [&](const std::string& text) { LoadFloor(folder.Write("a.yaml", text)); });
}

INSTANTIATE_TEST_SUITE_P(All, FloorFile, testing::Values("carpet", "hard_floor"));

TEST(FloorFiles, CarpetIsGreyAndYields) {
  const FloorModel carpet = LoadFloor(SourceFile(NameOf("carpet")));
  EXPECT_EQ(carpet.material, GroundMaterialKind::kGrey);
  EXPECT_GT(carpet.stiffness_n_per_m, 0.0);
}

TyreModel TyreOf(const std::string& text) {
  TyreModel tyre;
  ReadKeys(ParseYaml(text, "tyre.yaml"), "", [&](Keys& keys) { VisitTyre(keys, tyre); });
  return tyre;
}

std::string TyreError(const std::string& text) {
  try {
    TyreOf(text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return kNoError;
}

TEST(TyreKeys, LeftOutNumbersAreThoseOfSolidRubber) {
  const TyreModel tyre = TyreOf("{radius_m: 0.05, relaxation_m: 0.01, grip: 0.9}"), rubber;
  EXPECT_EQ(tyre.radius_m, 0.05);
  EXPECT_EQ(tyre.relaxation_m, 0.01);
  EXPECT_EQ(tyre.grip, 0.9);
  EXPECT_EQ(tyre.stiffness_n_per_m, rubber.stiffness_n_per_m);
  EXPECT_EQ(tyre.damping_ns_per_m, rubber.damping_ns_per_m);
  EXPECT_EQ(tyre.rolling_resistance_m, rubber.rolling_resistance_m);
}

TEST(TyreKeys, BadOnesAreRefusedAtTheirPlace) {
  EXPECT_THAT(TyreError("{radius_m: -1}"), HasSubstr("tyre.yaml:1:12: radius_m"));
  EXPECT_THAT(TyreError("{radius_m: 0.05, relaxation_m: 0}"), HasSubstr("1:32: relaxation_m"));
  EXPECT_THAT(TyreError("{radius_m: 0.05, ball: true, width_m: 0.02}"),
              HasSubstr("width_m: expected 0 of a ball"));
  EXPECT_THAT(TyreError("{radius_m: 0.05, stifness_n_per_m: 1}"), HasSubstr("stiffness_n_per_m"));
}

}  // namespace
}  // namespace dockyard
