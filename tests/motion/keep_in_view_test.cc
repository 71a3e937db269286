#include "controller/motion/keep_in_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/rover_sample.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

double SpareAt(const ViewPlan& view, const Eigen::Vector2d& p_RT) {
  const Eigen::Vector2d seen = p_RT - view.p_RC;
  const double range = seen.norm();
  const double bearing = WrapPi(std::atan2(seen.y(), seen.x()) - view.azimuth_rad);
  const double aside = view.half_width_rad - std::abs(bearing);  // from the nearer side
  const double across = aside < 0.5 * kPi ? range * std::sin(std::max(aside, -0.5 * kPi)) : range;
  return std::min({across, range - view.near_m, view.far_m - range});
}

TEST(SpareInView, IsTheLeastAlongTheWay) {
  RandomStream random(StreamKey(1, "view"));
  const ViewPlan view{{0.38, 0.1}, 0.3, Radians(40.0), 0.1, 2.5};
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const std::vector<Arc> path{{random.Uniform(-0.5, 0.8), random.Uniform(-0.6, 0.6)},
                                {random.Uniform(-0.5, 0.8), i % 4 == 0 ? 0.0 : 0.4}};
    const Eigen::Vector2d target(random.Uniform(0.5, 2.5), random.Uniform(-1, 1.5));
    double sampled = 1e9;
    Pose2 start;
    for (const Arc& arc : path) {
      for (int k = 0; k <= 2000; ++k) {
        const Pose2 X_AR = Advance(start, Part(arc, k / 2000.0));
        sampled = std::min(sampled, SpareAt(view, Inverse(X_AR) * target));
      }
      start = Advance(start, arc);
    }
    const double spare = SpareInView(view, path, target);
    if (sampled > 0.0) {
      ++inside;
      EXPECT_NEAR(spare, sampled, 1e-3);
    } else {
      EXPECT_LT(spare, 1e-3);
    }
  }
  EXPECT_GT(inside, 20);
}

}  // namespace
}  // namespace dockyard
