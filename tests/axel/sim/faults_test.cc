// The faults of scenarios/axel_faults.yaml in closed loop. Single outcomes flip with any change of
// a solver, so one of two seeds must dock; the campaign has the rates.
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "axel/sim/scenarios.h"

namespace dockyard::axel {
namespace {

struct Fault {
  std::string name;
  std::vector<std::string> keys;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

class Faults : public testing::TestWithParam<Fault> {};

TEST_P(Faults, LeaveADocking) {
  std::string outcomes;
  for (const char* seed : {"seed=1", "seed=2"}) {
    std::vector<std::string> keys = GetParam().keys;
    keys.insert(keys.end(), {seed, "start={r_m: 2.5, alpha_deg: 8, heading_deg: 0}",
                             "camera.width_px=640", "camera.height_px=480", "time_limit_s=300"});
    const std::string outcome = SimulateTypical(keys).result.outcome;
    EXPECT_NE(outcome, "false_docked");
    if (outcome == "docked") return;
    outcomes += outcome + " ";
  }
  ADD_FAILURE() << GetParam().name << ": " << outcomes;
}

INSTANTIATE_TEST_SUITE_P(
    Each, Faults,
    testing::Values(
        Fault{"camera_dead", {"camera.left.picture=none"}},
        Fault{"lens_half_covered", {"camera.left.cover=0.5", "camera.left.cover_side_deg=180"}},
        Fault{"marks_dirty", {"axel.dirty_marks={count: 3, dust: 0.8}"}},
        Fault{"spool_weak", {"as_built.robot.motors.spool.torque_per_amp_nm.times=0.6"}},
        Fault{"wheel_on_rock", {"axel.start.rock_m=0.08"}},
        Fault{"yaw_drift", {"as_built.robot.imu.gyro_bias_deg_per_h.times=10"}},
        Fault{"station_moved",
              {"axel.station_moved={at_s: 20, forward_m: 0.06, left_m: 0.08, turn_deg: 3}"}},
        Fault{"images_late", {"camera.delay_s=1"}}),
    [](const testing::TestParamInfo<Fault>& info) { return info.param.name; });

}  // namespace
}  // namespace dockyard::axel
