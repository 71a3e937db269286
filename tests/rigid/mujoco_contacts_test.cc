// Our contacts against MuJoCo's. MuJoCo's are soft by a time constant, and friction there is a
// velocity that decays, so a box creeps down a slope; ours bends like a spring and holds.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "rigid/world_scenes.h"
#include "support/mujoco_model.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kBoxStep_s = 1e-3, kBoxTimeConstant_s = 2.0 * kBoxStep_s;
constexpr double kBox_kg = 1.0, kBox_m = 0.1, kRub = 0.4;
constexpr ContactMaterial kHard{1e6, 1e3, kRub, 0.0};

/// Boxes one on another on the level ground, in both engines.
class Boxes {
 public:
  explicit Boxes(int count)
      : world_(kDown), model_(LoadMujoco(Mjcf(count))), data_(mj_makeData(model_.get())) {
    for (int i = 0; i < count; ++i) {
      world_.Add(FreeBody(BoxModel(kBox_kg, Vector3d::Constant(kBox_m)),
                          Pose3::Translation(0.0, 0.0, kBox_m * (0.5 + i))));
    }
  }
  void SetGravity(const Vector3d& gravity_G) {
    world_.SetGravity(gravity_G);
    for (int k = 0; k < 3; ++k) model_->opt.gravity[k] = gravity_G[k];
  }
  /// Of the lowest box along x.
  void Push(double speed_m_s) {
    SetSpeeds(world_.body(0), {speed_m_s});
    data_->qvel[0] = speed_m_s;
  }
  void Run(double seconds) {
    for (long i = 0; i < std::lround(seconds / kBoxStep_s); ++i) {
      for (int box = 0; box < static_cast<int>(model_->nbody) - 1; ++box) AddCorners(box);
      world_.Step(kBoxStep_s);
      mj_step(model_.get(), data_.get());
    }
  }
  Vector3d OurPlace(int box) const { return world_.body(box).motion(0).X_GL.p; }
  Vector3d TheirPlace(int box) const { return Eigen::Map<const Vector3d>(data_->qpos + 7 * box); }
  double OurSpeed() const { return world_.body(0).speeds()[0]; }
  double TheirSpeed() const { return data_->qvel[0]; }
  /// Of what is below on a box, upwards [N].
  double OurForce(int box) const {
    double force_n = 0.0;
    for (const WorldContact& contact : world_.contacts()) {
      if (contact.a.body == box) force_n += contact.impulse_G.z() / kBoxStep_s;
    }
    return force_n;
  }
  double TheirForce(int box) const {
    double force_n = 0.0;
    for (int i = 0; i < data_->ncon; ++i) {
      const mjContact& contact = data_->contact[i];
      const int a = model_->geom_bodyid[contact.geom1], b = model_->geom_bodyid[contact.geom2];
      if (std::max(a, b) != box + 1) continue;
      std::array<mjtNum, 6> force{};
      mj_contactForce(model_.get(), data_.get(), i, force.data());
      force_n += force[0] * std::abs(contact.frame[2]);
    }
    return force_n;
  }

 private:
  static std::string Mjcf(int count) {
    std::ostringstream out;
    // As stiff as the step allows: a time constant of two steps, critically damped.
    out << "<mujoco><option timestep=\"" << kBoxStep_s << "\" gravity=\"0 0 " << kDown.z()
        << "\" cone=\"elliptic\" tolerance=\"1e-12\" iterations=\"200\"/>\n<default><geom "
           "condim=\"3\" friction=\""
        << kRub << " 0 0\" solref=\"" << kBoxTimeConstant_s
        << " 1\"/></default>\n<worldbody><geom type=\"plane\" size=\"0 0 1\"/>\n";
    for (int i = 0; i < count; ++i) {
      out << "<body pos=\"0 0 " << kBox_m * (0.5 + i) << "\"><freejoint/><geom type=\"box\" mass=\""
          << kBox_kg << "\" size=\"" << MjcfNumbers(Vector3d::Constant(0.5 * kBox_m))
          << "\"/></body>\n";
    }
    out << "</worldbody></mujoco>\n";
    return out.str();
  }
  void AddCorners(int box) {
    const double top_m = box == 0 ? 0.0 : OurPlace(box - 1).z() + 0.5 * kBox_m;
    for (int i = 0; i < 4; ++i) {
      const Vector3d corner(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, -0.5);
      const Vector3d p_G = world_.body(box).motion(0).X_GL * (kBox_m * corner);
      world_.AddContact({.a = {box, 0},
                         .b = {box - 1, 0},
                         .pair = i,
                         .p_G = p_G,
                         .gap_m = p_G.z() - top_m,
                         .material = kHard});
    }
  }

  RigidWorld world_;
  MujocoModel model_;
  MujocoData data_;
};

// v^2 / (2 mu g), less v h / 2, for speeds count from the step's end.
TEST(MujocoContacts, BoxThatIsPushedComesToRestAtTheSamePlace) {
  const double start_m_s = 1.0;
  Boxes boxes(1);
  boxes.Run(0.5);
  const double ours_m = boxes.OurPlace(0).x(), theirs_m = boxes.TheirPlace(0).x();
  boxes.Push(start_m_s);
  boxes.Run(0.5);
  const double wanted_m =
      start_m_s * (start_m_s / (2.0 * kRub * kEarthGravity_m_s2) - 0.5 * kBoxStep_s);
  EXPECT_NEAR(boxes.OurPlace(0).x() - ours_m, wanted_m, 2e-6);
  EXPECT_NEAR(boxes.TheirPlace(0).x() - theirs_m, wanted_m, 2e-5);
}

// A box on a slope below mu. MuJoCo's creeps by (1 - d) / (d b) of the force over the mass at each
// of its four corners, with the impedance d = 0.9 and the rate b = 2 / (0.95 times the time
// constant); ours bends once and holds.
TEST(MujocoContacts, BoxOnASlopeCreepsInMujocoAlone) {
  for (const double share : {0.25, 0.5}) {
    Boxes boxes(1);
    boxes.Run(0.5);
    boxes.SetGravity(kEarthGravity_m_s2 * Vector3d(share * kRub, 0.0, -1.0));
    boxes.Run(0.5);
    const double ours_m = boxes.OurPlace(0).x(), theirs_m = boxes.TheirPlace(0).x();
    boxes.Run(1.0);
    const double rate_1_s = 2.0 / (0.95 * kBoxTimeConstant_s);
    const double creep_m_s = 0.25 * share * kRub * kEarthGravity_m_s2 * (0.1 / 0.9) / rate_1_s;
    EXPECT_LT(std::abs(boxes.OurPlace(0).x() - ours_m), 1e-12) << share;
    EXPECT_NEAR(boxes.TheirPlace(0).x() - theirs_m, creep_m_s, 0.01 * creep_m_s) << share;
  }
}

// Above mu ours slides at g (slope - mu) on the ground. MuJoCo's convex model of friction couples
// sliding with lifting, so its box hops, and no friction holds it in the air.
TEST(MujocoContacts, BoxThatSlidesHopsInMujocoAlone) {
  const double slope = 0.48;
  Boxes boxes(1);
  boxes.Run(0.5);
  boxes.SetGravity(kEarthGravity_m_s2 * Vector3d(slope, 0.0, -1.0));
  const double ours_m = boxes.OurPlace(0).z();
  double hop_m = 0.0;
  for (int i = 0; i < 100; ++i) {
    boxes.Run(0.01);
    EXPECT_NEAR(boxes.OurPlace(0).z(), ours_m, 1e-6);
    hop_m = std::max(hop_m, boxes.TheirPlace(0).z() - 0.5 * kBox_m);
  }
  const double wanted_m_s = kEarthGravity_m_s2 * (slope - kRub);
  EXPECT_NEAR(boxes.OurSpeed(), wanted_m_s, 1e-3 * wanted_m_s);
  EXPECT_NEAR(boxes.TheirSpeed(), wanted_m_s, 0.1 * wanted_m_s);
  EXPECT_GT(hop_m, 1e-3);
  RecordProperty("ours_share", std::to_string(boxes.OurSpeed() / wanted_m_s - 1.0));
  RecordProperty("theirs_share", std::to_string(boxes.TheirSpeed() / wanted_m_s - 1.0));
  RecordProperty("hop_mm", std::to_string(1e3 * hop_m));
}

// Each interface bears the weight above. MuJoCo's stack rocks by micrometres, as its search finds
// 20 to 26 points where boxes touch, from step to step; its forces waver, and are right in the
// mean.
TEST(MujocoContacts, StackBearsItsWeightInBothAndRestsInOurs) {
  constexpr int kCount = 5, kSteps = 1000;
  Boxes boxes(kCount);
  boxes.Run(2.0);
  std::array<Vector3d, kCount> ours, theirs;
  std::array<double, kCount> their_mean_n{};
  for (int i = 0; i < kCount; ++i) {
    ours[static_cast<std::size_t>(i)] = boxes.OurPlace(i);
    theirs[static_cast<std::size_t>(i)] = boxes.TheirPlace(i);
  }
  double our_motion_m = 0.0, their_motion_m = 0.0, our_off = 0.0, their_off = 0.0;
  for (int step = 0; step < kSteps; ++step) {
    boxes.Run(kBoxStep_s);
    for (int i = 0; i < kCount; ++i) {
      const std::size_t box = static_cast<std::size_t>(i);
      const double above_n = (kCount - i) * kBox_kg * kEarthGravity_m_s2;
      our_motion_m = std::max(our_motion_m, (boxes.OurPlace(i) - ours[box]).norm());
      their_motion_m = std::max(their_motion_m, (boxes.TheirPlace(i) - theirs[box]).norm());
      our_off = std::max(our_off, std::abs(boxes.OurForce(i) / above_n - 1.0));
      their_off = std::max(their_off, std::abs(boxes.TheirForce(i) / above_n - 1.0));
      their_mean_n[box] += boxes.TheirForce(i) / kSteps;
    }
  }
  for (int i = 0; i < kCount; ++i) {
    const double above_n = (kCount - i) * kBox_kg * kEarthGravity_m_s2;
    EXPECT_NEAR(their_mean_n[static_cast<std::size_t>(i)], above_n, 0.01 * above_n) << i;
  }
  RecordProperty("our_motion_nm", std::to_string(1e9 * our_motion_m));
  RecordProperty("their_motion_nm", std::to_string(1e9 * their_motion_m));
  RecordProperty("our_off_1e9", std::to_string(1e9 * our_off));
  RecordProperty("their_off", std::to_string(their_off));
  EXPECT_LT(our_motion_m, 1e-9);
  EXPECT_LT(our_off, 1e-6);
  EXPECT_LT(their_motion_m, 1e-4);
  EXPECT_GT(their_motion_m, 1e-7);
}

}  // namespace
}  // namespace dockyard
