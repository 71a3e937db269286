// Rovers with links that their files add: a turning mast, a slide, a four-bar and a trailer, each
// against its closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "axel/further_rover.h"
#include "axel/sim/afloat.h"
#include "sim/axel/rover_start.h"

namespace dockyard::axel {
namespace {

constexpr double kG = 9.81;

std::string Limits(const std::string& lower, const std::string& upper) {
  return "<limit lower=\"" + lower + "\" upper=\"" + upper + "\" effort=\"0\" velocity=\"0\"/>";
}

RoverLink Further(int i) { return static_cast<RoverLink>(kOwnLinkCount + i); }

/// The rover on a body so heavy that it stays where it is, its further links with their motors.
class OnRock {
 public:
  explicit OnRock(RoverModel model)
      : afloat_(Heavy(std::move(model)), Station(), kWeightless, Pose3::Translation(50.0, 0, 0),
                0.3) {}

  /// A step under gravity on the further links alone.
  void Step(double step_s, bool running = true) {
    RoverBody& rover = afloat_.rover;
    for (int i = 0; i < further(); ++i) {
      const double mass_kg = LinkOf(afloat_.model, Further(i)).mass_kg;
      rover.AddForce(Further(i), {0, 0, -mass_kg * kG}, rover.CentreOfMass(Further(i)));
    }
    rover.further_drives().Step(running, step_s, rover.tree());
    afloat_.contacts.Step(step_s);
  }
  int Number(const std::string& link) const {
    for (int i = 0; i < further(); ++i) {
      if (LinkOf(afloat_.model, Further(i)).name == link) return i;
    }
    return -1;
  }
  double Angle(int i) const { return afloat_.rover.joint_rad(Further(i)); }
  double Rate(int i) const { return afloat_.rover.joint_rad_s(Further(i)); }
  /// A step with the arm turned at a rate, and where it is.
  void DriveArm(double rate_rad_s, double step_s) {
    afloat_.rover.AddJointTorque(RoverLink::kArm,
                                 500.0 * (rate_rad_s - afloat_.rover.joint_rad_s(RoverLink::kArm)));
    Step(step_s);
  }
  Pose3 ArmPlace() const { return afloat_.rover.motion(RoverLink::kArm).X_GL; }
  Pose3 PlaceOf(int i) const { return afloat_.rover.motion(Further(i)).X_GL; }

 private:
  int further() const { return static_cast<int>(afloat_.model.further.links.size()); }
  static RoverModel Heavy(RoverModel model) {
    model.body.mass_kg = 1e9;
    model.body.I_LCom_L = 1e9 * Eigen::Matrix3d::Identity();
    model.body.p_LoCom_L.setZero();
    return model;
  }

  Afloat afloat_;
};

constexpr double kSteps_s[] = {0.5e-3, 1e-3, 2e-3};

RoverModel WithMast(const std::string& type, const std::string& axis, const std::string& more,
                    const std::string& yaml) {
  return AxelWith(
      "<link name=\"mast\"><inertial><origin xyz=\"0 0 0.4\"/><mass value=\"2\"/>"
      "<inertia ixx=\"0.05\" iyy=\"0.05\" izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
      "</inertial></link>" +
          JointTo("mast", "body", type, "-0.1 0 0.2", axis, more),
      yaml);
}

TEST(TurningMast, FollowsItsMotorsRampAndThenItsRate) {
  for (const double step_s : kSteps_s) {
    OnRock world(WithMast("continuous", "0 0 1", "",
                          "joints:\n  - name: to_mast\n    rate_deg_s: 60\n" + SmallMotor("    ")));
    const double rate = Radians(60.0), ramp_s = rate / 1.0;  // at 1 rad/s^2
    const double seconds = 3.0;
    for (long i = 0; i < std::lround(seconds / step_s); ++i) world.Step(step_s);
    const double expected = rate * (seconds - 0.5 * ramp_s);
    std::printf("mast at %.1f ms: %.3f rad, by the ramp %.3f\n", 1e3 * step_s, world.Angle(0),
                expected);
    EXPECT_NEAR(world.Angle(0), expected, 0.01 * expected);
    EXPECT_NEAR(world.Rate(0), rate, 0.01 * rate);
  }
}

TEST(TurningMast, WithoutAMotorSwingsAsAPendulumAndLosesByFrictionEachHalfSwing) {
  for (const double step_s : kSteps_s) {
    // Hung at 180 deg, let go 10 deg off; friction takes 2 M_f / (m g l) from each half swing.
    OnRock world(WithMast("continuous", "0 1 0", "<dynamics friction=\"0.05\"/>",
                          "joints: [{name: to_mast, start_deg: 190}]\n"));
    const double torque_nm = 2.0 * kG * 0.4, inertia = 0.05 + 2.0 * 0.16;
    std::vector<double> ends_s, ends_rad;
    double last_rate = 0.0;
    for (long i = 1; i < std::lround(5.0 / step_s); ++i) {
      world.Step(step_s);
      if (last_rate * world.Rate(0) < 0.0) {
        ends_s.push_back(step_s *
                         (static_cast<double>(i) - world.Rate(0) / (world.Rate(0) - last_rate)));
        ends_rad.push_back(world.Angle(0) - kPi);
      }
      last_rate = world.Rate(0);
    }
    ASSERT_GT(ends_s.size(), 5u);
    // Coulomb's friction leaves the period as it is; 10 deg lengthen it by a^2 / 16.
    const double period_s = 2.0 * kPi * std::sqrt(inertia / torque_nm) * (1.0 + 0.15 * 0.15 / 16.0);
    const double lost_rad = (std::abs(ends_rad[0]) - std::abs(ends_rad[4])) / 4.0;
    std::printf("pendulum at %.1f ms: half period %.4f s (%.4f), lost %.5f rad (%.5f)\n",
                1e3 * step_s, (ends_s[4] - ends_s[0]) / 4.0, 0.5 * period_s, lost_rad,
                2.0 * 0.05 / torque_nm);
    EXPECT_NEAR((ends_s[4] - ends_s[0]) / 4.0, 0.5 * period_s, 0.01 * 0.5 * period_s);
    EXPECT_NEAR(lost_rad, 2.0 * 0.05 / torque_nm, 0.01 * 2.0 * 0.05 / torque_nm);
  }
}

TEST(TurningMast, HoldsByItsBrakeUntilItMayRun) {
  // 30 deg off the upright its weight turns it with 3.9 N m; the brake bears 6.
  OnRock world(WithMast(
      "continuous", "0 1 0", "",
      "joints:\n  - name: to_mast\n    start_deg: 30\n    rate_deg_s: -40\n" + SmallMotor("    ")));
  for (int i = 0; i < 500; ++i) world.Step(1e-3, false);
  EXPECT_NEAR(world.Angle(0), Radians(30.0), 2e-3);
  for (int i = 0; i < 1000; ++i) world.Step(1e-3);
  EXPECT_LT(world.Angle(0), Radians(20.0));
}

TEST(TurningMast, TurnsBackBeforeStopsThatAreNearerThanItsRampIsLong) {
  // At 1 rad/s^2 it reaches 0.45 rad/s between stops 0.2 rad apart, not its 60 deg/s.
  OnRock world(WithMast("revolute", "0 0 1", Limits("-0.1", "0.1"),
                        "joints:\n  - name: to_mast\n    rate_deg_s: 60\n" + SmallMotor("    ")));
  double low = 0.0, high = 0.0;
  int turns = 0;
  bool up = true;
  for (int i = 0; i < 8000; ++i) {
    world.Step(1e-3);
    low = std::min(low, world.Angle(0));
    high = std::max(high, world.Angle(0));
    if (up != (world.Rate(0) > 0.0)) ++turns, up = !up;
  }
  EXPECT_LT(high, 0.1 + 1e-3);
  EXPECT_GT(low, -0.1 - 1e-3);
  EXPECT_GT(high, 0.08);
  EXPECT_LT(low, -0.08);
  EXPECT_GT(turns, 6);
}

TEST(TurningMast, TurnsBackBeforeItsStops) {
  OnRock world(WithMast("revolute", "0 0 1", Limits("-0.5", "0.8"),
                        "joints:\n  - name: to_mast\n    rate_deg_s: 40\n" + SmallMotor("    ")));
  double low = 0.0, high = 0.0;
  for (int i = 0; i < 12000; ++i) {
    world.Step(1e-3);
    low = std::min(low, world.Angle(0));
    high = std::max(high, world.Angle(0));
  }
  EXPECT_LT(high, 0.8);
  EXPECT_GT(high, 0.78);
  EXPECT_GT(low, -0.5);
  EXPECT_LT(low, -0.48);
}

/// A box of 3 kg on a rail along x and down by 30 deg.
RoverModel WithSlide(const std::string& friction_n, const std::string& keys) {
  return AxelWith(SolidLink("sledge", 3.0, {0.1, 0.1, 0.1}, false) +
                      JointTo("sledge", "body", "prismatic", "0 0 0.5", "0.8660254037844386 0 -0.5",
                              Limits("0", "1.5") + "<dynamics friction=\"" + friction_n + "\"/>"),
                  keys);
}

TEST(Slide, FallsAlongItsRailByWhatFrictionLeavesAndRestsOnItsStop) {
  for (const double step_s : kSteps_s) {
    OnRock world(WithSlide("6",
                           "joints: [{name: to_sledge, stop: {stiffness_n_per_m: 2e4, "
                           "damping_ns_per_m: 300}}]\n"));
    const double a = kG * 0.5 - 6.0 / 3.0, seconds = 0.8;
    const long steps = std::lround(seconds / step_s);
    for (long i = 0; i < steps; ++i) world.Step(step_s);
    const double expected = 0.5 * a * seconds * seconds;
    std::printf("slide at %.1f ms: %.4f m (%.4f)\n", 1e3 * step_s, world.Angle(0), expected);
    EXPECT_NEAR(world.Angle(0), expected, 0.01 * expected);
    for (long i = 0; i < std::lround(3.0 / step_s); ++i) world.Step(step_s);
    // What the stop bears is between the weight's part with friction against it and for it.
    EXPECT_GT(world.Angle(0), 1.5 + (3.0 * kG * 0.5 - 6.0) / 2e4 - 1e-6);
    EXPECT_LT(world.Angle(0), 1.5 + (3.0 * kG * 0.5 + 6.0) / 2e4 + 1e-6);
  }
}

TEST(Slide, OfAScrewRunsAtItsRateUnderLoadAndHangsOnItsSpring) {
  OnRock driven(WithSlide("0",
                          "joints:\n  - name: to_sledge\n    rate_m_s: 0.05\n"
                          "    lead_m_per_turn: 0.2\n" +
                              SmallMotor("    ")));
  for (int i = 0; i < 4000; ++i) driven.Step(1e-3);
  const double ramp_s = 0.05 / (0.2 / (2.0 * kPi));  // its motor's, at 1 rad/s^2
  EXPECT_NEAR(driven.Angle(0), 0.05 * (4.0 - 0.5 * ramp_s), 0.01 * 0.05 * 4.0);
  for (const double step_s : kSteps_s) {
    OnRock sprung(WithSlide("0",
                            "joints: [{name: to_sledge, spring: {stiffness_n_per_m: 200, "
                            "rest_m: 0.5}, start_m: 0.5}]\n"));
    // It swings about where the spring bears its weight's part.
    double sum_m = 0.0;
    const double period_s = 2.0 * kPi * std::sqrt(3.0 / 200.0);
    const long steps = std::lround(4.0 * period_s / step_s);
    for (long i = 0; i < steps; ++i) {
      sprung.Step(step_s);
      sum_m += sprung.Angle(0) / static_cast<double>(steps);
    }
    const double sag_m = 3.0 * kG * 0.5 / 200.0;
    EXPECT_NEAR(sum_m, 0.5 + sag_m, 0.01 * sag_m);
  }
}

/// A four-bar in the plane y = 0: crank a from the body's A, coupler b, rocker c to the body's D.
struct FourBar {
  double a = 0.10, b = 0.35, c = 0.25, d = 0.30;

  /// Of the rocker about D, from the line A to D, with the crank at this angle (Freudenstein 1955).
  double Rocker(double crank_rad) const {
    const double x = d - a * std::cos(crank_rad), z = -a * std::sin(crank_rad);
    const double diagonal = std::hypot(x, z);
    const double at_d = std::acos((diagonal * diagonal + c * c - b * b) / (2.0 * diagonal * c));
    return std::atan2(z, x) + kPi - at_d;
  }
};

TEST(FourBar, RockerFollowsItsCrankByFreudensteinsEquation) {
  const FourBar bars;
  // Drawn with the crank along the line of the pivots: all angles 0. x is ahead, and a positive
  // angle about -y lifts the far end.
  const double rocker = bars.Rocker(0.0);
  const Eigen::Vector2d D(bars.d, 0.0);
  const Eigen::Vector2d end = D + bars.c * Eigen::Vector2d(std::cos(rocker), std::sin(rocker));
  const double coupler = std::atan2(end.y(), end.x() - bars.a);
  const auto bar = [](const std::string& name, double length_m) {
    return "<link name=\"" + name + "\"><inertial><origin xyz=\"" + NumberText(0.5 * length_m) +
           " 0 0\"/><mass value=\"0.5\"/><inertia ixx=\"0.001\" iyy=\"0.004\" izz=\"0.004\" "
           "ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>";
  };
  const auto joint = [](const std::string& child, const std::string& parent, double x_m, double z_m,
                        double turned_rad) {
    return "<joint name=\"to_" + child + "\" type=\"continuous\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><origin xyz=\"" + NumberText(x_m) + " 0 " +
           NumberText(z_m) + "\" rpy=\"0 " + NumberText(-turned_rad) +
           " 0\"/><axis xyz=\"0 -1 0\"/></joint>";
  };
  const std::string urdf = bar("crank", bars.a) + bar("coupler", bars.b) + bar("rocker", bars.c) +
                           joint("crank", "body", 0.0, 0.6, 0.0) +
                           joint("coupler", "crank", bars.a, 0.0, coupler) +
                           joint("rocker", "body", bars.d, 0.6, rocker);
  const std::string yaml = "joints:\n  - name: to_crank\n    rate_deg_s: 90\n" +
                           SmallMotor("    ") + "pins: [{link: coupler, to: rocker, at_m: [" +
                           NumberText(bars.b) + ", 0, 0]}]\n";
  for (const double step_s : kSteps_s) {
    OnRock world(AxelWith(urdf, yaml));
    double worst_rad = 0.0, least = 0.0, most = 0.0;
    const int of_crank = world.Number("crank"), of_rocker = world.Number("rocker");
    // Two turns and more.
    for (long i = 0; i < std::lround(10.0 / step_s); ++i) {
      world.Step(step_s);
      const Eigen::Vector3d along = world.PlaceOf(of_rocker).R.col(0),
                            crank = world.PlaceOf(of_crank).R.col(0);
      const double is = std::atan2(along.z(), along.x());
      const double expected = bars.Rocker(std::atan2(crank.z(), crank.x()));
      worst_rad = std::max(worst_rad, std::abs(std::remainder(is - expected, 2.0 * kPi)));
      least = std::min(least, is - rocker);
      most = std::max(most, is - rocker);
    }
    std::printf("four-bar at %.1f ms: rocker swings %.2f deg, off by %.4f deg at most\n",
                1e3 * step_s, Degrees(most - least), Degrees(worst_rad));
    EXPECT_GT(world.Angle(of_crank), 4.0 * kPi);
    EXPECT_GT(most - least, Radians(40.0));
    EXPECT_LT(worst_rad, 0.01 * (most - least));
  }
}

TEST(FollowingJoint, TurnsByItsRatioAndItsOffset) {
  OnRock world(AxelWith(
      SolidLink("big", 2.0, {0.2, 0.2, 0.2}, false) +
          SolidLink("small", 1.0, {0.1, 0.1, 0.1}, false) +
          JointTo("big", "body", "continuous", "0 0 0.5", "0 0 1") +
          JointTo("small", "body", "revolute", "0.2 0 0.5", "0 0 1",
                  Limits("-9", "9") + "<mimic joint=\"to_big\" multiplier=\"-2\" offset=\"0.3\"/>"),
      "joints:\n  - name: to_big\n    rate_deg_s: 30\n" + SmallMotor("    ")));
  EXPECT_NEAR(world.Angle(1), 0.3, 1e-12);
  for (int i = 0; i < 3000; ++i) world.Step(1e-3);
  EXPECT_GT(world.Angle(0), 1.0);
  EXPECT_NEAR(world.Angle(1), 0.3 - 2.0 * world.Angle(0), 1e-9);
}

/// A trailer of two wheels, its axle 0.9 m behind a hitch in the middle of the rover's axle. The
/// hitch turns in pitch, as the body does over the wheels, and in yaw.
RoverModel WithTrailer(double yaw_deg) {
  const auto link = [](const std::string& name, double mass_kg, const std::string& com,
                       const std::string& moments, const std::string& shape = "") {
    return "<link name=\"" + name + "\"><inertial><origin xyz=\"" + com + "\"/><mass value=\"" +
           NumberText(mass_kg) + "\"/><inertia " + moments +
           " ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>" + shape + "</link>\n";
  };
  const std::string tyre =
      "<collision><origin rpy=\"1.5707963267948966 0 0\"/><geometry><cylinder radius=\"0.1\" "
      "length=\"0.04\"/></geometry></collision>";
  const std::string of_wheel = "ixx=\"0.002\" iyy=\"0.003\" izz=\"0.002\"";
  return AxelWith(
      link("hitch", 0.2, "0 0 0", "ixx=\"1e-4\" iyy=\"1e-4\" izz=\"1e-4\"") +
          link("trailer", 2.0, "-0.8 0 -0.1", "ixx=\"0.02\" iyy=\"0.03\" izz=\"0.04\"") +
          link("tyre_left", 0.5, "0 0 0", of_wheel, tyre) +
          link("tyre_right", 0.5, "0 0 0", of_wheel, tyre) +
          JointTo("hitch", "body", "continuous", "0 0 0", "0 1 0") +
          JointTo("trailer", "hitch", "continuous", "0 0 0", "0 0 1") +
          JointTo("tyre_left", "trailer", "continuous", "-0.9 0.25 -0.2", "0 1 0") +
          JointTo("tyre_right", "trailer", "continuous", "-0.9 -0.25 -0.2", "0 1 0"),
      "joints: [{name: to_trailer, start_deg: " + NumberText(yaw_deg) + "}]\n");
}

TEST(Trailer, SwingsInBehindItsHitchAlongATractrix) {
  WorldSetup setup = TestSetup(CompactGravel(), {6.0, 0.0, kPi});
  setup.rover = WithTrailer(40.0);
  const auto number = [&](const std::string& link) {
    std::size_t i = 0;
    while (setup.rover.further.links.at(i).link.name != link) ++i;
    return i;
  };
  const std::size_t trailer = number("trailer"), left = number("tyre_left"),
                    right = number("tyre_right");
  World world(setup);
  struct Towed {
    Eigen::Vector2d hitch;
    double heading = 0.0, length_m = 0.0;
  };
  const auto now = [&]() -> Towed {
    const std::vector<MovingLink> links = world.truth().further;
    const Eigen::Vector2d hitch = links[trailer].X_WL.p.head<2>();
    const Eigen::Vector2d axle = 0.5 * (links[left].X_WL.p + links[right].X_WL.p).head<2>() - hitch;
    return {hitch, std::atan2(-axle.y(), -axle.x()), axle.norm()};
  };
  Play(world, Drive(0.3, 0.0), 3.0);
  Towed last = now();
  // A tractrix for each short stretch of the hitch's path: tan(a / 2) falls by exp(-s / L), where
  // a is the trailer's angle to the path.
  double heading = last.heading;
  const double at_first = heading;
  for (int i = 0; i < 60; ++i) {
    Play(world, Drive(0.3, 0.0), 0.5);
    const Towed is = now();
    const Eigen::Vector2d path = is.hitch - last.hitch;
    const double along = std::atan2(path.y(), path.x());
    const double angle = std::remainder(heading - along, 2.0 * kPi);
    heading = along + 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(-path.norm() / is.length_m));
    last = is;
  }
  const double turned = std::remainder(last.heading - at_first, 2.0 * kPi);
  const double expected = std::remainder(heading - at_first, 2.0 * kPi);
  std::printf("trailer: turned by %.2f deg, by the tractrix %.2f deg\n", Degrees(turned),
              Degrees(expected));
  EXPECT_GT(std::abs(expected), Radians(25.0));
  EXPECT_NEAR(turned, expected, 0.01 * std::abs(expected));
}

/// A flap of 1 kg above the arm, its hinge along y and 0.3 m ahead, which rubs and so keeps its
/// angle. At 0 it hangs down.
RoverModel WithFlap(const std::string& z_m, const std::string& start_deg) {
  return AxelWith(
      "<link name=\"flap\"><inertial><origin xyz=\"0 0 -0.15\"/><mass value=\"1\"/>"
      "<inertia ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
      "</inertial><collision><origin xyz=\"0 0 -0.15\"/><geometry>"
      "<box size=\"0.02 0.1 0.3\"/></geometry></collision></link>" +
          JointTo("flap", "body", "continuous", "0.3 0 " + z_m, "0 1 0",
                  "<dynamics friction=\"3\"/>"),
      "joints: [{name: to_flap, start_deg: " + start_deg + "}]\n");
}

TEST(FurtherLink, ThatTheArmMeetsIsPushedAndNotEntered) {
  // The arm, of a radius of 22.5 mm, comes up at 0.2 rad/s and turns the flap out of its path.
  const RoverModel model = WithFlap("0.25", "-40");
  ASSERT_EQ(StartsInItself(model, 0.3), "");
  OnRock world(model);
  double nearest_m = 1.0;
  for (int i = 0; i < 4000; ++i) {
    world.DriveArm(-0.2, 1e-3);
    const Pose3 X_AF = Inverse(world.ArmPlace()) * world.PlaceOf(0);
    // Of the edges of the flap's lower end, above the arm's shaft.
    for (const double x : {-0.01, 0.01}) {
      const Eigen::Vector3d edge_A = X_AF * Eigen::Vector3d(x, 0.0, -0.3);
      nearest_m = std::min(nearest_m, edge_A.z() - 0.0225);
    }
  }
  std::printf("flap: turned to %.1f deg, %.2f mm from the arm where it was nearest\n",
              Degrees(world.Angle(0)), 1e3 * nearest_m);
  EXPECT_LT(world.Angle(0), Radians(-70.0));
  EXPECT_NEAR(nearest_m, 0.0, 1e-3);
}

TEST(FurtherLink, ThatStartsInTheGroundOrBeyondItsLimitsIsNamed) {
  WorldSetup setup = TestSetup(CompactGravel(), {6.0, 0.0, kPi});
  EXPECT_EQ(StartsWrong(setup), "");
  // A plough whose lower side is 0.35 m below the axle, which is 0.3 m above the ground.
  const std::string plough = SolidLink("plough", 1.0, {0.1, 0.1, 0.1});
  setup.rover =
      AxelWith(plough + JointTo("plough", "body", "continuous", "-0.5 0 -0.3", "0 0 1"), "");
  EXPECT_EQ(StartsWrong(setup), "'plough' starts in the ground");
  setup.rover =
      AxelWith(plough + JointTo("plough", "body", "continuous", "-0.5 0 -0.2", "0 0 1"), "");
  EXPECT_EQ(StartsWrong(setup), "");
  // It starts 9 rad from the arm, which turns by less than 4 rad from the front.
  setup.rover =
      AxelWith(plough + JointTo("plough", "body", "revolute", "-0.5 0 0.3", "0 0 1",
                                Limits("-1", "1") + "<mimic joint=\"arm_joint\" offset=\"9\"/>"),
               "");
  EXPECT_EQ(StartsWrong(setup), "'plough' starts beyond its joint's limits");
}

TEST(FurtherLink, ThatStartsInAnotherIsNamed) {
  EXPECT_EQ(StartsInItself(Axel(), 0.3), "");
  // Lower, it hangs in the arm.
  const std::string links = StartsInItself(WithFlap("0.1", "0"), 0.0);
  EXPECT_TRUE(links == "'arm' and 'flap'" || links == "'flap' and 'arm'") << links;
}

}  // namespace
}  // namespace dockyard::axel
