// The robot as spectators see it: what its camera needs is open, the rest is closed.
#include "sim/raposa/robot_parts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/raposa/load_robot.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

/// Whether a ray meets a triangle (Moeller and Trumbore, J. Graphics Tools 2, 1997).
bool Meets(const Eigen::Vector3d& from, const Eigen::Vector3d& along, const Eigen::Vector3d& a,
           const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, p = along.cross(ac);
  const double det = ab.dot(p);
  if (std::abs(det) < 1e-15) return false;
  const double u = (from - a).dot(p) / det;
  const Eigen::Vector3d q = (from - a).cross(ab);
  const double v = along.dot(q) / det, t = ac.dot(q) / det;
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-9;
}

bool Meets(const Eigen::Vector3d& from, const Eigen::Vector3d& along, const RenderMesh& mesh) {
  for (const auto& t : mesh.triangles) {
    if (Meets(from, along, mesh.vertices[t[0]].cast<double>(), mesh.vertices[t[1]].cast<double>(),
              mesh.vertices[t[2]].cast<double>())) {
      return true;
    }
  }
  return false;
}

Eigen::Vector3d Backwards(double off_rad, double round_rad) {
  return {-std::cos(off_rad), std::sin(off_rad) * std::cos(round_rad),
          std::sin(off_rad) * std::sin(round_rad)};
}

// F, C: the hole leaves the camera 25 deg. Its lower part opens into the funnel.
TEST(RobotParts, LeaveTheCameraItsViewThroughTheHousing) {
  const RobotModel robot = LoadRobot(SourceFile("models/raposa/raposa.yaml"));
  const RenderMesh wall = SocketParts(robot).front().mesh;
  const Eigen::Vector3d camera = robot.camera.X_RC.p;
  for (double round = 0.0; round < 2.0 * kPi; round += 0.1) {
    for (double off = 0.0; off <= robot.camera.half_view_rad; off += 0.02) {
      EXPECT_FALSE(Meets(camera, Backwards(off, round), wall)) << off << ' ' << round;
    }
  }
  for (const double round : {0.0, 0.5, 1.57, 2.6, 3.14}) {  // to the sides and up
    EXPECT_TRUE(Meets(camera, Backwards(robot.camera.half_view_rad + 0.12, round), wall)) << round;
  }
}

TEST(RobotParts, LeaveTheGuideItsPathThroughFunnelAndOpenDoors) {
  const RobotModel robot = LoadRobot(SourceFile("models/raposa/raposa.yaml"));
  const Eigen::Vector3d outside = robot.socket.p_RS - Eigen::Vector3d(0.2, 0.0, 0.0);
  for (const double aside_m : {-0.015, 0.0, 0.015}) {
    const Eigen::Vector3d from = outside + Eigen::Vector3d(0.0, aside_m, 0.0);
    EXPECT_FALSE(Meets(from, Eigen::Vector3d::UnitX(), SocketParts(robot).front().mesh));
    for (const bool left : {true, false}) {
      const double open_m = (left ? 1.0 : -1.0) * robot.doors.travel_m;
      const Eigen::Vector3d in_door = from - robot.p_R_doors - Eigen::Vector3d(0.0, open_m, 0.0);
      const Eigen::Vector3d closed = from - robot.p_R_doors;
      int open = 0, shut = 0;
      for (const RobotPart& part : DoorParts(robot.doors, left)) {
        open += Meets(in_door, Eigen::Vector3d::UnitX(), part.mesh);
        shut += Meets(closed, Eigen::Vector3d::UnitX(), part.mesh);
      }
      EXPECT_EQ(open, 0) << aside_m;
      // Off the V a closed door blocks its own side.
      EXPECT_EQ(shut > 0, left ? aside_m > 0.0 : aside_m < 0.0) << aside_m << left;
    }
  }
}

}  // namespace
}  // namespace dockyard::raposa
