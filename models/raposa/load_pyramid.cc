#include "models/raposa/load_pyramid.h"

#include <utility>

#include "models/read/config_error.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/urdf.h"
#include "models/read/urdf_weld.h"
#include "models/read/yaml_reader.h"

namespace dockyard::raposa {
namespace {

void VisitMarks(Keys& keys, MarksModel& marks) {
  keys.Number("edge_m", marks.edge_m, Positive(1.0));
  keys.Number("behind_m", marks.behind_m, Positive(1.0));
  keys.Number("strip_m", marks.strip_m, Positive(0.5));
  keys.Degrees("rise_deg", marks.rise_rad, Between(0.0, 80.0));
  keys.Check("strip_m", marks.strip_m <= 0.5 * marks.edge_m, "at most half of edge_m");
}

void VisitGuide(Keys& keys, GuideModel& guide) {
  keys.Number("diameter_m", guide.diameter_m, Positive(0.5));
  keys.Number("length_m", guide.length_m, Positive(0.5));
  keys.Degrees("half_angle_deg", guide.half_angle_rad, Between(5.0, 80.0));
  keys.Number("height_m", guide.height_m, Positive(1.0));
  keys.Degrees("up_deg", guide.up_rad, Between(-30.0, 30.0));
  for (const auto& [key, radius_m] : {std::pair("rod_radius_m", &guide.rod_radius_m),
                                      std::pair("blunt_radius_m", &guide.blunt_radius_m)}) {
    keys.Number(key, *radius_m, Positive(0.1));
    keys.Check(key, *radius_m < 0.5 * guide.diameter_m, "less than half of diameter_m");
  }
}

void VisitFeet(Keys& keys, PyramidModel& pyramid) {
  keys.Items("soles_m", pyramid.p_P_soles, 3, 16, [](Keys& in, Eigen::Vector2d& sole) {
    in.Number("x", sole.x(), Between(-1.0, 1.0));
    in.Number("y", sole.y(), Between(-1.0, 1.0));
  });
  keys.Number("friction", pyramid.foot_friction, NonNegative(3.0));
  keys.Number("stiffness_n_per_m", pyramid.foot_stiffness_n_per_m, Between(100.0, 1e7));
  keys.Number("damping_ratio", pyramid.foot_damping_ratio, NonNegative(5.0));
  keys.Number("diameter_m", pyramid.foot_diameter_m, Between(0.003, 0.3));
}

void VisitCable(Keys& keys, TetherCableModel& cable) {
  keys.Number("length_m", cable.length_m, Between(0.3, 50.0));
  keys.Number("slack_m", cable.slack_m,
              keys.Limits(NonNegative(0.5 * cable.length_m), NonNegative(25.0)));
  keys.Number("mass_kg_per_m", cable.mass_kg_per_m, Between(1e-3, 5.0));
  keys.Number("diameter_m", cable.diameter_m, Positive(0.1));
  keys.Number("axial_stiffness_n", cable.axial_stiffness_n, Between(10.0, 1e6));
  keys.Number("damping_ns_per_m", cable.damping_ns_per_m, NonNegative(1e4));
  keys.Number("friction_on_ground", cable.friction_on_ground, NonNegative(2.0));
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

/// Keys of the file that the model has otherwise.
struct PyramidFile {
  std::string urdf;
  double mass_scale = 1.0;
};

void VisitPyramid(Keys& keys, PyramidModel& pyramid, PyramidFile& file) {
  keys.Text("name", pyramid.name);
  keys.Mapping("marks", [&](Keys& in) { VisitMarks(in, pyramid.marks); });
  keys.Mapping("guide", [&](Keys& in) { VisitGuide(in, pyramid.guide); });
  keys.Mapping("feet", [&](Keys& in) { VisitFeet(in, pyramid); });
  keys.Mapping("cable", [&](Keys& in) { VisitCable(in, pyramid.cable); });
  keys.File("urdf", file.urdf);
  keys.Number(Optional("mass_scale"), file.mass_scale, Between(0.1, 10.0));
  NameSpreads(keys);
}

}  // namespace

void VisitPyramidKeys(Keys& keys) {
  PyramidModel pyramid;
  PyramidFile file;
  VisitPyramid(keys, pyramid, file);
}

static PyramidModel ReadPyramidFile(const std::string& file, const ModelChanges& changes,
                                    MeshStore* meshes) {
  YamlNode tree = LoadModelYaml(file);
  if (changes.nominal != nullptr) MergeYaml(tree, *changes.nominal);
  PutIfLeftOut(tree, "mass_scale", 1.0);
  if (changes.built != nullptr) PutBuilt(tree, *changes.built);
  PyramidModel pyramid;
  PyramidFile keys;
  const auto visit = [&](Keys& all) { VisitPyramid(all, pyramid, keys); };
  ReadKeys(tree, "", visit);
  const UrdfModel urdf = WeldFixedLinks(LoadUrdf(keys.urdf, meshes));
  RequireJoints(urdf, {}, "'pyramid'");
  if (urdf.root != "pyramid") {
    throw ConfigError(urdf.PlaceOf(urdf.root) + ": expected the root link to be 'pyramid'");
  }
  pyramid.body = RequireInertial(urdf, "pyramid");
  pyramid.body.mass_kg *= keys.mass_scale;
  pyramid.body.I_LCom_L *= keys.mass_scale;
  CheckStands(YamlReader(tree, "", KeyNames(visit)), pyramid);
  CheckSpreads(tree);
  return pyramid;
}

PyramidModel LoadPyramid(const std::string& file, const ModelChanges& changes, MeshStore* meshes) {
  return AdvisingOtherKinds("target", [&] { return ReadPyramidFile(file, changes, meshes); });
}

}  // namespace dockyard::raposa
