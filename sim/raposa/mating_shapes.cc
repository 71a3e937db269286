#include "sim/raposa/mating_shapes.h"

#include <algorithm>
#include <cmath>

#include "sim/rigid/collision_shapes.h"

namespace dockyard::raposa {
namespace {

// The seat goes on so far inwards of the guide's middle, to 3.5 mm of radius, and hides its nose.
// Assumed, 15-21 mm.
constexpr double kSeatEnds_m = 0.02;
// Outside of all walls [m]; it only gives them thickness. Assumed, 40-60 mm.
constexpr double kWallOuter_m = 0.045;

struct Rim {
  double x_m = 0.0, radius_m = 0.0;
};

/// The wall round a bore that is straight between two rims.
void AddWall(Rim a, Rim b, BoreContacts& socket) {
  socket.AddWall(
      {{b.x_m, kWallOuter_m}, {b.x_m, b.radius_m}, {a.x_m, a.radius_m}, {a.x_m, kWallOuter_m}});
}

}  // namespace

Pose3 SocketAxis(const SocketModel& socket) { return {RotY(0.5 * kPi), socket.p_RS}; }

BoreContacts SocketContacts(const RobotModel& robot, const PyramidModel& pyramid) {
  const SocketModel& socket = robot.socket;
  const DoorsModel& doors = robot.doors;
  const double slope = std::tan(socket.half_angle_rad);
  const double slot_m = robot.p_R_doors.x() - socket.p_RS.x();  // < 0
  const auto seat = [&](double x_m) { return Rim{x_m, socket.seat_radius_m - slope * x_m}; };
  const double behind_m = slot_m + 0.5 * doors.plate_m, before_m = slot_m - 0.5 * doors.plate_m;
  const double bore_ends_m =
      std::max(behind_m + 1e-3, (socket.seat_radius_m - socket.throat_radius_m) / slope);
  const double funnel_m = (socket.entrance_radius_m - socket.throat_radius_m) / slope;
  const Rim entrance{before_m - funnel_m, socket.entrance_radius_m},
      throat{before_m, socket.throat_radius_m}, bore{behind_m, socket.throat_radius_m},
      bore_end{bore_ends_m, socket.throat_radius_m}, seat_end = seat(kSeatEnds_m);
  BoreContacts contacts(true);  // front cone and seat fit each other
  AddWall(entrance, throat, contacts);
  AddWall(bore, bore_end, contacts);
  AddWall(seat(bore_ends_m), seat_end, contacts);
  for (const Rim& rim :
       {Rim{entrance.x_m, kWallOuter_m}, entrance, throat, bore, seat(bore_ends_m), seat_end}) {
    contacts.AddWallEdge(rim.x_m, rim.radius_m);
  }
  for (const std::vector<Collision>& pieces : {GuidePieces(pyramid), pyramid.body.collisions}) {
    for (const Collision& piece : pieces) contacts.AddPart(piece);
  }
  return contacts;
}

std::vector<Collision> DoorPieces(const DoorsModel& doors, bool left) {
  // Both V leave a square on its corner: |y| + |z| < corner.
  const double corner_m = std::sqrt(2.0) * (doors.closed_radius_m + kCollisionMargin_m);
  const double half_m = 0.5 * doors.plate_m - kCollisionMargin_m;
  // Of a plate, from its V outwards and up; assumed, 50-80 and 25-40 mm: they reach over the bore.
  const double wide_m = 0.06, high_m = 0.03, side = left ? 1.0 : -1.0;
  std::vector<Collision> pieces;
  for (const double up : {1.0, -1.0}) {
    HullShape hull;
    for (const Eigen::Vector2d& yz :
         {Eigen::Vector2d(0.0, corner_m), Eigen::Vector2d(corner_m, 0.0),
          Eigen::Vector2d(wide_m, 0.0), Eigen::Vector2d(wide_m, high_m),
          Eigen::Vector2d(0.0, high_m)}) {
      for (const double x : {-half_m, half_m})
        hull.points.emplace_back(x, side * yz.x(), up * yz.y());
    }
    pieces.push_back({up > 0.0 ? "upper" : "lower", hull, {}});
  }
  return pieces;
}

Pose3 GuideAxis(const GuideModel& guide) {
  Pose3 X_PA;
  X_PA.R = RotY(0.5 * kPi - guide.up_rad);  // z to x, then up
  return X_PA;
}

std::vector<Eigen::Vector2d> GuideProfile(const GuideModel& guide) {
  const double radius_m = 0.5 * guide.diameter_m, slope = std::tan(guide.half_angle_rad);
  const double front_m = std::min(0.5 * guide.length_m, (radius_m - guide.blunt_radius_m) / slope);
  const double rear_m = std::min(0.5 * guide.length_m, (radius_m - guide.rod_radius_m) / slope);
  return {
      {-rear_m, radius_m - slope * rear_m}, {0.0, radius_m}, {front_m, radius_m - slope * front_m}};
}

std::vector<Collision> GuidePieces(const PyramidModel& pyramid) {
  const GuideModel& guide = pyramid.guide;
  const MarksModel& marks = pyramid.marks;
  const Pose3 X_PA = GuideAxis(guide);
  std::vector<Collision> pieces{{"bi-cone", TurnedShape{GuideProfile(guide)}, X_PA}};
  const double rear_m = GuideProfile(guide).front().x();
  const double rod_m = marks.behind_m / std::cos(guide.up_rad) + rear_m;
  pieces.push_back({"rod", CylinderShape{guide.rod_radius_m, rod_m},
                    X_PA * Pose3{Eigen::Matrix3d::Identity(), {0.0, 0.0, rear_m - 0.5 * rod_m}}});
  HullShape faces;
  const double half_m = 0.5 * marks.edge_m;
  const double edge_m = -marks.behind_m + marks.strip_m;
  for (const double y : {-half_m, half_m}) {
    for (const double z : {-half_m, half_m}) {
      faces.points.emplace_back(-marks.behind_m, y, z);
      faces.points.emplace_back(edge_m, y, z);
    }
  }
  faces.points.emplace_back(edge_m + half_m * std::tan(marks.rise_rad), 0.0, 0.0);
  pieces.push_back({"faces", faces, {}});
  return pieces;
}

}  // namespace dockyard::raposa
