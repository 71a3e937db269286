#include "models/raposa/load_ground.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"
#include "models/read/load_model_yaml.h"
#include "support/loader_walk.h"

namespace dockyard::raposa {
namespace {

using testing::HasSubstr;

std::string NameOf(const std::string& ground) {
  return "models/raposa/grounds/" + ground + ".yaml";
}

FileValues ValuesOf(const GroundModel& g) {
  FileValues values{{"rolling_loss", g.belt.rolling_loss},
                    {"patch_scatter", g.belt.patch_scatter},
                    {"patch_m", g.belt.patch_m},
                    {"grain", g.grain}};
  if (!g.soil) {
    values.merge(FileValues{{"friction_angle_deg", Degrees(std::atan(g.belt.friction))},
                            {"lateral_ratio", g.belt.lateral_ratio},
                            {"cohesion_pa", g.belt.cohesion_pa},
                            {"shear_displacement_m", g.belt.shear_displacement_m}});
    return values;
  }
  const SoilModel& s = *g.soil;
  values.merge(FileValues{{"n", s.n},
                          {"slip_weakening", s.slip_weakening},
                          {"k_c", s.k_c},
                          {"k_phi", s.k_phi},
                          {"plates.narrowest_m", s.narrowest_plate_m},
                          {"plates.widest_m", s.widest_plate_m},
                          {"cohesion_pa", s.cohesion_pa},
                          {"friction_angle_deg", Degrees(s.friction_angle_rad)},
                          {"shear_modulus_m", s.shear_modulus_m},
                          {"density_kg_m3", s.density_kg_m3},
                          {"unloading_stiffness_pa_per_m", s.unloading_stiffness_pa_per_m},
                          {"damping_pa_s_per_m", s.damping_pa_s_per_m},
                          {"rgb[0]", s.rgb.x()},
                          {"rgb[1]", s.rgb.y()},
                          {"rgb[2]", s.rgb.z()}});
  return values;
}

class GroundFile : public testing::TestWithParam<const char*> {
 protected:
  std::string name() const { return NameOf(GetParam()); }
  std::string file() const { return SourceFile(name()); }
  LoadChanged load() const {
    return [file = file()](const ModelChanges& changes) { LoadGround(file, changes); };
  }
};

TEST_P(GroundFile, IsReadAsItIsWritten) {
  ExpectReadAsWritten(LoadModelYaml(file()), ValuesOf(LoadGround(file())));
}

TEST_P(GroundFile, BadNumbersAndUnknownKeysAreRefusedAtTheirPlace) {
  ExpectBadNumbersRefused(LoadModelYaml(file()), load());
  ExpectUnknownKeysRefused(LoadModelYaml(file()), load());
}

TEST_P(GroundFile, EachNumberIsNeeded) {
  const ScratchFolder folder;
  // Without k_phi the ground is a firm one, which has other keys.
  ExpectNumbersNeeded(LoadModelYaml(file()), {{"k_phi", "shear_displacement_m"}},
                      [&](const std::string& text) { LoadGround(folder.Write(name(), text)); });
}

INSTANTIATE_TEST_SUITE_P(All, GroundFile, testing::Values("grass", "hard_floor", "sand"));

TEST(GroundChanges, AMaterialThatHasNoSpectrumIsRefused) {
  EXPECT_THAT(ErrorWith("{material: snow}",
                        [](const ModelChanges& changes) {
                          LoadGround(SourceFile(NameOf("grass")), changes);
                        }),
              testing::AllOf(HasSubstr("changed.yaml:1:12: material"), HasSubstr("grass")));
}

TEST(GroundChanges, ToleranceGoesOnTopOfTheChangedNumber) {
  const YamlNode nominal = ParseYaml("{rolling_loss: 0.1}", "a.yaml"),
                 built = ParseYaml("{rolling_loss: {times: 2, plus: 0.01}}", "b.yaml");
  const GroundModel ground = LoadGround(SourceFile(NameOf("grass")), {&nominal, &built});
  EXPECT_NEAR(ground.belt.rolling_loss, 0.21, 1e-12);
}

}  // namespace
}  // namespace dockyard::raposa
