// Contacts of guide and socket against closed forms, and against the distances of many points of
// the guide's surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

#include "raposa/sim/raposa_rig.h"
#include "sim/base/random.h"
#include "sim/raposa/mating_shapes.h"
#include "sim/rigid/collision_shapes.h"
#include "sim/rigid/turned_shape.h"

namespace dockyard::raposa {
namespace {

constexpr double kRounding_m = kCollisionMargin_m;

class Socket {
 public:
  Socket() : setup_(AtStart(1.0)), contacts_(SocketContacts(setup_.robot, setup_.pyramid)) {}
  const RobotModel& robot() const { return setup_.robot; }
  const PyramidModel& pyramid() const { return setup_.pyramid; }

  /// In the socket's frame; X_CA: the guide's axis, its middle at the origin.
  double LeastGap(const Pose3& X_CA) const {
    std::vector<BoreContact> found;
    contacts_.Find(Pose3{}, X_CA * Inverse(GuideAxis(setup_.pyramid.guide)), 0.05, found);
    double least = 1.0;
    for (const BoreContact& contact : found) least = std::min(least, contact.gap_m);
    return least;
  }

 private:
  WorldSetup setup_;
  BoreContacts contacts_;
};

TEST(RaposaSocket, GuideOnTheAxisIsAsFarFromTheSeatAsItsConeSays) {
  const Socket socket;
  for (const double back_m : {0.0, 1e-3, 2e-3}) {
    const double gap = back_m * std::sin(socket.robot().socket.half_angle_rad);
    EXPECT_NEAR(socket.LeastGap(Pose3::Translation(0.0, 0.0, -back_m)), gap, 1e-9) << back_m;
  }
}

TEST(RaposaSocket, GuideInTheThroatHasThePlayOfBothRadii) {
  const Socket socket;
  const GuideModel& guide = socket.pyramid().guide;
  // The edge round its middle is rounded by the margin.
  const double radius_m =
      0.5 * guide.diameter_m - kRounding_m * (1.0 / std::cos(guide.half_angle_rad) - 1.0);
  // Its middle in the funnel's throat, before the doors.
  const double in_m = socket.robot().p_R_doors.x() - socket.robot().socket.p_RS.x() -
                      0.5 * socket.robot().doors.plate_m;
  for (const double aside_m : {0.2e-3, 0.8e-3}) {
    const double gap = socket.robot().socket.throat_radius_m - radius_m - aside_m;
    const double found = socket.LeastGap(Pose3::Translation(aside_m, 0.0, in_m));
    EXPECT_LT(found, gap + 1e-9) << aside_m;
    EXPECT_GT(found, gap - 1e-4) << aside_m;  // its cone may be nearer to the throat's edge
  }
}

/// Distance of (z, r) from a straight piece.
double From(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  const double share = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (p - a - share * way).norm();
}

// The socket's inner side as one line, written down anew: entrance, throat, slot, bore, seat.
std::vector<std::vector<Eigen::Vector2d>> InnerSide(const RobotModel& robot) {
  const double slot = robot.p_R_doors.x() - robot.socket.p_RS.x(), half = 0.5 * robot.doors.plate_m;
  const double slope = std::tan(robot.socket.half_angle_rad), wide = 0.045;
  const double throat = robot.socket.throat_radius_m, entrance = robot.socket.entrance_radius_m;
  const double narrows = (robot.socket.seat_radius_m - throat) / slope;
  return {{{slot - half - (entrance - throat) / slope, wide},
           {slot - half - (entrance - throat) / slope, entrance},
           {slot - half, throat},
           {slot - half, wide}},
          {{slot + half, wide},
           {slot + half, throat},
           {narrows, throat},
           {0.02, robot.socket.seat_radius_m - 0.02 * slope},
           {0.02, wide}}};
}

TEST(RaposaSocket, NoPointOfTheGuideIsNearerThanTheContactsSay) {
  const Socket socket;
  const auto walls = InnerSide(socket.robot());
  const std::vector<Eigen::Vector2d> core =
      DrawnIn(GuideProfile(socket.pyramid().guide), kRounding_m);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i + 1 < core.size(); ++i) {
    for (int k = 0; k <= 40; ++k) {
      const Eigen::Vector2d at = core[i] + (core[i + 1] - core[i]) * k / 40.0;
      for (int turn = 0; turn < 180; ++turn) {
        const double angle = turn * kPi / 90.0;
        points.emplace_back(at.y() * std::cos(angle), at.y() * std::sin(angle), at.x());
      }
    }
  }
  RandomStream random(5);
  int compared = 0;
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i) {
    Pose3 X_CA;
    X_CA.R = RotX(random.Uniform(-0.15, 0.15)) * RotY(random.Uniform(-0.15, 0.15));
    // Within, or about the entrance.
    const bool within = i % 2 == 0;
    const double aside_m = within ? 5e-3 : 0.045;
    X_CA.p = {random.Uniform(-aside_m, aside_m), random.Uniform(-aside_m, aside_m),
              within ? random.Uniform(-0.06, 0.0) : random.Uniform(-0.1, -0.05)};
    const double gap = socket.LeastGap(X_CA);
    if (gap < 0.0 || gap > 5e-3) continue;  // pressed in, or another thing is nearer
    double least = 1.0;
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d p_C = X_CA * p;
      const Eigen::Vector2d cut(p_C.z(), p_C.head<2>().norm());
      for (const auto& line : walls) {
        for (std::size_t k = 0; k + 1 < line.size(); ++k) {
          least = std::min(least, From(cut, line[k], line[k + 1]) - kRounding_m);
        }
      }
    }
    ++compared;
    worst = std::max(worst, std::abs(least - gap));
  }
  std::printf("%d poses, worst %.4f mm\n", compared, 1e3 * worst);
  EXPECT_GT(compared, 100);
  EXPECT_LT(worst, 5e-5);
}

}  // namespace
}  // namespace dockyard::raposa
