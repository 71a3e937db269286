#include "models/read/load_soil.h"

#include "models/read/changed_yaml.h"
#include "models/read/config_error.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

void VisitPlates(Keys& keys, SoilModel& soil) {
  keys.Number("narrowest_m", soil.narrowest_plate_m, Between(0.005, 5.0));
  keys.Number("widest_m", soil.widest_plate_m,
              keys.Limits(Between(soil.narrowest_plate_m, 5.0), Between(0.005, 5.0)));
}

}  // namespace

SoilModel LoadSoil(const std::string& file, const ModelChanges& changes) {
  const YamlNode root = LoadChangedYaml(file, changes);
  return AdvisingOtherKinds("ground", [&] {
    SoilModel soil;
    ReadKeys(root, "", [&](Keys& keys) { VisitSoil(keys, soil); });
    CheckSpreads(root);
    return soil;
  });
}

void VisitSoil(Keys& keys, SoilModel& soil) {
  keys.Text("name", soil.name);
  keys.Text("source", soil.source);
  keys.Number("n", soil.n, Between(0.2, 2.5));
  keys.Number("slip_weakening", soil.slip_weakening, Between(0.0, 1.0));
  keys.Number("k_c", soil.k_c, Between(-1e6, 1e6));
  keys.Number("k_phi", soil.k_phi, Positive(1e9));
  keys.Mapping(Unset("plates"), [&](Keys& in) { VisitPlates(in, soil); });
  keys.Number("cohesion_pa", soil.cohesion_pa, NonNegative(1e5));
  keys.Degrees("friction_angle_deg", soil.friction_angle_rad, Between(1.0, 60.0));
  keys.Number("shear_modulus_m", soil.shear_modulus_m, Between(1e-4, 0.5));
  keys.Number(Optional("shear_depth_m"), soil.shear_depth_m, Between(1e-3, 1.0));
  keys.Number("density_kg_m3", soil.density_kg_m3, Between(200.0, 5000.0));
  keys.Number("unloading_stiffness_pa_per_m", soil.unloading_stiffness_pa_per_m, Between(1e5, 1e9));
  keys.Number("damping_pa_s_per_m", soil.damping_pa_s_per_m, NonNegative(1e8));
  keys.Number(Optional("gravity_m_s2"), soil.gravity_m_s2, Between(0.01, 50.0));
  keys.Rgb("rgb", soil.rgb);
  NameSpreads(keys);
}

void CheckCarries(const SoilModel& soil, const std::string& file, double width_m) {
  if (soil.k_c / width_m + soil.k_phi > 0.0) return;
  throw ConfigError(file + ": k_c: expected k_c / width + k_phi > 0 at a width of " +
                    NumberText(width_m) + " m, found '" + NumberText(soil.k_c) + "'");
}

}  // namespace dockyard
