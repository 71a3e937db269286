// A block that runs onto two spring pins across a floor, against MuJoCo's. There each pin is a
// plunger of 5 g on a slide with a spring. Its contacts are soft by a time constant of 0.2 ms, so
// its tips sink in by some 10 um, and its plungers take 0.2 % of the block's momentum.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "sim/vehicles/spring_pins.h"
#include "support/mujoco_model.h"
#include "vehicles/tyre_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kOurs_s = 1e-3, kTheirs_s = 1e-4;
constexpr double kBlock_kg = 6.0, kSize_m = 0.3, kHigh_m = 0.15, kRub = 0.5, kSpeed_m_s = 0.15;
constexpr double kApart_m = 0.022;  // of each pin from the middle

SpringPin PinAt(double y_m) {
  return {.contact = "charge",
          .pole = "plus",
          .p_L = {0.0, y_m, kHigh_m},
          .stroke_m = 0.004,
          .first_n = 0.8,
          .last_n = 2.0};
}
double Slope_n_per_m() { return (PinAt(0.0).last_n - PinAt(0.0).first_n) / PinAt(0.0).stroke_m; }

/// How far the block has gone, and what each pin bears.
struct Reading {
  double gone_m = 0.0;
  std::array<double, 2> force_n{};
};

class OurBlock {
 public:
  OurBlock() : ground_(LevelFloor(kRub)), world_(kDown), floor_(world_, ground_) {
    const int mount = world_.Add(TreeBody({Mount()}, {}, Pose3{}, kMounted));
    block_ = world_.Add(FreeBody(BoxModel(kBlock_kg, Vector3d::Constant(kSize_m)),
                                 Pose3::Translation(0.5 * kSize_m + 1e-4, 0.0, 0.5 * kSize_m)));
    floor_.Add({.at = {block_, 0},
                .body_L = BoxHull({0, 0, 0}, Vector3d::Constant(kSize_m)),
                .stiffness_n_per_m = 1e6,
                .damping_ns_per_m = 1e3});
    PinSide of_block{.body = block_, .places = {0}};
    of_block.solids.push_back({0, BoxHull({0, 0, 0}, Vector3d::Constant(kSize_m))});
    pins_ = SpringPins({.body = mount, .places = {0}, .pins = {PinAt(-kApart_m), PinAt(kApart_m)}},
                       of_block);
  }
  void Start() { SetSpeeds(world_.body(block_), {-kSpeed_m_s}); }
  Reading Run(double seconds) {
    for (long i = 0; i < std::lround(seconds / kOurs_s); ++i) {
      floor_.AddContacts(kOurs_s);
      pins_.AddContacts(world_);
      world_.Step(kOurs_s);
      pins_.TakeForces(world_, kOurs_s);
    }
    return {0.5 * kSize_m - world_.body(block_).motion(0).X_GL.p.x(),
            {pins_.states()[0].force_n, pins_.states()[1].force_n}};
  }

 private:
  FirmGround ground_;
  RigidWorld world_;
  FloorContacts floor_;
  SpringPins pins_;
  int block_ = 0;
};

class TheirBlock {
 public:
  TheirBlock() : model_(LoadMujoco(Mjcf())), data_(mj_makeData(model_.get())) {}
  void Start() { data_->qvel[0] = -kSpeed_m_s; }
  Reading Run(double seconds) {
    for (long i = 0; i < std::lround(seconds / kTheirs_s); ++i) mj_step(model_.get(), data_.get());
    // The plungers' joints come after the six of the block.
    const auto force = [&](int pin) {
      return data_->qpos[7 + pin] > 0.0
                 ? PinAt(0.0).first_n + Slope_n_per_m() * data_->qpos[7 + pin] +
                       PinAt(0.0).damping_ns_per_m * data_->qvel[6 + pin]
                 : 0.0;
    };
    return {0.5 * kSize_m - data_->qpos[0], {force(0), force(1)}};
  }

 private:
  static std::string Mjcf() {
    constexpr double kTip_m = 0.002, kPlunger_kg = 5e-3;
    const SpringPin pin = PinAt(0.0);
    std::ostringstream out;
    out.precision(17);
    out << "<mujoco><option timestep=\"" << kTheirs_s << "\" gravity=\"0 0 " << -kG_m_s2
        << "\" cone=\"elliptic\" tolerance=\"1e-12\" iterations=\"200\"/>\n<default><geom "
           "condim=\"3\" solref=\""
        << 2.0 * kTheirs_s << " 1\"/></default>\n<worldbody><geom type=\"plane\" size=\"0 0 1\" "
        << "friction=\"" << kRub << " 0 0\"/>\n<body pos=\"" << 0.5 * kSize_m + 1e-4 << " 0 "
        << 0.5 * kSize_m << "\"><freejoint/><geom type=\"box\" mass=\"" << kBlock_kg
        << "\" friction=\"0.2 0 0\" size=\"" << MjcfNumbers(Vector3d::Constant(0.5 * kSize_m))
        << "\"/></body>\n";
    for (const double y_m : {-kApart_m, kApart_m}) {
      out << "<body pos=\"" << -kTip_m << ' ' << y_m << ' ' << kHigh_m
          << "\"><joint type=\"slide\" axis=\"-1 0 0\" limited=\"true\" range=\"0 0.01\" "
             "solreflimit=\""
          << 2.0 * kTheirs_s << " 1\" stiffness=\"" << Slope_n_per_m() << "\" springref=\""
          << -pin.first_n / Slope_n_per_m() << "\" damping=\"" << pin.damping_ns_per_m
          << "\"/><geom type=\"sphere\" mass=\"" << kPlunger_kg << "\" friction=\"" << pin.friction
          << " 0 0\" size=\"" << kTip_m << "\"/></body>\n";
    }
    out << "</worldbody></mujoco>\n";
    return out.str();
  }

  MujocoModel model_;
  MujocoData data_;
};

/// Where Coulomb's friction and two pins' lines of force stop it, from the pins' tips.
double WantedRest_m() {
  const SpringPin pin = PinAt(0.0);
  constexpr double kFine_s = 1e-6;
  double x_m = -1e-4, v_m_s = kSpeed_m_s;
  while (v_m_s > 0.0) {
    double force_n = kRub * kBlock_kg * kG_m_s2;
    if (x_m > 0.0) force_n += 2.0 * (PinForce(pin, x_m) + pin.damping_ns_per_m * v_m_s);
    v_m_s -= force_n / kBlock_kg * kFine_s;
    x_m += v_m_s * kFine_s;
  }
  return x_m;
}

TEST(PinsMujoco, BlockComesToRestOnTwoPinsAtTheSamePlace) {
  OurBlock ours;
  TheirBlock theirs;
  ours.Run(0.3);
  theirs.Run(0.3);
  ours.Start();
  theirs.Start();
  double worst_n = 0.0;
  for (int i = 0; i < 30; ++i) {
    const Reading our = ours.Run(kOurs_s), their = theirs.Run(kOurs_s);
    // The force over the stroke, where both have begun to press.
    if (std::min(our.gone_m, their.gone_m) < 2e-4) continue;
    const double deeper_n = Slope_n_per_m() * (our.gone_m - their.gone_m);
    for (std::size_t pin = 0; pin < 2; ++pin) {
      worst_n = std::max(worst_n, std::abs(our.force_n[pin] - their.force_n[pin] - deeper_n));
    }
  }
  const Reading our = ours.Run(0.2), their = theirs.Run(0.2);
  const double wanted_m = WantedRest_m();
  RecordProperty("rest_mm", std::to_string(1e3 * wanted_m));
  RecordProperty("ours_um_off", std::to_string(1e6 * (our.gone_m - wanted_m)));
  RecordProperty("theirs_um_off", std::to_string(1e6 * (their.gone_m - wanted_m)));
  RecordProperty("force_apart_mn", std::to_string(1e3 * worst_n));
  // Speeds count from a step's end, v h / 2; and friction, which bends by 7 um under its limit,
  // gives that back as it comes to rest.
  EXPECT_NEAR(our.gone_m, wanted_m - 0.5 * kSpeed_m_s * kOurs_s, 1.5e-5);
  EXPECT_NEAR(their.gone_m, wanted_m, 5e-5);
  for (std::size_t pin = 0; pin < 2; ++pin) {
    EXPECT_NEAR(our.force_n[pin], PinForce(PinAt(0.0), our.gone_m), 5e-3);
    EXPECT_NEAR(our.force_n[pin], their.force_n[pin], 0.05);
  }
}

TEST(PinsMujoco, FrictionHoldsTheBlockAgainstThePins) {
  OurBlock ours;
  TheirBlock theirs;
  ours.Run(0.3);
  theirs.Run(0.3);
  ours.Start();
  theirs.Start();
  const double ours_m = ours.Run(0.3).gone_m, theirs_m = theirs.Run(0.3).gone_m;
  const double our_creep_m = ours.Run(1.0).gone_m - ours_m;
  const double their_creep_m = theirs.Run(1.0).gone_m - theirs_m;
  RecordProperty("our_creep_nm", std::to_string(1e9 * our_creep_m));
  RecordProperty("their_creep_nm", std::to_string(1e9 * their_creep_m));
  EXPECT_LT(std::abs(our_creep_m), 1e-7);
  EXPECT_LT(their_creep_m, 0.0);  // its friction is a velocity that decays: it creeps out
  EXPECT_GT(their_creep_m, -2e-5);
}

}  // namespace
}  // namespace dockyard
