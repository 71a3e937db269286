// Casters that swivel round, against their exact motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "vehicles/caster_rig.h"

namespace dockyard {
namespace {

class CasterAt : public AtStep {};

// A caster whose pivot moves straight by s and which does not slip turns by
// tan(theta/2) = tan(theta_0/2) exp(-s/trail), theta 0 where it trails.
TEST_P(CasterAt, SwivelsRoundAsItsPivotMoves) {
  const double start_rad = 175.0 * kPi / 180.0, speed_m_s = 0.1;
  CasterRig rig(step_s(), start_rad, speed_m_s, {});
  double worst_rad = 0.0;
  for (int i = 0; i < 40; ++i) {
    rig.Run(0.05);
    const double wanted_rad = rig.WantedAngle();
    worst_rad = std::max(worst_rad, std::abs(rig.angle_rad() - wanted_rad));
  }
  RecordProperty("worst_deg", std::to_string(worst_rad * 180.0 / kPi));
  RecordProperty("end_deg", std::to_string(rig.angle_rad() * 180.0 / kPi));
  EXPECT_LT(worst_rad, 0.01 * kPi);
  EXPECT_LT(rig.angle_rad(), 0.1);
}

// The swivel's friction T and the rolling resistance f N / R push the pivot aside while the caster
// comes round: F = T/trail cos(theta) - f N/R sign(cos(theta)) sin(theta). Where the wheel begins
// to roll backward, at 90 deg, its bend takes 2 f N/(R k) to turn over.
TEST_P(CasterAt, KicksItsPivotAsideAsItComesRound) {
  const double start_rad = 170.0 * kPi / 180.0, speed_m_s = 0.1;
  const CasterLosses losses{.friction_nm = 0.02, .rolling_resistance_m = 1e-3};
  CasterRig rig(step_s(), start_rad, speed_m_s, losses);
  const double rolling_n = losses.rolling_resistance_m * rig.load_n() / CasterRig::kRadius_m;
  struct Part {
    double from_s, to_s, sign;
  };
  double now_s = 0.0;
  for (const Part& part : {Part{0.1, 0.64, 1.0}, Part{0.86, 1.2, -1.0}}) {
    rig.Run(part.from_s - now_s);
    const double from_rad = rig.angle_rad(), from_ns = rig.side_impulse_ns();
    rig.Run(part.to_s - part.from_s);
    now_s = part.to_s;
    const double to_rad = rig.angle_rad();
    const double rolled = part.sign * (from_rad - to_rad) * CasterRig::kTrail_m * rolling_n;
    const double rubbed = losses.friction_nm * std::log(std::sin(from_rad) / std::sin(to_rad));
    const double wanted_ns = (rolled + rubbed) / speed_m_s;
    const std::string name = part.sign > 0.0 ? "ahead" : "behind";
    RecordProperty("off_share_" + name,
                   std::to_string((rig.side_impulse_ns() - from_ns) / wanted_ns - 1.0));
    RecordProperty("kick_ns_" + name, std::to_string(wanted_ns));
    EXPECT_NEAR(rig.side_impulse_ns() - from_ns, wanted_ns, 0.01 * std::abs(wanted_ns)) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, CasterAt, testing::Values(0.5e-3, 1e-3, 2e-3));

}  // namespace
}  // namespace dockyard
