#include "models/read/load_mast.h"

#include "models/read/load_contact.h"
#include "models/read/load_motor.h"

namespace dockyard {
namespace {

constexpr const char* kJoints[kMastMotors] = {"roll", "shoulder", "elbow"};

void VisitInstrument(Keys& keys, InstrumentModel& instrument) {
  keys.Number("radius_m", instrument.radius_m, Positive(1.0));
  keys.Number("length_m", instrument.length_m, Positive(1.0));
  keys.Number("mass_kg", instrument.mass_kg, Positive(100.0));
  keys.Number("switch_radius_m", instrument.switch_radius_m,
              keys.Limits(Positive(instrument.radius_m), Positive(1.0)));
  keys.Number("switch_out_m", instrument.switch_out_m, NonNegative(0.05));
  keys.Number("closes_n", instrument.closes_n, Positive(100.0));
  keys.Number("switch_n_per_m", instrument.switch_n_per_m, Between(10.0, 1e6));
  keys.Number("rim_n_per_m", instrument.rim_n_per_m, Between(10.0, 1e6));
  keys.Number("mast_n_per_m", instrument.mast_n_per_m, Between(10.0, 1e4));
  keys.Number("mast_ns_per_m", instrument.mast_ns_per_m, NonNegative(100.0));
  keys.Number("friction", instrument.friction, NonNegative(3.0));
}

void VisitJoint(Keys& keys, std::size_t i, MastModel& mast) {
  const Range turn_deg = Between(-360.0, 360.0);
  keys.Degrees("low_deg", mast.low_rad[i], turn_deg);
  const double low_deg = Degrees(mast.low_rad[i]);
  keys.Degrees("high_deg", mast.high_rad[i], keys.Limits(Between(low_deg, 360.0), turn_deg));
  const Range between_deg = keys.Limits(Between(low_deg, Degrees(mast.high_rad[i])), turn_deg);
  keys.Degrees("stowed_deg", mast.stowed_rad[i], between_deg);
  keys.Degrees("watch_deg", mast.watch_rad[i], between_deg);
  keys.Mapping("motor", [&](Keys& in) { VisitMotor(in, mast.motors[i]); });
}

}  // namespace

void VisitMast(Keys& keys, MastModel& mast) {
  keys.Number("x_m", mast.p_RM.x(), Between(-10.0, 10.0));
  keys.Number(Optional("y_m"), mast.p_RM.y(), Between(-10.0, 10.0));
  keys.Number("z_m", mast.p_RM.z(), Between(-10.0, 10.0));
  keys.Number("link1_m", mast.link1_m, Positive(10.0));
  keys.Number("link2_m", mast.link2_m, Positive(10.0));
  keys.Number("housing_kg", mast.housing_kg, Positive(1e3));
  keys.Number("link1_kg", mast.link1_kg, Positive(1e3));
  keys.Number("link2_kg", mast.link2_kg, Positive(1e3));
  keys.Mapping("instrument", [&](Keys& in) { VisitInstrument(in, mast.instrument); });
  keys.Check("link2_m", mast.instrument.length_m < mast.link2_m, "more than instrument.length_m");
  keys.Mapping("stop", [&](Keys& in) { VisitStop(in, mast.stop); });
  for (std::size_t i = 0; i < kMastMotors; ++i) {
    keys.Mapping(kJoints[i], [&](Keys& in) { VisitJoint(in, i, mast); });
  }
}

}  // namespace dockyard
