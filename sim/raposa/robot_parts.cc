#include "sim/raposa/robot_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/read/mesh_loader.h"
#include "sim/raposa/mating_shapes.h"

namespace dockyard::raposa {
namespace {

// Shapes for spectators alone, which no camera of the robot and no contact has; assumed.
constexpr int kFacets = 48;
constexpr double kThick_m = 0.004;                       // of the housing's walls
constexpr double kHousingHalf_m = 0.095;                 // half its width
constexpr double kTop_m = 0.056, kBottom_m = -0.085;     // of the housing
constexpr double kRail_m = 0.006, kLens_m = 0.009;       // square; radius
constexpr double kLamp_m = 0.012, kBehindLens_m = 0.03;  // radius; length of the camera
const Eigen::Vector3d kPlastic(0.10, 0.11, 0.12), kMetal(0.45, 0.45, 0.46), kDark(0.02, 0.02, 0.02),
    kLampWhite(0.9, 0.9, 0.85);

using Points = std::vector<Eigen::Vector3d>;

std::uint32_t Add(RenderMesh& mesh, const Eigen::Vector3d& p) {
  mesh.vertices.push_back(p.cast<float>());
  return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

/// A closed strip between two rings of equal length.
void AddStrip(const Points& a, const Points& b, RenderMesh& mesh) {
  const std::size_t n = a.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const std::uint32_t i = Add(mesh, a[k]), j = Add(mesh, a[next]), l = Add(mesh, b[next]),
                        m = Add(mesh, b[k]);
    mesh.triangles.push_back({i, j, l});
    mesh.triangles.push_back({i, l, m});
  }
}

Points Circle(const Eigen::Vector3d& middle, double radius_m) {
  Points ring;
  for (int k = 0; k < kFacets; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / kFacets;
    ring.push_back(middle + radius_m * Eigen::Vector3d(0.0, std::cos(turn), std::sin(turn)));
  }
  return ring;
}

RenderMesh Box(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  const TriangleMesh box = BoxMesh(high - low);
  RenderMesh mesh;
  for (const Eigen::Vector3d& v : box.vertices) Add(mesh, v + 0.5 * (low + high));
  mesh.triangles = box.triangles;
  return mesh;
}

/// Round about x, closed at both ends.
RenderMesh Rod(const Eigen::Vector3d& rear, double length_m, double radius_m) {
  RenderMesh mesh;
  const Eigen::Vector3d front = rear + Eigen::Vector3d(length_m, 0.0, 0.0);
  const Points a = Circle(rear, radius_m), b = Circle(front, radius_m);
  AddStrip(a, b, mesh);
  AddStrip(Points(a.size(), rear), a, mesh);
  AddStrip(b, Points(b.size(), front), mesh);
  return mesh;
}

/// From the middle of a wall at x to the border of a rectangle and to that of the hole that the
/// funnel's entrance and the camera's view leave in it.
RenderMesh WallWithHole(double x_m, const Eigen::Vector3d& funnel, double funnel_m,
                        const Eigen::Vector3d& view, double view_m) {
  const double middle_m = 0.5 * (funnel.z() + view.z());
  Points outer, inner;
  for (int k = 0; k < 4 * kFacets; ++k) {
    const double turn = 2.0 * std::numbers::pi * k / (4 * kFacets);
    const double c = std::cos(turn), s = std::sin(turn);
    const auto reach = [&](double centre_m, double radius_m) {
      const double off_m = centre_m - middle_m, across2 = off_m * off_m * c * c;
      return across2 > radius_m * radius_m ? 0.0
                                           : off_m * s + std::sqrt(radius_m * radius_m - across2);
    };
    const double hole_m = std::max(reach(funnel.z(), funnel_m), reach(view.z(), view_m));
    const double up_m = (s > 0.0 ? kTop_m : kBottom_m) - middle_m;
    const double edge_m = std::min(std::abs(c) > 1e-9 ? kHousingHalf_m / std::abs(c) : 1e9,
                                   std::abs(s) > 1e-9 ? up_m / s : 1e9);
    inner.emplace_back(x_m, hole_m * c, middle_m + hole_m * s);
    outer.emplace_back(x_m, edge_m * c, middle_m + edge_m * s);
  }
  RenderMesh mesh;
  AddStrip(outer, inner, mesh);
  return mesh;
}

}  // namespace

std::vector<RobotPart> SocketParts(const RobotModel& robot) {
  const SocketModel& socket = robot.socket;
  const Eigen::Vector3d seat = socket.p_RS, lens = robot.camera.X_RC.p;
  const double slope = std::tan(socket.half_angle_rad), slot_m = robot.p_R_doors.x();
  const double entrance_m = slot_m - 0.5 * robot.doors.plate_m -
                            (socket.entrance_radius_m - socket.throat_radius_m) / slope;
  const auto on_axis = [&](double x_m) { return Eigen::Vector3d(x_m, seat.y(), seat.z()); };
  std::vector<RobotPart> parts;
  const double view_m = robot.camera.hole_m * std::tan(robot.camera.half_view_rad) + kThick_m;
  parts.push_back(
      {WallWithHole(entrance_m, on_axis(entrance_m), socket.entrance_radius_m, lens, view_m),
       kPlastic});
  // The housing's other walls reach to the body's tail.
  const double tail_m = slot_m + 0.012, half = kHousingHalf_m;
  parts.push_back({Box({entrance_m, -half, kTop_m}, {tail_m, half, kTop_m + kThick_m}), kPlastic});
  parts.push_back(
      {Box({entrance_m, -half, kBottom_m - kThick_m}, {tail_m, half, kBottom_m}), kPlastic});
  for (const double y : {-half - kThick_m, half}) {
    parts.push_back({Box({entrance_m, y, kBottom_m}, {tail_m, y + kThick_m, kTop_m}), kPlastic});
  }
  RenderMesh funnel;
  AddStrip(Circle(on_axis(entrance_m), socket.entrance_radius_m),
           Circle(on_axis(slot_m - 0.5 * robot.doors.plate_m), socket.throat_radius_m), funnel);
  AddStrip(Circle(on_axis(slot_m + 0.5 * robot.doors.plate_m), socket.throat_radius_m),
           Circle(seat, socket.seat_radius_m), funnel);
  AddStrip(Circle(seat, socket.seat_radius_m), Points(kFacets, seat), funnel);
  parts.push_back({std::move(funnel), kMetal});
  for (const double z : {seat.z() - 0.031 - kRail_m, seat.z() + 0.031}) {
    parts.push_back(
        {Box({slot_m - 0.5 * kRail_m, -half, z}, {slot_m + 0.5 * kRail_m, half, z + kRail_m}),
         kMetal});
  }
  parts.push_back({Rod(lens, kBehindLens_m, kLens_m), kDark});
  for (const double side : {-0.5, 0.5}) {
    const Eigen::Vector3d lamp =
        robot.lamps.p_R + Eigen::Vector3d(0.0, side * robot.lamps.apart_m, 0.0);
    parts.push_back(
        {Rod({entrance_m - kThick_m, lamp.y(), lamp.z()}, 2.0 * kThick_m, kLamp_m), kLampWhite});
  }
  return parts;
}

std::vector<RobotPart> DoorParts(const DoorsModel& doors, bool left) {
  std::vector<RobotPart> parts;
  for (const Collision& piece : DoorPieces(doors, left)) {
    const auto& points = std::get<HullShape>(piece.shape).points;  // rear and front by turns
    Points rear, front;
    for (std::size_t k = 0; k < points.size(); k += 2) {
      rear.push_back(points[k]);
      front.push_back(points[k + 1]);
    }
    RenderMesh mesh;
    AddStrip(rear, front, mesh);
    for (const Points& face : {rear, front}) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& p : face) middle += p / static_cast<double>(face.size());
      AddStrip(face, Points(face.size(), middle), mesh);
    }
    parts.push_back({std::move(mesh), kMetal});
  }
  return parts;
}

}  // namespace dockyard::raposa
