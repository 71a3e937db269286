#include "sim/custom/custom_keys.h"

#include "sim/scenario/keys.h"

namespace dockyard::custom {
namespace {

void VisitGraceful(Keys& keys, DockingOptions& docking) {
  keys.Number({"k_phi", "", "gain on the bearing, of Park and Kuipers' law"}, docking.k_phi,
              Positive(20.0));
  keys.Number({"k_delta", "", "gain on the heading, of the same"}, docking.k_delta, Positive(20.0));
  keys.Number({"beta", "", "how curvature slows the robot"}, docking.beta, NonNegative(10.0));
  keys.Number({"lambda", "", "exponent of the same"}, docking.lambda, Between(1.0, 6.0));
  keys.Number({"slowdown_m", "m", "from the pose on which speed falls"}, docking.slowdown_m,
              Between(0.01, 5.0));
  keys.Number({"least_m_s", "m/s", "speed at the pose"}, docking.least_m_s, Between(0.001, 2.0));
  keys.Number({"most_m_s", "m/s", "speed before"}, docking.most_m_s, Between(0.005, 3.0));
  keys.Number({"most_rad_s", "rad/s", "of turning"}, docking.most_rad_s, Between(0.01, 6.0));
  keys.Number({"accel_m_s2", "m/s^2", "of speed"}, docking.accel_m_s2, Between(0.01, 10.0));
  keys.Number({"accel_rad_s2", "rad/s^2", "of turning"}, docking.accel_rad_s2, Between(0.01, 50.0));
  keys.Number({"dead_m_s", "m/s", "below which the wheels do not turn"}, docking.dead_m_s,
              NonNegative(0.5));
  keys.Number({"dead_rad_s", "rad/s", "the same of turning"}, docking.dead_rad_s, NonNegative(2.0));
  keys.Number({"staging_m", "m", "of the staging pose, out of the docked one"}, docking.staging_m,
              Between(0.05, 10.0));
  keys.Number({"perception_s", "s", "the marks are awaited so long"}, docking.perception_s,
              Between(0.1, 600.0));
  keys.Number({"approach_s", "s", "an approach may take"}, docking.approach_s,
              Between(1.0, 3600.0));
  keys.Number({"wait_charge_s", "s", "the contact is awaited so long"}, docking.wait_charge_s,
              Between(0.1, 600.0));
  keys.Integer({"retries", "", "new approaches"}, docking.retries, 0, 100);
  keys.Degrees({"wiggle_deg", "deg", "either side, as it presses on"}, docking.wiggle_rad,
               NonNegative(30.0));
  keys.Number({"aligned_m", "m", "farther off aside, the robot backs off before it touches"},
              docking.aligned_m, Positive(1.0));
  keys.Degrees({"aligned_deg", "deg", "the same turned"}, docking.aligned_rad, Positive(90.0));
  keys.Number({"press_m", "m", "driven on beyond the docked pose while the contact is open"},
              docking.press_m, NonNegative(0.5));
  keys.Number({"press_m_s", "m/s", "at which the robot touches and presses"}, docking.press_m_s,
              Between(0.001, 1.0));
  keys.Number({"search_rad_s", "rad/s", "of turning to find the dock"}, docking.search_rad_s,
              Between(0.01, 3.0));
  keys.Number({"docked_along_m", "m", "without a contact: docked within this along x of D"},
              docking.docked_along_m, Positive(1.0));
  keys.Number({"docked_aside_m", "m", "the same across"}, docking.docked_aside_m, Positive(1.0));
  keys.Degrees({"docked_deg", "deg", "the same turned"}, docking.docked_rad, Positive(90.0));
}

}  // namespace

void VisitCustomKeys(Keys& keys, CustomKeys& values) {
  keys.File({"dock", "", "the dock's model, or {urdf, file}", Presence::kRequired},
            values.dock_file);
  keys.Mapping({"judge", "", "", Presence::kRequired},
               [&](Keys& in) { VisitJudge(in, values.judge); });
  keys.Degrees({"off_dock_deg", "deg",
                "heading_deg less alpha_deg: 0 with its front to the dock, 180 with its rear",
                Presence::kUnset},
               values.off_dock_rad, Between(-180.0, 180.0));
  keys.Mapping({"graceful", "", ""}, [&](Keys& in) { VisitGraceful(in, values.docking); });
}

CustomKeys ReadCustomKeys(const Scenario& scenario) {
  CustomKeys values;
  ReadKeys(scenario.of_system, "custom", [&](Keys& keys) { VisitCustomKeys(keys, values); });
  return values;
}

}  // namespace dockyard::custom
