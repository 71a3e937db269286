#include "sim/raposa/raposa_keys.h"

namespace dockyard::raposa {

void VisitRaposaKeys(Keys& keys, RaposaKeys& values) {
  keys.File({"pyramid", "", "the pyramid's file", Presence::kRequired}, values.pyramid_file);
  keys.Number({"light_k", "K",
               "colour temperature of the light: a filament's below 4000, daylight's above"},
              values.light_k, Between(2500.0, 10000.0));
  keys.Number({"fill_light_k", "K", "of the light from all sides, sky or room; else light_k",
               Presence::kUnset},
              values.fill_light_k, Between(2500.0, 10000.0));
  keys.Number({"light_level", "", "of sun, sky or room, against a lit room; the lamps keep theirs"},
              values.light_level, Between(0.0, 10.0));
  keys.Number({"balance_k", "K", "colour temperature that the camera is balanced for"},
              values.balance_k, Between(2500.0, 10000.0));
  keys.Bool({"auto_balance", "", "the camera balances by itself instead, with a lag"},
            values.auto_balance);
  keys.Degrees({"cable_deg", "deg",
                "from straight behind the pyramid to the cable's far end; else drawn within 40",
                Presence::kUnset},
               values.cable_rad, Between(-90.0, 90.0));
  keys.Degrees(
      {"off_guide_deg", "deg",
       "the camera's start heading off the guide, in place of start.heading_deg", Presence::kUnset},
      values.off_guide_rad, Between(-180.0, 180.0));
  keys.Number({"behind_m", "m", "of the ground behind the pyramid"}, values.behind_m,
              Between(1.5, 50.0));
  keys.Integer({"clutter", "", "objects in colours like the marks', drawn by the seed"},
               values.clutter, 0, 100);
  keys.Bool({"hide_pyramid", "", "the pyramid is not drawn: for pictures of clutter alone"},
            values.hide_pyramid);
  keys.Tree({"bands", "", "of ferreira2009: orange and blue, as `dockyard tune` writes them",
             Presence::kUnset},
            values.bands, YamlNode::Kind::kMapping);
  keys.Tree({"band_changes", "", "the user's hand on them: at_s, orange and blue of each",
             Presence::kUnset},
            values.band_changes, YamlNode::Kind::kSequence);
  keys.Tree({"motion", "", "of ferreira2009: speeds, times and limits in place of its own",
             Presence::kUnset},
            values.motion, YamlNode::Kind::kMapping);
  keys.Tree(
      {"vision", "", "of ferreira2009: limits of its search for the marks, in place of its own",
       Presence::kUnset},
      values.vision, YamlNode::Kind::kMapping);
}

RaposaKeys ReadRaposaKeys(const Scenario& scenario) {
  RaposaKeys values;
  ReadKeys(scenario.of_system, "raposa", [&](Keys& keys) { VisitRaposaKeys(keys, values); });
  return values;
}

}  // namespace dockyard::raposa
