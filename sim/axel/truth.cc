// The truth of a world, gathered on demand.
#include <cmath>

#include "sim/axel/world_impl.h"
#include "sim/cable/cable_shape.h"

namespace dockyard::axel {

Truth World::Impl::MakeTruth() const {
  Truth truth;
  truth.time_s = static_cast<double>(steps_) * setup_.step_s;
  TellMotion(truth);
  TellMotors(truth);
  TellTether(truth);
  const ArmContact& contact = contacts_.arm_contact();
  truth.cone_force_n = contact.total_G.norm();
  truth.cone_force_peak_n = contacts_.arm_force_peak_n();
  truth.face_force_n = contact.face_G.norm();
  truth.tip_ground_force_n = rover_ground_.tip_force_n();
  truth.left_sinkage_m = loads_[0].sinkage_m;
  truth.right_sinkage_m = loads_[1].sinkage_m;
  truth.left_wheel_load_n = loads_[0].force_G.z();
  truth.right_wheel_load_n = loads_[1].force_G.z();
  return truth;
}

void World::Impl::TellMotion(Truth& truth) const {
  const LinkMotion& body = rover_.motion(RoverLink::kBody);
  truth.X_WR = X_WG_ * body.X_GL;
  truth.X_WA = X_WG_ * rover_.motion(RoverLink::kArm).X_GL;
  truth.X_W_left_wheel = X_WG_ * rover_.motion(RoverLink::kLeftWheel).X_GL;
  truth.X_W_right_wheel = X_WG_ * rover_.motion(RoverLink::kRightWheel).X_GL;
  for (int i = kOwnLinkCount; i < rover_.link_count(); ++i) {
    const LinkMotion& link = rover_.motion(static_cast<RoverLink>(i));
    truth.further.push_back({X_WG_ * link.X_GL, X_WG_.R * link.v_GL_G, X_WG_.R * link.w_GL_G});
  }
  truth.X_WS = X_WG_ * station_.motion().X_GL;
  truth.v_WR_W = X_WG_.R * body.v_GL_G;
  truth.w_WR_W = X_WG_.R * body.w_GL_G;

  const Pose3 X_GM = station_.X_GM();
  const Pose2 X_GD = ToGround(X_GM);  // the mouth's centre on the ground, the axis' heading
  truth.X_DR = Inverse(FromGround(X_GD, station_.motion().X_GL.p.z())) * body.X_GL;
  truth.p_MT = TipInMouth();
  truth.v_MT = TipVelocityInMouth();
  truth.arm_rad = rover_.joint_rad(RoverLink::kArm);
  truth.arm_rate_rad_s = rover_.joint_rad_s(RoverLink::kArm);
  truth.station_shift_m = (X_GM.p - p_GM_start_ - hand_.carried_G()).head<2>().norm();
  truth.station_sunk_m = station_.sunk_m();
  truth.rock_force_n = contacts_.rock_force_G().norm();
  truth.rock_force_peak_n = contacts_.rock_force_peak_n();
}

void World::Impl::TellMotors(Truth& truth) const {
  for (int i = 0; i < kMotorCount; ++i) {
    const Motor motor = static_cast<Motor>(i);
    truth.motor_angle_rad[i] = drives_.angle_rad(motor, rover_);
    truth.motor_speed_rad_s[i] = drives_.speed_rad_s(motor, rover_);
    truth.motor_torque_nm[i] = drives_.output(motor).motor_torque_nm;
    truth.motor_current_a[i] = drives_.output(motor).current_a;
    truth.motor_lead_rad[i] = drives_.output(motor).lead_rad;
  }
}

void World::Impl::TellTether(Truth& truth) const {
  if (cable_) {
    truth.tether_tension_n = pull_.tension_n;
    truth.tether_path_m = cable_->path_m(rover_);
    truth.tether_free_m = tether_at_start_m_ + drives_.tether_given_m(rover_);
    truth.tether_W = cable_->Line(rover_, station_);
    for (Eigen::Vector3d& p : truth.tether_W) p = X_WG_ * p;
    return;
  }
  const Pose3 X_GM = station_.X_GM();
  const double radius = std::hypot(truth.p_MT.y(), truth.p_MT.z());
  const Eigen::Vector2d tip(truth.p_MT.x(), radius);
  const TetherPath path = FindTetherPath(setup_.station.cone, setup_.station.anchor_depth_m, tip);
  truth.tether_tension_n = pull_.tension_n;
  truth.tether_path_m = path.total_m();
  truth.tether_free_m = tether_at_start_m_ + drives_.tether_given_m(rover_);

  Eigen::Vector3d out_M = Eigen::Vector3d::UnitZ();
  if (radius > 0.0) out_M = Eigen::Vector3d(0.0, truth.p_MT.y(), truth.p_MT.z()) / radius;
  std::vector<Eigen::Vector3d> way_G;
  for (int i = 0; i <= path.pieces; ++i) {
    way_G.push_back(X_GM * Eigen::Vector3d(path.nodes[i].x() * Eigen::Vector3d::UnitX() +
                                           path.nodes[i].y() * out_M));
  }
  if (truth.p_MT.x() > 0.0) {  // outside the cone it hangs
    const std::vector<Eigen::Vector3d> hanging =
        HangingTether(setup_.rover.tether, ground_, Tilt(setup_.slope), way_G[0], way_G[1],
                      truth.tether_tension_n, truth.tether_free_m - truth.tether_path_m,
                      setup_.soil.gravity_m_s2);
    truth.tether_W = hanging;
    way_G.erase(way_G.begin(), way_G.begin() + 2);
  }
  truth.tether_W.insert(truth.tether_W.end(), way_G.begin(), way_G.end());
  for (Eigen::Vector3d& p : truth.tether_W) p = X_WG_ * p;
}

}  // namespace dockyard::axel
