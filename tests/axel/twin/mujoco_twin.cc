#include "axel/twin/mujoco_twin.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "axel/twin/twin_parts.h"

namespace dockyard::axel {
namespace {

std::string Hinge(const MotorModel& motor) {
  std::ostringstream out;
  out.precision(17);
  out << "<joint type=\"hinge\" axis=\"0 1 0\" armature=\"" << motor.reflected_inertia_kg_m2
      << "\"/>\n";
  return out.str();
}

std::string Wheel(const char* name, const LinkModel& link, const WheelModel& wheel,
                  const Eigen::Vector3d& p_R, const MotorModel& motor, bool touches) {
  std::ostringstream out;
  out.precision(17);
  out << "<body name=\"" << name << "\" pos=\"" << MjcfNumbers(p_R) << "\">\n"
      << Hinge(motor) << MjcfInertial(link);
  if (touches) {
    out << "<geom type=\"cylinder\" size=\"" << wheel.rim_radius_m << ' ' << 0.5 * wheel.width_m
        << "\" euler=\"1.5707963267948966 0 0\"/>\n";
  }
  out << "</body>\n";
  return out.str();
}

std::string MakeXml(const WorldSetup& setup, double friction, double gravity,
                    const TwinSurroundings& around) {
  const RoverModel& rover = setup.rover;
  const bool ground = gravity > 0.0;
  std::ostringstream xml;
  xml.precision(17);
  // Contacts as stiff as the step allows: a time constant of two steps, critically damped.
  xml << "<mujoco><compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n<option timestep=\""
      << setup.step_s << "\" gravity=\"0 0 " << -gravity
      << "\" cone=\"elliptic\" impratio=\"10\" tolerance=\"1e-12\"/>\n"
      << "<default><geom condim=\"3\" friction=\"" << friction << " 0 0\" solref=\""
      << 2.0 * setup.step_s << " 1\"/></default>\n<asset>\n";
  if (around.uneven) xml << HeightFieldAsset(setup.ground);
  if (around.cone) xml << ConeMeshes(setup.station.cone) << ArmMeshes(rover);
  xml << "</asset>\n<worldbody>\n";
  if (around.uneven) {
    xml << HeightFieldGeom(setup.ground);
  } else if (ground) {
    xml << "<geom type=\"plane\" size=\"0 0 1\" contype=\"1\" conaffinity=\"1\"/>\n";
  }
  if (around.cone) {
    const Pose3 X_GS = FromGround(setup.X_GD, 0.0);
    xml << ConeBody(setup.station.cone, X_GS * MouthInStation(setup.station));
  }
  xml << "<body name=\"body\"><freejoint/>\n" << MjcfInertial(rover.body);
  xml << Wheel("left", rover.left_wheel, rover.left_wheel_soil, rover.p_R_left_wheel,
               rover.motors[0], ground);
  xml << Wheel("right", rover.right_wheel, rover.right_wheel_soil, rover.p_R_right_wheel,
               rover.motors[1], ground);
  xml << "<body name=\"arm\">\n"
      << Hinge(rover.motors[2]) << MjcfInertial(rover.arm) << (around.cone ? ArmGeoms(rover) : "")
      << "</body>\n";
  xml << "</body></worldbody></mujoco>\n";
  return xml.str();
}

// Servo and bristles as stiff as in our world; the inertias are the drive train's.
MotorDrive MakeDrive(const RoverModel& rover, const LinkModel& link, int motor) {
  const Eigen::Vector3d& c = link.p_LoCom_L;
  const double own = link.I_LCom_L(1, 1) + link.mass_kg * (c.x() * c.x() + c.z() * c.z());
  const double body = rover.body.I_LCom_L(1, 1);
  const MotorModel& model = rover.motors[motor];
  return {model, own * body / (own + body) + model.reflected_inertia_kg_m2};
}

}  // namespace

MujocoTwin::MujocoTwin(const WorldSetup& setup, double ground_friction, double gravity_m_s2,
                       const TwinSurroundings& surroundings)
    : model_(LoadMujoco(MakeXml(setup, ground_friction, gravity_m_s2, surroundings))),
      data_(mj_makeData(model_.get())),
      rover_(setup.rover),
      drives_{MakeDrive(rover_, rover_.left_wheel, 0), MakeDrive(rover_, rover_.right_wheel, 1),
              MakeDrive(rover_, rover_.arm, 2),
              MotorDrive(rover_.motors[3], rover_.motors[3].reflected_inertia_kg_m2)} {
  const Pose3 X_GS = FromGround(setup.X_GD, 0.0);
  anchor_G_ = X_GS * (MouthInStation(setup.station) *
                      Eigen::Vector3d(-setup.station.anchor_depth_m, 0.0, 0.0));
  body_ = mj_name2id(model_.get(), mjOBJ_BODY, "body");
  arm_ = mj_name2id(model_.get(), mjOBJ_BODY, "arm");
  cone_ = mj_name2id(model_.get(), mjOBJ_BODY, "cone");
  if (surroundings.uneven) TakeHeights(setup.ground, *model_);
}

void MujocoTwin::SetPose(const Pose3& X_GR, double arm_rad) {
  const Eigen::Quaterniond q(X_GR.R);
  for (int i = 0; i < 3; ++i) data_->qpos[i] = X_GR.p[i];
  data_->qpos[3] = q.w();
  data_->qpos[4] = q.x();
  data_->qpos[5] = q.y();
  data_->qpos[6] = q.z();
  data_->qpos[9] = arm_rad;
  mj_forward(model_.get(), data_.get());
}

void MujocoTwin::PowerOn(double slack_m) {
  for (int i = 0; i < 3; ++i) zero_rad_[i] = joint_rad(i);
  for (MotorDrive& drive : drives_) drive.ResetProfile(0.0);
  drum_rad_ = drum_rad_s_ = 0.0;
  free_at_start_m_ = (TipInG() - anchor_G_).norm() + slack_m;
}

void MujocoTwin::Pull() {
  // A line that stretches over its whole length out to the drum, damped, and never pushes.
  const Eigen::Vector3d tip = TipInG(), way = anchor_G_ - tip;
  const double length = way.norm();
  const double turn = joint_rad(2) - zero_rad_[2] - drum_rad_;
  const double free = free_at_start_m_ + rover_.tether.drum_radius_m * turn;
  const double elastic =
      rover_.tether.axial_stiffness_n * (length - free) / (free + rover_.arm_length_m);
  tension_n_ = 0.0;
  if (elastic <= 0.0) return;
  std::array<mjtNum, 6> speed{};  // of the arm's frame: turning, then moving
  mj_objectVelocity(model_.get(), data_.get(), mjOBJ_XBODY, arm_, speed.data(), 0);
  const Eigen::Vector3d w(speed[0], speed[1], speed[2]), v0(speed[3], speed[4], speed[5]);
  const Eigen::Vector3d at(data_->xpos[3 * arm_], data_->xpos[3 * arm_ + 1],
                           data_->xpos[3 * arm_ + 2]);
  const Eigen::Vector3d v = v0 + w.cross(tip - at);
  const double rate =
      -way.dot(v) / length - rover_.tether.drum_radius_m * (joint_rad_s(2) - drum_rad_s_);
  tension_n_ = elastic + std::clamp(rover_.tether.damping_ns_per_m * rate, -elastic, elastic);
  const Eigen::Vector3d force = tension_n_ / length * way;
  const std::array<mjtNum, 3> none{};
  mj_applyFT(model_.get(), data_.get(), force.data(), none.data(), tip.data(), arm_,
             data_->qfrc_applied);
}

void MujocoTwin::Step(const std::array<MotorCommand, kMotorCount>& commands) {
  const double dt = model_->opt.timestep;
  mju_zero(data_->qfrc_applied, model_->nv);
  Pull();
  const double pull_nm = tension_n_ * rover_.tether.drum_radius_m;
  for (int i = 0; i < 3; ++i) {
    data_->qfrc_applied[6 + i] +=
        drives_[i].Step(commands[i], joint_rad(i) - zero_rad_[i], joint_rad_s(i), dt).torque_nm();
  }
  const double drum_nm = drives_[3].Step(commands[3], drum_rad_, drum_rad_s_, dt).torque_nm();
  data_->qfrc_applied[8] += pull_nm;
  const Eigen::Vector3d torque = (pull_nm - drum_nm) * X_GR().R.col(1);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero(), at = X_GR().p;
  mj_applyFT(model_.get(), data_.get(), none.data(), torque.data(), at.data(), body_,
             data_->qfrc_applied);
  mj_step(model_.get(), data_.get());
  drum_rad_s_ += (drum_nm - pull_nm) / rover_.motors[3].reflected_inertia_kg_m2 * dt;
  drum_rad_ += drum_rad_s_ * dt;
}

void MujocoTwin::StepUnder(const std::array<double, 3>& joint_torque_nm) {
  for (int i = 0; i < 3; ++i) data_->qfrc_applied[6 + i] = joint_torque_nm[i];
  mj_step(model_.get(), data_.get());
}

Pose3 MujocoTwin::X_GR() const {
  const mjtNum* q = data_->qpos;
  Pose3 X;
  X.p = Eigen::Vector3d(q[0], q[1], q[2]);
  X.R = Eigen::Quaterniond(q[3], q[4], q[5], q[6]).toRotationMatrix();
  return X;
}

Eigen::Vector3d MujocoTwin::w_GR_R() const {
  return {data_->qvel[3], data_->qvel[4], data_->qvel[5]};
}

Eigen::Vector3d MujocoTwin::TipInG() const {
  const Pose3 X = X_GR();
  return X.p + X.R * (RotY(joint_rad(2)) * Eigen::Vector3d(rover_.arm_length_m, 0.0, 0.0));
}

Eigen::Vector3d MujocoTwin::GroundForce() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < data_->ncon; ++i) {
    std::array<mjtNum, 6> force{};
    mj_contactForce(model_.get(), data_.get(), i, force.data());
    const Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>> axes(
        data_->contact[i].frame);
    const double sign = data_->contact[i].geom1 == 0 ? 1.0 : -1.0;  // the plane is geom 0
    sum += sign * (axes.transpose() * Eigen::Vector3d(force[0], force[1], force[2]));
  }
  return sum;
}

bool MujocoTwin::ConePresses() const {
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    const int a = model_->geom_bodyid[contact.geom1], b = model_->geom_bodyid[contact.geom2];
    if (std::min(a, b) != std::min(arm_, cone_) || std::max(a, b) != std::max(arm_, cone_))
      continue;
    std::array<mjtNum, 6> force{};
    mj_contactForce(model_.get(), data_.get(), i, force.data());
    if (force[0] > 0.0) return true;
  }
  return false;
}

}  // namespace dockyard::axel
