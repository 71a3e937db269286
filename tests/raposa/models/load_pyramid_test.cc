#include "models/raposa/load_pyramid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/read/load_model_yaml.h"
#include "support/loader_walk.h"

namespace dockyard::raposa {
namespace {

using testing::HasSubstr;

const char* const kName = "models/raposa/pyramid/pyramid.yaml";

std::string File() { return SourceFile(kName); }
void Load(const ModelChanges& changes) { LoadPyramid(File(), changes); }

FileValues ValuesOf(const PyramidModel& p) {
  FileValues values{{"marks.edge_m", p.marks.edge_m},
                    {"marks.behind_m", p.marks.behind_m},
                    {"marks.strip_m", p.marks.strip_m},
                    {"marks.rise_deg", Degrees(p.marks.rise_rad)},
                    {"guide.diameter_m", p.guide.diameter_m},
                    {"guide.length_m", p.guide.length_m},
                    {"guide.half_angle_deg", Degrees(p.guide.half_angle_rad)},
                    {"guide.height_m", p.guide.height_m},
                    {"guide.up_deg", Degrees(p.guide.up_rad)},
                    {"guide.rod_radius_m", p.guide.rod_radius_m},
                    {"guide.blunt_radius_m", p.guide.blunt_radius_m},
                    {"feet.friction", p.foot_friction},
                    {"feet.stiffness_n_per_m", p.foot_stiffness_n_per_m},
                    {"feet.diameter_m", p.foot_diameter_m},
                    {"cable.length_m", p.cable.length_m},
                    {"cable.slack_m", p.cable.slack_m},
                    {"cable.mass_kg_per_m", p.cable.mass_kg_per_m},
                    {"cable.diameter_m", p.cable.diameter_m},
                    {"cable.axial_stiffness_n", p.cable.axial_stiffness_n},
                    {"cable.damping_ns_per_m", p.cable.damping_ns_per_m},
                    {"feet.damping_ratio", p.foot_damping_ratio},
                    {"cable.friction_on_ground", p.cable.friction_on_ground}};
  for (std::size_t i = 0; i < p.p_P_soles.size(); ++i) {
    const std::string sole = "feet.soles_m[" + std::to_string(i) + "].";
    values[sole + "x"] = p.p_P_soles[i].x();
    values[sole + "y"] = p.p_P_soles[i].y();
  }
  return values;
}

TEST(PyramidFile, IsReadAsItIsWritten) {
  ExpectReadAsWritten(LoadModelYaml(File()), ValuesOf(LoadPyramid(File())));
}

TEST(PyramidFile, BadNumbersAndUnknownKeysAreRefusedAtTheirPlace) {
  ExpectBadNumbersRefused(LoadModelYaml(File()), Load);
  ExpectUnknownKeysRefused(LoadModelYaml(File()), Load);
}

TEST(PyramidFile, EachNumberIsNeeded) {
  const ScratchFolder folder;
  folder.CopyModel("raposa");
  ExpectNumbersNeeded(LoadModelYaml(File()), {},
                      [&](const std::string& text) { LoadPyramid(folder.Write(kName, text)); });
}

TEST(PyramidFile, NumbersThatDoNotAgreeAreRefused) {
  const auto error = [](const std::string& text) { return ErrorWith(text, Load); };
  EXPECT_THAT(error("{marks: {strip_m: 0.031}}"),
              HasSubstr("changed.yaml:1:19: marks.strip_m: expected at most half of edge_m"));
  EXPECT_THAT(error("{guide: {rod_radius_m: 0.015}}"), HasSubstr("less than half of diameter_m"));
  EXPECT_THAT(error("{guide: {blunt_radius_m: 0.015}}"), HasSubstr("less than half of diameter_m"));
  EXPECT_THAT(error("{cable: {length_m: 0.9}}"), HasSubstr("cable.slack_m"));
}

TEST(PyramidFile, FeetMustCarryItsCentreOfMass) {
  const auto error = [](const std::string& soles) {
    return ErrorWith("{feet: {soles_m: " + soles + "}}", Load);
  };
  EXPECT_THAT(error("[{x: 0.2, y: 0.04}, {x: 0.2, y: -0.04}, {x: 0.1, y: 0}]"),
              HasSubstr("soles on all sides of the centre of mass"));
  EXPECT_THAT(error("[{x: 0.2, y: 0.04}, {x: -0.2, y: -0.04}]"), HasSubstr("feet.soles_m"));
  EXPECT_THAT(error("[{x: 0.2}, {x: -0.2, y: 0.1}, {x: -0.2, y: -0.1}]"),
              testing::AllOf(HasSubstr("changed.yaml:1:"), HasSubstr("y")));
}

TEST(PyramidUrdf, ARootOfAnotherNameIsRefused) {
  const ScratchFolder folder;
  folder.CopyModel("raposa");
  const std::string urdf = "models/raposa/pyramid/pyramid.urdf";
  std::string text = Slurp(SourceFile(urdf));
  for (std::size_t at = text.find("\"pyramid\""); at != std::string::npos;
       at = text.find("\"pyramid\"")) {
    text.replace(at, 9, "\"cone\"");
  }
  folder.Write(urdf, text);
  EXPECT_THAT(MessageOf([&] { LoadPyramid((folder.path() / kName).string()); }, folder),
              testing::AllOf(HasSubstr("pyramid.urdf:"), HasSubstr("'pyramid'")));
}

TEST(PyramidModel, MassScaleScalesMassAndInertiaAlike) {
  const PyramidModel one = LoadPyramid(File());
  PyramidModel two;
  LoadWith("{mass_scale: 2}",
           [&](const ModelChanges& changes) { two = LoadPyramid(File(), changes); });
  EXPECT_NEAR(two.body.mass_kg, 2.0 * one.body.mass_kg, 1e-12);
  EXPECT_LT((two.body.I_LCom_L - 2.0 * one.body.I_LCom_L).norm(), 1e-15);
}

}  // namespace
}  // namespace dockyard::raposa
