#include "models/raposa/load_pyramid.h"

#include <algorithm>

#include "models/read/config_error.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/urdf.h"
#include "models/read/urdf_weld.h"
#include "models/read/yaml_reader.h"

namespace dockyard::raposa {
namespace {

void ReadMarks(const YamlReader& root, MarksModel& marks) {
  const YamlReader in(root.Child("marks"), "marks", {"edge_m", "behind_m", "strip_m", "rise_deg"});
  marks.edge_m = in.Number("edge_m", Positive(1.0));
  marks.behind_m = in.Number("behind_m", Positive(1.0));
  marks.strip_m = in.Number("strip_m", Positive(0.5));
  marks.rise_rad = in.Degrees("rise_deg", Between(0.0, 80.0));
  if (marks.strip_m > 0.5 * marks.edge_m) in.Refuse("strip_m", "at most half of edge_m");
}

void ReadGuide(const YamlReader& root, GuideModel& guide) {
  const YamlReader in(root.Child("guide"), "guide",
                      {"diameter_m", "length_m", "half_angle_deg", "height_m", "up_deg",
                       "rod_radius_m", "blunt_radius_m"});
  guide.diameter_m = in.Number("diameter_m", Positive(0.5));
  guide.length_m = in.Number("length_m", Positive(0.5));
  guide.half_angle_rad = in.Degrees("half_angle_deg", Between(5.0, 80.0));
  guide.height_m = in.Number("height_m", Positive(1.0));
  guide.up_rad = in.Degrees("up_deg", Between(-30.0, 30.0));
  guide.rod_radius_m = in.Number("rod_radius_m", Positive(0.1));
  if (guide.rod_radius_m >= 0.5 * guide.diameter_m) {
    in.Refuse("rod_radius_m", "less than half of diameter_m");
  }
  guide.blunt_radius_m = in.Number("blunt_radius_m", Positive(0.1));
  if (guide.blunt_radius_m >= 0.5 * guide.diameter_m) {
    in.Refuse("blunt_radius_m", "less than half of diameter_m");
  }
}

void ReadFeet(const YamlReader& root, PyramidModel& pyramid) {
  const YamlReader in(root.Child("feet"), "feet",
                      {"soles_m", "friction", "stiffness_n_per_m", "diameter_m"});
  const YamlNode& list = in.List("soles_m", 3, 16);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader sole(list.items[i], YamlReader::PathOf(in.PathOf("soles_m"), i), {"x", "y"});
    pyramid.p_P_soles.emplace_back(sole.Number("x", Between(-1.0, 1.0)),
                                   sole.Number("y", Between(-1.0, 1.0)));
  }
  pyramid.foot_friction = in.Number("friction", NonNegative(3.0));
  pyramid.foot_stiffness_n_per_m = in.Number("stiffness_n_per_m", Between(100.0, 1e7));
  pyramid.foot_diameter_m = in.Number("diameter_m", Between(0.003, 0.3));
}

void ReadCable(const YamlReader& root, TetherCableModel& cable) {
  const YamlReader in(root.Child("cable"), "cable",
                      {"length_m", "slack_m", "mass_kg_per_m", "diameter_m", "axial_stiffness_n",
                       "friction_on_ground"});
  cable.length_m = in.Number("length_m", Between(0.3, 50.0));
  cable.slack_m = in.Number("slack_m", NonNegative(0.5 * cable.length_m));
  cable.mass_kg_per_m = in.Number("mass_kg_per_m", Between(1e-3, 5.0));
  cable.diameter_m = in.Number("diameter_m", Positive(0.1));
  cable.axial_stiffness_n = in.Number("axial_stiffness_n", Between(10.0, 1e6));
  cable.friction_on_ground = in.Number("friction_on_ground", NonNegative(2.0));
}

/// It must stand by itself: the weight must fall between the soles.
void CheckStands(const YamlReader& in, const PyramidModel& pyramid) {
  Eigen::Vector2d low = pyramid.p_P_soles[0], high = low;
  for (const Eigen::Vector2d& p : pyramid.p_P_soles) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector2d com = pyramid.body.p_LoCom_L.head<2>();
  if ((com.array() > low.array()).all() && (com.array() < high.array()).all()) return;
  in.Refuse("feet", "soles on all sides of the centre of mass at x " + NumberText(com.x()) +
                        ", y " + NumberText(com.y()));
}

}  // namespace

static PyramidModel ReadPyramidFile(const std::string& file, const ModelChanges& changes,
                                    MeshStore* meshes) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.told != nullptr) MergeYaml(tree, *changes.told);
  PutIfLeftOut(tree, "mass_scale", 1.0);
  if (changes.built != nullptr) PutBuilt(tree, *changes.built);
  const YamlReader in(tree, "",
                      {"name", "urdf", "mass_scale", "marks", "guide", "feet", "cable", "spreads"});
  PyramidModel pyramid;
  pyramid.name = in.Text("name");
  ReadMarks(in, pyramid.marks);
  ReadGuide(in, pyramid.guide);
  ReadFeet(in, pyramid);
  ReadCable(in, pyramid.cable);
  const UrdfModel urdf = WeldFixedLinks(LoadUrdf(in.File("urdf"), meshes));
  RequireJoints(urdf, {}, "'pyramid'");
  if (urdf.root != "pyramid") {
    throw ConfigError(urdf.PlaceOf(urdf.root) + ": expected the root link to be 'pyramid'");
  }
  pyramid.body = RequireInertial(urdf, "pyramid");
  const double scale = in.Number("mass_scale", Between(0.1, 10.0));
  pyramid.body.mass_kg *= scale;
  pyramid.body.I_LCom_L *= scale;
  CheckStands(in, pyramid);
  CheckSpreads(tree);
  return pyramid;
}

PyramidModel LoadPyramid(const std::string& file, const ModelChanges& changes, MeshStore* meshes) {
  return AdvisingOtherKinds("target", [&] { return ReadPyramidFile(file, changes, meshes); });
}

}  // namespace dockyard::raposa
