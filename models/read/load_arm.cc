#include "models/read/load_arm.h"

#include <algorithm>

#include "models/read/load_motor.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

ScoopModel ReadScoop(const YamlReader& arm) {
  const YamlReader in(arm.Child("scoops"), arm.PathOf("scoops"),
                      {"width_m", "depth_m", "belly_m", "wall_m", "opening_m", "mass_kg"});
  ScoopModel scoop;
  scoop.width_m = in.Number("width_m", Positive(1.0));
  scoop.depth_m = in.Number("depth_m", Positive(1.0));
  scoop.belly_m = in.Number("belly_m", Positive(1.0));
  scoop.wall_m = in.Number("wall_m", Positive(0.1));
  scoop.opening_m = in.Number("opening_m", Positive(2.0));
  scoop.mass_kg = in.Number("mass_kg", Positive(100.0));
  if (scoop.opening_m >= 2.0 * scoop.depth_m) {
    in.Refuse("opening_m", "less than twice depth_m");
  }
  const double least_m = std::min({scoop.width_m, scoop.depth_m, scoop.belly_m});
  if (scoop.wall_m > 0.2 * least_m) {
    in.Refuse("wall_m", "at most a fifth of width_m, depth_m and belly_m");
  }
  return scoop;
}

}  // namespace

ArmModel ReadArm(const YamlNode& node, const std::string& path) {
  const YamlReader in(node, path,
                      {"x_m", "y_m", "z_m", "length_m", "mass_kg", "roll_stop_deg", "pitch_low_deg",
                       "pitch_high_deg", "scoop_low_deg", "scoop_high_deg", "stowed_pitch_deg",
                       "stowed_scoop_deg", "scoops", "roll", "pitch", "scoop"});
  ArmModel arm;
  arm.p_RA = {in.Number("x_m", Between(-10.0, 10.0)), in.NumberOr("y_m", 0.0, Between(-10.0, 10.0)),
              in.Number("z_m", Between(-10.0, 10.0))};
  arm.length_m = in.Number("length_m", Positive(10.0));
  arm.mass_kg = in.Number("mass_kg", Positive(1e3));
  arm.roll_stop_rad = in.Degrees("roll_stop_deg", {0.0, 180.0, true});
  arm.pitch_low_rad = in.Degrees("pitch_low_deg", Between(-360.0, 0.0));
  arm.pitch_high_rad = in.Degrees("pitch_high_deg", Between(0.0, 360.0));
  arm.scoop_low_rad = in.Degrees("scoop_low_deg", Between(-360.0, 0.0));
  arm.scoop_high_rad = in.Degrees("scoop_high_deg", Between(0.0, 360.0));
  const auto Within = [&](const char* key, double low_rad, double high_rad) {
    return in.Degrees(key, Between(Degrees(low_rad), Degrees(high_rad)));
  };
  arm.stowed_pitch_rad = Within("stowed_pitch_deg", arm.pitch_low_rad, arm.pitch_high_rad);
  arm.stowed_scoop_rad = Within("stowed_scoop_deg", arm.scoop_low_rad, arm.scoop_high_rad);
  arm.scoop = ReadScoop(in);
  arm.roll = ReadMotor(in.Child("roll"), in.PathOf("roll"));
  arm.pitch = ReadMotor(in.Child("pitch"), in.PathOf("pitch"));
  arm.scoop_motor = ReadMotor(in.Child("scoop"), in.PathOf("scoop"));
  return arm;
}

}  // namespace dockyard
