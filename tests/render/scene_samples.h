// A sample yard: station with board, rover arm and wheels, tether, poles, ground with a rut.
#pragma once

#include <memory>
#include <vector>

#include "render/stereo_renderer.h"

namespace dockyard {

/// Closed meshes, outward counter-clockwise.
RenderMesh BoxToRender(const Eigen::Vector3d& size_m);
RenderMesh CylinderToRender(double radius_m, double length_m, int sides = 32);  // along z, centred

/// A camera that faces along the rover's x axis, from (x, y, z) in R, pitched nose-down.
Pose3 ForwardCamera(double x_m, double y_m, double z_m, double pitch_rad = 0.0);
/// 0.35 m baseline, 90 deg across the width.
StereoRig SampleRig(int width = 1024, int height = 768);
/// Eight discs of 0.1 m, two of each rotation, unlike under any turn or mirror.
FiducialBoard SampleBoard();
/// Board upright, its viewer facing -x of the world.
Pose3 UprightBoard(double x_m, double y_m, double z_m);
/// Level rover at (x, y), heading counter-clockwise from the world's x axis.
Pose3 LevelRover(double x_m, double y_m, double heading_rad, double z_m = 0.15);
/// Unit vector towards the sun; azimuth counter-clockwise from the world's x axis.
Eigen::Vector3d SunAt(double azimuth_rad, double elevation_rad);

/// Owns the heights that its scene points to.
struct Yard {
  std::vector<double> heights_m;
  Scene scene;
  Pose3 X_WR;
};

/// A bare board at the origin's upright place, no ground, nothing else.
Scene BoardOnly();
/// The whole yard, the rover at range_m before the station, nose to it.
std::unique_ptr<Yard> SampleYard(double range_m, const Eigen::Vector3d& to_sun_W);
/// A leaning plate outside the view that throws a hard shadow edge across the board.
void AddCanopy(Yard& yard);
/// The same yard moved and turned about z as one rigid whole.
std::unique_ptr<Yard> Moved(const Yard& yard, double x_m, double y_m, double turn_rad);

}  // namespace dockyard
