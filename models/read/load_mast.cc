#include "models/read/load_mast.h"

#include "models/read/load_motor.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr const char* kJoints[kMastMotors] = {"roll", "shoulder", "elbow"};

InstrumentModel ReadInstrument(const YamlReader& mast) {
  const YamlReader in(
      mast.Child("instrument"), mast.PathOf("instrument"),
      {"radius_m", "length_m", "mass_kg", "switch_radius_m", "switch_out_m", "closes_n",
       "switch_n_per_m", "rim_n_per_m", "mast_n_per_m", "mast_ns_per_m", "friction"});
  InstrumentModel instrument;
  instrument.radius_m = in.Number("radius_m", Positive(1.0));
  instrument.length_m = in.Number("length_m", Positive(1.0));
  instrument.mass_kg = in.Number("mass_kg", Positive(100.0));
  instrument.switch_radius_m = in.Number("switch_radius_m", Positive(instrument.radius_m));
  instrument.switch_out_m = in.Number("switch_out_m", NonNegative(0.05));
  instrument.closes_n = in.Number("closes_n", Positive(100.0));
  instrument.switch_n_per_m = in.Number("switch_n_per_m", Between(10.0, 1e6));
  instrument.rim_n_per_m = in.Number("rim_n_per_m", Between(10.0, 1e6));
  instrument.mast_n_per_m = in.Number("mast_n_per_m", Between(10.0, 1e4));
  instrument.mast_ns_per_m = in.Number("mast_ns_per_m", NonNegative(100.0));
  instrument.friction = in.Number("friction", NonNegative(3.0));
  return instrument;
}

}  // namespace

MastModel ReadMast(const YamlNode& node, const std::string& path) {
  const YamlReader in(node, path,
                      {"x_m", "y_m", "z_m", "link1_m", "link2_m", "housing_kg", "link1_kg",
                       "link2_kg", "instrument", "roll", "shoulder", "elbow"});
  MastModel mast;
  mast.p_RM = {in.Number("x_m", Between(-10.0, 10.0)),
               in.NumberOr("y_m", 0.0, Between(-10.0, 10.0)),
               in.Number("z_m", Between(-10.0, 10.0))};
  mast.link1_m = in.Number("link1_m", Positive(10.0));
  mast.link2_m = in.Number("link2_m", Positive(10.0));
  mast.housing_kg = in.Number("housing_kg", Positive(1e3));
  mast.link1_kg = in.Number("link1_kg", Positive(1e3));
  mast.link2_kg = in.Number("link2_kg", Positive(1e3));
  mast.instrument = ReadInstrument(in);
  if (mast.instrument.length_m >= mast.link2_m) {
    in.Refuse("link2_m", "more than instrument.length_m");
  }
  for (std::size_t i = 0; i < kMastMotors; ++i) {
    const YamlReader joint(in.Child(kJoints[i]), in.PathOf(kJoints[i]),
                           {"low_deg", "high_deg", "stowed_deg", "watch_deg", "motor"});
    mast.low_rad[i] = joint.Degrees("low_deg", Between(-360.0, 360.0));
    const double low_deg = Degrees(mast.low_rad[i]);
    mast.high_rad[i] = joint.Degrees("high_deg", Between(low_deg, 360.0));
    const double high_deg = Degrees(mast.high_rad[i]);
    mast.stowed_rad[i] = joint.Degrees("stowed_deg", Between(low_deg, high_deg));
    mast.watch_rad[i] = joint.Degrees("watch_deg", Between(low_deg, high_deg));
    mast.motors[i] = ReadMotor(joint.Child("motor"), joint.PathOf("motor"));
  }
  return mast;
}

}  // namespace dockyard
