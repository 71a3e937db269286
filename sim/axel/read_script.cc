#include "sim/axel/read_script.h"

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {

std::vector<ScriptStep> ReadScript(const YamlNode& list) {
  if (list.kind != YamlNode::Kind::kSequence || list.items.empty()) {
    throw ConfigError(list.place.Text() + ": script: expected a list of steps, found " +
                      list.Found());
  }
  std::vector<ScriptStep> script;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader in(list.items[i], YamlReader::PathOf("script", i),
                        {"for_s", "speed_m_s", "turn_deg_s", "free_wheels", "reel_m_s", "tension_n",
                         "arm_deg", "arm_deg_s"});
    ScriptStep step;
    step.for_s = in.Number("for_s", Positive(1e4));
    step.speed_m_s = in.NumberOr("speed_m_s", 0.0, Between(-10.0, 10.0));
    step.turn_rad_s = in.DegreesOr("turn_deg_s", 0.0, Between(-360.0, 360.0));
    step.free_wheels = in.BoolOr("free_wheels", false);
    step.reel_m_s = in.NumberOr("reel_m_s", 0.0, Between(-10.0, 10.0));
    if (in.Has("tension_n")) step.tension_n = in.Number("tension_n", NonNegative(1e5));
    // A turn or two round the axle, and back.
    if (in.Has("arm_deg")) step.arm_rad = in.Degrees("arm_deg", Between(-1080.0, 1080.0));
    if (in.Has("arm_deg_s")) step.arm_speed_rad_s = in.Degrees("arm_deg_s", Positive(360.0));
    if (step.arm_speed_rad_s && !step.arm_rad) in.Refuse("arm_deg_s", "arm_deg beside it");
    script.push_back(step);
  }
  return script;
}

}  // namespace dockyard::axel
