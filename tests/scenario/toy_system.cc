#include "scenario/toy_system.h"

#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

constexpr const char* kScenario = R"(name: toy
system: toy
robot: ../models/point.yaml
soil: ../models/sand.yaml
controller: wave
start: {r_m: 4, alpha_deg: 15, heading_deg: 0}
light: even
seed: 1
toy: {flag: ../models/flag.yaml, colour: red}
)";

}  // namespace

std::vector<KnownSystem> ToySystems() {
  return {{"toy",
           {"straight", "wave"},
           {"flag"},
           {"robot.cameras.file"},
           {{"robot", "robot"}, {"flag", "toy.flag"}, {"soil", "soil"}},
           true,
           true},
          {"other", {"idle"}, {}, {}}};
}

ToyFolder::ToyFolder() : scenario_text(kScenario) {
  for (const char* model : {"point", "sand", "gravel", "flag", "lens"}) {
    Write(std::string("models/") + model + ".yaml", "name: " + std::string(model) + "\n");
  }
  scenario = Write("scenarios/toy.yaml", scenario_text);
}

std::string ToyFolder::With(const std::string& from, const std::string& to) const {
  return Write("scenarios/s.yaml", Replaced(scenario_text, from, to));
}

std::string ToyFolder::And(const std::string& lines) const {
  return Write("scenarios/s.yaml", scenario_text + lines + "\n");
}

std::string ToyFolder::ScenarioMessage(const std::string& file) const {
  return MessageOf([&] { LoadScenario(file, {}, ToySystems()); }, *this);
}

}  // namespace dockyard
