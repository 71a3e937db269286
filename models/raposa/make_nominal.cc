#include "models/raposa/make_nominal.h"

namespace dockyard::raposa {
namespace {

GreyBox BoxAbout(const Visual& visual) {
  GreyBox box{Eigen::Vector3d::Constant(1e9), Eigen::Vector3d::Constant(-1e9)};
  for (const Eigen::Vector3d& vertex : visual.mesh->vertices) {
    const Eigen::Vector3d p_P = visual.X_LV * vertex;
    box.low = box.low.cwiseMin(p_P);
    box.high = box.high.cwiseMax(p_P);
  }
  return box;
}

}  // namespace

Nominal MakeNominal(const RobotModel& robot, const PyramidModel& pyramid) {
  Nominal nominal;
  for (std::size_t i = 0; i < robot.motors.size(); ++i) {
    nominal.motors[i] = NominalOf(robot.motors[i]);
  }
  nominal.camera = robot.camera.camera;
  nominal.X_RC = robot.camera.X_RC;
  nominal.camera_delay_s = robot.camera.delay_s;
  nominal.half_view_rad = robot.camera.half_view_rad;
  nominal.marks = {.edge_m = pyramid.marks.edge_m,
                   .behind_m = pyramid.marks.behind_m,
                   .guide_diameter_m = pyramid.guide.diameter_m,
                   .guide_length_m = pyramid.guide.length_m,
                   .guide_height_m = pyramid.guide.height_m,
                   .strip_m = pyramid.marks.strip_m,
                   .rise_rad = pyramid.marks.rise_rad,
                   .guide_half_angle_rad = pyramid.guide.half_angle_rad,
                   .guide_up_rad = pyramid.guide.up_rad,
                   .rod_radius_m = pyramid.guide.rod_radius_m,
                   .guide_blunt_radius_m = pyramid.guide.blunt_radius_m};
  for (const Visual& visual : pyramid.body.visuals) nominal.grey_boxes.push_back(BoxAbout(visual));
  nominal.sprocket_radius_m = robot.belts.roller_radius_m;
  nominal.gauge_m = robot.belts.gauge_m;
  nominal.effective_gauge_m = robot.belts.effective_gauge_m;
  nominal.body_belt_m = robot.belts.body_front_m - robot.belts.body_rear_m;
  nominal.arm_length_m = robot.belts.arm_length_m;
  nominal.door_pinion_radius_m = robot.doors.pinion_radius_m;
  nominal.door_travel_m = robot.doors.travel_m;
  nominal.p_RS = robot.socket.p_RS;
  return nominal;
}

}  // namespace dockyard::raposa
