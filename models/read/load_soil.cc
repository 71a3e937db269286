#include "models/read/load_soil.h"
#include "models/read/load_model_yaml.h"

#include "models/read/config_error.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

void ReadPlates(const YamlReader& in, SoilModel& soil) {
  const YamlReader plates(in.Child("plates"), in.PathOf("plates"), {"narrowest_m", "widest_m"});
  soil.narrowest_plate_m = plates.Number("narrowest_m", Between(0.005, 5.0));
  soil.widest_plate_m = plates.Number("widest_m", Between(soil.narrowest_plate_m, 5.0));
}

}  // namespace

SoilModel LoadSoil(const std::string& file, const ModelChanges& changes) {
  YamlNode root = LoadModelYaml(file);
  if (changes.told != nullptr) MergeYaml(root, *changes.told);
  if (changes.built != nullptr) PutBuilt(root, *changes.built);
  return AdvisingOtherKinds("ground", [&] {
    SoilModel soil = ReadSoil(YamlReader(root, "", SoilKeys()));
    CheckSpreads(root);
    return soil;
  });
}

std::vector<std::string> SoilKeys() {
  return {"name",
          "source",
          "n",
          "slip_weakening",
          "k_c",
          "k_phi",
          "plates",
          "cohesion_pa",
          "friction_angle_deg",
          "shear_modulus_m",
          "shear_depth_m",
          "density_kg_m3",
          "unloading_stiffness_pa_per_m",
          "damping_pa_s_per_m",
          "gravity_m_s2",
          "rgb",
          "spreads"};
}

SoilModel ReadSoil(const YamlReader& in) {
  SoilModel soil;
  soil.name = in.Text("name");
  soil.source = in.Text("source");
  soil.n = in.Number("n", Between(0.2, 2.5));
  soil.slip_weakening = in.Number("slip_weakening", Between(0.0, 1.0));
  soil.k_c = in.Number("k_c", Between(-1e6, 1e6));
  soil.k_phi = in.Number("k_phi", Positive(1e9));
  if (in.Has("plates")) ReadPlates(in, soil);
  soil.cohesion_pa = in.Number("cohesion_pa", NonNegative(1e5));
  soil.friction_angle_rad = in.Degrees("friction_angle_deg", Between(1.0, 60.0));
  soil.shear_modulus_m = in.Number("shear_modulus_m", Between(1e-4, 0.5));
  soil.shear_depth_m = in.NumberOr("shear_depth_m", soil.shear_depth_m, Between(1e-3, 1.0));
  soil.density_kg_m3 = in.Number("density_kg_m3", Between(200.0, 5000.0));
  soil.unloading_stiffness_pa_per_m = in.Number("unloading_stiffness_pa_per_m", Between(1e5, 1e9));
  soil.damping_pa_s_per_m = in.Number("damping_pa_s_per_m", NonNegative(1e8));
  soil.gravity_m_s2 = in.NumberOr("gravity_m_s2", soil.gravity_m_s2, Between(0.01, 50.0));
  soil.rgb = in.Rgb("rgb");
  return soil;
}

void CheckCarries(const SoilModel& soil, const std::string& file, double width_m) {
  if (soil.k_c / width_m + soil.k_phi > 0.0) return;
  throw ConfigError(file + ": k_c: expected k_c / width + k_phi > 0 at a width of " +
                    NumberText(width_m) + " m, found '" + NumberText(soil.k_c) + "'");
}

}  // namespace dockyard
