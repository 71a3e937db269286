// Rover and station on a slope, against the statics and dynamics of bodies on an incline.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "axel/sim/product.h"
#include "axel/sim/scenarios.h"
#include "models/parts/gravity.h"
#include "models/read/config_error.h"
#include "sim/drives/imu.h"

namespace dockyard::axel {
namespace {

constexpr double kG = kEarthGravity_m_s2;

WorldSetup Tilted(const SoilModel& soil, double slope_deg, double downhill_deg,
                  const Pose2& X_DR = {3.0, 0.0, kPi}) {
  WorldSetup setup = TestSetup(soil, X_DR);
  setup.slope = {Radians(slope_deg), Radians(downhill_deg)};
  return setup;
}

TEST(TiltedSite, GravityPointsDownInTheWorldWhateverTheSiteDoes) {
  for (const double heading : {0.0, 1.3, -2.9}) {
    for (const double downhill : {0.0, 0.7, -2.0}) {
      const Slope slope{Radians(17.0), downhill};
      const Pose3 X_WG = SiteInWorld({4.0, -2.0, heading}, slope);
      EXPECT_LT((X_WG.R * GravityInSite(slope) - Eigen::Vector3d(0, 0, -kG)).norm(), 1e-12);
      // The way down, drawn in the site, sinks by sin(slope) a metre towards that heading.
      const Eigen::Vector3d down =
          X_WG.R * Eigen::Vector3d(std::cos(downhill), std::sin(downhill), 0.0);
      EXPECT_NEAR(down.z(), -std::sin(slope.angle_rad), 1e-12);
      EXPECT_NEAR(WrapPi(std::atan2(down.y(), down.x()) - heading - downhill), 0.0, 1e-12);
    }
  }
}

TEST(TiltedSite, InertialUnitReadsTheSlopeAsPitchRollAndPull) {
  const double angle = Radians(12.0);
  for (const double turned : {0.0, 90.0, 180.0, -90.0}) {  // of the rover against the way down
    const Slope slope{angle, 0.6};
    const LinkMotion body{{RotZ(0.6 + Radians(turned)), {0, 0, 0}}, {0, 0, 0}, {0, 0, 0}};
    ImuAverage imu({.p_RI = {-0.05, 0.0, 0.05}}, GravityInSite(slope));
    imu.Start(body);
    for (int i = 0; i < 10; ++i) imu.Add(body, 1e-3);
    const ImuSample sample = imu.Take(body, SiteInWorld({1.0, 2.0, 0.4}, slope)).sample;
    const double c = std::cos(Radians(turned)), s = std::sin(Radians(turned));
    // Nose down is positive; facing 90 deg left of the way down, its right side is the low one.
    EXPECT_NEAR(std::sin(sample.pitch_rad), c * std::sin(angle), 1e-9);
    EXPECT_NEAR(std::tan(sample.roll_rad), s * std::tan(angle), 1e-9);
    EXPECT_NEAR(sample.specific_force_R.x(), -kG * std::sin(angle) * c, 1e-9);
    EXPECT_NEAR(sample.specific_force_R.y(), kG * std::sin(angle) * s, 1e-9);
    EXPECT_NEAR(sample.specific_force_R.z(), kG * std::cos(angle), 1e-9);
  }
}

// How far the station slides down in each of two spells after the start.
std::array<double, 2> Slides(double friction, double slope_deg, double seconds) {
  WorldSetup setup = Tilted(CompactGravel(), slope_deg, 0.0, {6.0, 0.0, kPi});
  setup.station.foot_friction = friction;
  setup.slack_start_m = 8.0;  // the tether pulls at nothing, wherever the rover rolls
  World world(setup);
  const Pose3 X_GW = Inverse(SiteInWorld({}, setup.slope));
  std::array<double, 3> x;
  for (double& at : x) {
    at = (X_GW * world.truth().X_WS).p.x();
    Play(world, AllBraked(), seconds);
  }
  return {x[1] - x[0], x[2] - x[1]};
}

TEST(TiltedSite, StationSlidesAboveTheAngleOfFrictionAndStandsBelow) {
  const double friction = 0.4;  // holds 21.8 deg
  EXPECT_LT(std::abs(Slides(friction, 20.0, 3.0)[1]), 1e-4);
  EXPECT_LT(std::abs(Slides(friction, 21.3, 3.0)[1]), 1e-4);
  // A block: a = g (sin - mu cos); one spell's way is longer by a t^2 than the one's before.
  for (const double slope_deg : {23.0, 26.0}) {
    const double slope = Radians(slope_deg), seconds = 0.4;
    const double a = kG * (std::sin(slope) - friction * std::cos(slope));
    const std::array<double, 2> way = Slides(friction, slope_deg, seconds);
    EXPECT_NEAR((way[1] - way[0]) / (seconds * seconds), a, 0.03 * a);
  }
}

TEST(TiltedSite, WheelsShareTheLoadAcrossTheSlopeAsLeversSay) {
  // About the line on the ground between the wheels: (N_low - N_high) track / 2 = W sin(a) h. The
  // arm's tip lies on that line.
  const double slope = Radians(15.0);
  World world(Tilted(CompactGravel(), 15.0, 90.0));  // its way down is the rover's right
  const Truth truth = world.truth();
  const RoverModel model = Axel();
  const Pose3 X_GW = Inverse(SiteInWorld({}, {slope, Radians(90.0)}));
  const Pose3 X_GR = X_GW * truth.X_WR, X_GA = X_GW * truth.X_WA;
  double height = 0.0;
  height += model.body.mass_kg * (X_GR * model.body.p_LoCom_L).z();
  height += model.arm.mass_kg * (X_GA * model.arm.p_LoCom_L).z();
  height += (model.left_wheel.mass_kg + model.right_wheel.mass_kg) * X_GR.p.z();
  height /= model.mass_kg();
  const double weight = kG * model.mass_kg();
  // The lower wheel sinks in deeper, so the rover leans a little more than the ground.
  const double leans = std::abs(ToRollPitchYaw(truth.X_WR.R).roll);
  const double per_height = 2.0 * weight * std::sin(leans) / model.track_m();
  const double more = truth.right_wheel_load_n - truth.left_wheel_load_n;
  // Soil holds the wheels sideways between its surface and as deep as they sink.
  const double sunk = std::max(truth.left_sinkage_m, truth.right_sinkage_m);
  std::printf("%.1f N more on the lower wheel, sunk %.1f and %.1f mm; %.1f N by levers\n", more,
              1e3 * truth.left_sinkage_m, 1e3 * truth.right_sinkage_m, per_height * height);
  EXPECT_GT(more, 0.98 * per_height * height);
  EXPECT_LT(more, 1.02 * per_height * (height + sunk));
  const double carried =
      truth.left_wheel_load_n + truth.right_wheel_load_n + truth.tip_ground_force_n;
  EXPECT_NEAR(carried, weight * std::cos(slope), 0.02 * weight);
  EXPECT_NEAR(leans, slope + (truth.right_sinkage_m - truth.left_sinkage_m) / model.track_m(),
              Radians(0.2));
}

TEST(TiltedSite, TetherHoldsAFreeRollingRoverByItsWeightAlongTheSlope) {
  for (const double slope_deg : {10.0, 20.0}) {
    // Uphill of the rover, the station is too heavy to move: the tether alone is in question.
    WorldSetup setup = Tilted(CompactGravel(), slope_deg, 0.0);
    setup.station.module.mass_kg = 500.0;
    setup.station.foot_friction = 2.0;
    World world(setup);
    MotorCommands free = AllBraked();
    At(free, Motor::kLeftWheel) = At(free, Motor::kRightWheel) = FreeWheel();
    Play(world, free, 20.0);
    const Truth truth = world.truth();
    EXPECT_LT(truth.v_WR_W.norm(), 1e-3);
    const Pose3 X_GW = Inverse(SiteInWorld({}, setup.slope));
    const Eigen::Vector3d way = X_GW.R * (truth.tether_W[1] - truth.tether_W[0]).normalized();
    const double weight = kG * Axel().mass_kg();
    const double pull = truth.tether_tension_n * -way.x();
    // Gears resist by their friction over the wheels' radius, the arm's tip by its share of weight,
    // the soil by a few per cent of it: coming to rest, any part of that may hold the rover, from
    // rolling down or, when the tether has swung it up, from rolling up.
    const double gears = 2.0 * Axel().motors[0].gear_friction_nm / 0.28;
    const double tip = 0.4 * truth.tip_ground_force_n;
    EXPECT_LT(pull, weight * (std::sin(Radians(slope_deg)) + 0.06) + gears + tip);
    EXPECT_GT(pull, weight * (std::sin(Radians(slope_deg)) - 0.06) - gears - tip);
    std::printf("%.0f deg: %.1f N of %.1f N (tip %.1f N on the ground, gears %.1f N)\n", slope_deg,
                pull, weight * std::sin(Radians(slope_deg)), truth.tip_ground_force_n, gears);
  }
}

// Without the tether, its braked wheels and body roll downhill as one, over the arm.
TEST(TiltedSite, RoverBelowTheStationHangsWhereItIsPut) {
  for (const double slope_deg : {10.0, 15.0, 20.0}) {
    WorldSetup setup = Tilted(CompactGravel(), slope_deg, 0.0);
    setup.station.module.mass_kg = 500.0;
    setup.station.foot_friction = 2.0;
    const World world(setup);
    const Pose2 X_DR = ToGround(world.truth().X_DR);
    EXPECT_NEAR(X_DR.x, 3.0, 0.03) << slope_deg;
    EXPECT_NEAR(WrapPi(X_DR.heading - kPi), 0.0, Radians(2.0)) << slope_deg;
    // At rest it hangs by no more than its weight along the slope.
    EXPECT_GT(world.truth().tether_tension_n, 0.0) << slope_deg;
  }
}

TEST(TiltedSite, LevelIsTheSameBitsWhateverTheWayDown) {
  World level(Tilted(LooseSand(), 0.0, 0.0)), turned(Tilted(LooseSand(), 0.0, 70.0));
  Play(level, Drive(0.2, 45.0), 1.0);
  Play(turned, Drive(0.2, 45.0), 1.0);
  EXPECT_EQ(level.StateHash(1), turned.StateHash(1));
}

TEST(TiltedSite, RefusesASlopeThatTheStationsFeetDoNotHold) {
  const auto check = [](const char* slope, const char* feet) {
    const Scenario scenario = TypicalScenario({slope, feet});
    Systems().front().check(scenario);
  };
  EXPECT_NO_THROW(check("yard.slope_deg=20", "changes.station.feet.friction=0.4"));
  try {
    check("yard.slope_deg=20", "changes.station.feet.friction=0.35");
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "--set yard.slope_deg=20: yard: expected a slope that the station's feet hold, "
                 "below 19.3 deg at their friction of 0.35, found 20.0 deg");
  }
}

}  // namespace
}  // namespace dockyard::axel
