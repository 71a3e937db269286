#include "models/read/load_arm.h"

#include <algorithm>

#include "models/read/load_contact.h"
#include "models/read/load_motor.h"

namespace dockyard {
namespace {

void VisitScoop(Keys& keys, ScoopModel& scoop) {
  keys.Number("width_m", scoop.width_m, Positive(1.0));
  keys.Number("depth_m", scoop.depth_m, Positive(1.0));
  keys.Number("belly_m", scoop.belly_m, Positive(1.0));
  keys.Number("wall_m", scoop.wall_m, Positive(0.1));
  keys.Number("opening_m", scoop.opening_m, Positive(2.0));
  keys.Number("mass_kg", scoop.mass_kg, Positive(100.0));
  keys.Choice(Optional("sides"), scoop.sides, {"closed", "open"});
  keys.Mapping("stop", [&](Keys& in) { VisitStop(in, scoop.stop); });
  keys.Check("opening_m", scoop.opening_m < 2.0 * scoop.depth_m, "less than twice depth_m");
  keys.Check("wall_m",
             scoop.wall_m <= 0.2 * std::min({scoop.width_m, scoop.depth_m, scoop.belly_m}),
             "at most a fifth of width_m, depth_m and belly_m");
}

}  // namespace

void VisitArm(Keys& keys, ArmModel& arm) {
  keys.Number("x_m", arm.p_RA.x(), Between(-10.0, 10.0));
  keys.Number(Optional("y_m"), arm.p_RA.y(), Between(-10.0, 10.0));
  keys.Number("z_m", arm.p_RA.z(), Between(-10.0, 10.0));
  keys.Number("length_m", arm.length_m, Positive(10.0));
  keys.Number("mass_kg", arm.mass_kg, Positive(1e3));
  const Range below_deg = Between(-360.0, 0.0), above_deg = Between(0.0, 360.0);
  keys.Degrees("roll_stop_deg", arm.roll_stop_rad, Positive(180.0));
  keys.Degrees("pitch_low_deg", arm.pitch_low_rad, below_deg);
  keys.Degrees("pitch_high_deg", arm.pitch_high_rad, above_deg);
  keys.Degrees("scoop_low_deg", arm.scoop_low_rad, below_deg);
  keys.Degrees("scoop_high_deg", arm.scoop_high_rad, above_deg);
  const auto stowed = [&](const char* key, double low_rad, double high_rad, double& value_rad) {
    keys.Degrees(key, value_rad,
                 keys.Limits(Between(Degrees(low_rad), Degrees(high_rad)), Between(-360.0, 360.0)));
  };
  stowed("stowed_pitch_deg", arm.pitch_low_rad, arm.pitch_high_rad, arm.stowed_pitch_rad);
  stowed("stowed_scoop_deg", arm.scoop_low_rad, arm.scoop_high_rad, arm.stowed_scoop_rad);
  keys.Mapping("stop", [&](Keys& in) { VisitStop(in, arm.stop); });
  keys.Mapping("scoops", [&](Keys& in) { VisitScoop(in, arm.scoop); });
  keys.Mapping("roll", [&](Keys& in) { VisitMotor(in, arm.roll); });
  keys.Mapping("pitch", [&](Keys& in) { VisitMotor(in, arm.pitch); });
  keys.Mapping("scoop", [&](Keys& in) { VisitMotor(in, arm.scoop_motor); });
}

}  // namespace dockyard
