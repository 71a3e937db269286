// A caster and a pushed box against MuJoCo's. Its contacts are soft by a time constant, and its
// friction there is a velocity that decays, so what should rest creeps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "support/mujoco_model.h"
#include "vehicles/caster_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kTwinStep_s = 1e-3;

std::string Head() {
  std::ostringstream out;
  out << "<mujoco><compiler angle=\"radian\"/><option timestep=\"" << kTwinStep_s
      << "\" gravity=\"0 0 " << -kG_m_s2
      << "\" cone=\"elliptic\" tolerance=\"1e-12\" iterations=\"200\"/>\n<default><geom "
         "condim=\"3\" "
         "friction=\""
      << CasterRig::kRub << " 0 0\" solref=\"" << 2.0 * kTwinStep_s
      << " 1\"/></default>\n<worldbody><geom type=\"plane\" size=\"0 0 1\"/>\n";
  return out.str();
}

std::string Body(const LinkModel& link, const Vector3d& p_m, const std::string& joint,
                 const std::string& inside) {
  return "<body pos=\"" + MjcfNumbers(p_m) + "\">" + joint + MjcfInertial(link) + inside +
         "</body>\n";
}

/// The caster of CasterRig; its wheel is a sphere, so that it touches in one point as ours.
std::string CasterText() {
  const auto links = CasterRig::Links();
  std::string inside =
      "<geom type=\"sphere\" mass=\"0\" size=\"" + std::to_string(CasterRig::kRadius_m) + "\"/>";
  const char* joints[] = {"",
                          "<joint type=\"slide\" axis=\"1 0 0\"/>",
                          "<joint type=\"slide\" axis=\"0 1 0\"/>",
                          "<joint type=\"slide\" axis=\"0 0 1\"/>",
                          "<joint type=\"hinge\" axis=\"0 0 1\"/>",
                          "<joint type=\"hinge\" axis=\"0 1 0\"/>"};
  for (int i = 5; i >= 1; --i) {
    const TreeLink& link = links[static_cast<std::size_t>(i)];
    Vector3d p_m = link.p_PL;
    if (i == 1) p_m.z() += CasterRig::kRadius_m;
    inside = Body(link.model, p_m, joints[i], inside);
  }
  return Head() + inside + "</worldbody></mujoco>\n";
}

// Both follow tan(theta/2) = tan(theta_0/2) exp(-s/trail); MuJoCo's lags where its wheel slips.
TEST(FloorMujoco, CasterSwivelsRoundAlike) {
  const double start_rad = 175.0 * kPi / 180.0, speed_m_s = 0.1;
  CasterRig ours(kTwinStep_s, start_rad, speed_m_s, {});
  const MujocoModel model = LoadMujoco(CasterText());
  const MujocoData data(mj_makeData(model.get()));
  data->qpos[3] = start_rad;
  for (int i = 0; i < 300; ++i) mj_step(model.get(), data.get());
  const double start_m = data->qpos[0];
  mju_zero(data->qvel, model->nv);
  data->qvel[0] = speed_m_s;
  data->qvel[3] = -speed_m_s * std::sin(start_rad) / CasterRig::kTrail_m;
  data->qvel[4] = speed_m_s * std::cos(start_rad) / CasterRig::kRadius_m;
  double apart_rad = 0.0, ours_off_rad = 0.0, theirs_off_rad = 0.0;
  for (int i = 0; i < 2000; ++i) {
    ours.Run(kTwinStep_s);
    mj_step(model.get(), data.get());
    const double wanted_rad =
        2.0 * std::atan(std::tan(0.5 * start_rad) *
                        std::exp(-(data->qpos[0] - start_m) / CasterRig::kTrail_m));
    theirs_off_rad = std::max(theirs_off_rad, std::abs(data->qpos[3] - wanted_rad));
    ours_off_rad = std::max(ours_off_rad, std::abs(ours.angle_rad() - ours.WantedAngle()));
    apart_rad = std::max(apart_rad, std::abs(ours.angle_rad() - data->qpos[3]));
  }
  RecordProperty("apart_deg", std::to_string(apart_rad * 180.0 / kPi));
  RecordProperty("ours_off_deg", std::to_string(ours_off_rad * 180.0 / kPi));
  RecordProperty("theirs_off_deg", std::to_string(theirs_off_rad * 180.0 / kPi));
  EXPECT_LT(apart_rad, 0.02 * kPi);
}

class PushedBoxes {
 public:
  PushedBoxes()
      : ground_(LevelFloor(CasterRig::kRub)),
        world_(kDown),
        contacts_(world_, ground_),
        model_(LoadMujoco(Head() + "<body pos=\"0 0 " + std::to_string(0.5 * kSize_m) +
                          "\"><freejoint/><geom type=\"box\" mass=\"" + std::to_string(kBox_kg) +
                          "\" size=\"" + MjcfNumbers(Vector3d::Constant(0.5 * kSize_m)) +
                          "\"/></body></worldbody></mujoco>")),
        data_(mj_makeData(model_.get())) {
    world_.Add(FreeBody(BoxModel(kBox_kg, Vector3d::Constant(kSize_m)),
                        Pose3::Translation(0.0, 0.0, 0.5 * kSize_m)));
    contacts_.Add({.at = {0, 0},
                   .body_L = BoxHull({0, 0, 0}, Vector3d::Constant(kSize_m)),
                   .stiffness_n_per_m = 1e6,
                   .damping_ns_per_m = 1e3});
  }
  /// Pushed at the floor's height.
  void Run(double seconds, double push_n) {
    for (long i = 0; i < std::lround(seconds / kTwinStep_s); ++i) {
      Vector3d at_G = world_.body(0).motion(0).X_GL.p;
      at_G.z() = 0.0;
      world_.body(0).AddForce(0, {push_n, 0, 0}, at_G);
      contacts_.AddContacts(kTwinStep_s);
      world_.Step(kTwinStep_s);
      const mjtNum force[3] = {push_n, 0, 0}, torque[3] = {0, 0, 0};
      const mjtNum at[3] = {data_->qpos[0], data_->qpos[1], 0.0};
      mju_zero(data_->qfrc_applied, model_->nv);
      mj_applyFT(model_.get(), data_.get(), force, torque, at, 1, data_->qfrc_applied);
      mj_step(model_.get(), data_.get());
    }
  }
  double ours_m() const { return world_.body(0).motion(0).X_GL.p.x(); }
  double theirs_m() const { return data_->qpos[0]; }
  double ours_m_s() const { return world_.body(0).speeds()[0]; }
  double theirs_m_s() const { return data_->qvel[0]; }
  static double Limit_n() { return CasterRig::kRub * kBox_kg * kG_m_s2; }

 private:
  static constexpr double kSize_m = 0.3, kBox_kg = 20.0;
  FirmGround ground_;
  RigidWorld world_;
  FloorContacts contacts_;
  MujocoModel model_;
  MujocoData data_;
};

TEST(FloorMujoco, BoxPushedBelowFrictionRestsInOursAndCreepsInTheirs) {
  PushedBoxes boxes;
  boxes.Run(0.5, 0.0);
  boxes.Run(0.5, 0.9 * PushedBoxes::Limit_n());
  const double ours_m = boxes.ours_m(), theirs_m = boxes.theirs_m();
  boxes.Run(5.0, 0.9 * PushedBoxes::Limit_n());
  RecordProperty("ours_nm", std::to_string(1e9 * (boxes.ours_m() - ours_m)));
  RecordProperty("theirs_mm", std::to_string(1e3 * (boxes.theirs_m() - theirs_m)));
  EXPECT_LT(std::abs(boxes.ours_m() - ours_m), 1e-8);
  EXPECT_GT(boxes.theirs_m() - theirs_m, 1e-4);
}

TEST(FloorMujoco, BoxPushedAboveFrictionMovesAlike) {
  PushedBoxes boxes;
  boxes.Run(0.5, 0.0);
  const double seconds = 1.0;
  boxes.Run(seconds, 1.2 * PushedBoxes::Limit_n());
  const double wanted_m_s = 0.2 * CasterRig::kRub * kG_m_s2 * seconds;
  RecordProperty("ours_share", std::to_string(boxes.ours_m_s() / wanted_m_s - 1.0));
  RecordProperty("theirs_share", std::to_string(boxes.theirs_m_s() / wanted_m_s - 1.0));
  EXPECT_NEAR(boxes.ours_m_s(), wanted_m_s, 0.01 * wanted_m_s);
  EXPECT_NEAR(boxes.theirs_m_s(), wanted_m_s, 0.1 * wanted_m_s);
}

}  // namespace
}  // namespace dockyard
