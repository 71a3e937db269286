// Soil on a scoop against the laws of plates and walls.
#include "sim/vehicles/scoop_soil.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/parts/scoop_shape.h"
#include "vehicles/stone_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

/// A scoop that goes along a way, its lip's plate upright.
struct Scoop {
  explicit Scoop(const std::string& soil)
      : model(RoverRig::Model("rocky7").arm->scoop),
        laws(SoilNamed(soil)),
        forces(model, true, {laws}),
        ground(LevelGrid(-0.5, 1.0, 1.0, 5e-3)) {
    const auto profile = ScoopProfile(model);
    const Eigen::Vector2d way = profile[3] - profile[2];
    // About +y by this angle the lip's plate points down.
    motion.X_GL.R = RotY(std::atan2(way.x(), -way.y()));
    const Vector3d lip = motion.X_GL.R * Vector3d(profile[3].x(), 0.0, profile[3].y());
    motion.X_GL.p = -lip;  // its lip on the ground
  }
  ScoopLoad Go(const Vector3d& way_G, double speed_m_s = 0.02) {
    ScoopLoad load;
    const double time_s = way_G.norm() / speed_m_s;
    motion.v_GL_G = way_G / time_s;
    for (int i = 0; i < std::lround(1e3 * time_s); ++i) {
      motion.X_GL.p += 1e-3 * motion.v_GL_G;
      load = forces.Step(ground, motion, 1e-3);
    }
    return load;
  }

  ScoopModel model;
  SoilModel laws;
  ScoopSoil forces;
  HeightGrid ground;
  LinkMotion motion;
};

// The lip bears k z^n or what a narrow blade bears, whichever is more; in loose sand under 2 N at
// 10 mm.
TEST(ScoopSoil, ForceUnderTheLipRisesWithItsDepthAsThePressureOfABlade) {
  for (const char* name : {"loose_sand", "compact_gravel"}) {
    Scoop scoop(name);
    const SoilLaws laws = MakeTipLaws(scoop.laws, scoop.model.wall_m, scoop.model.width_m);
    const double area_m2 = scoop.model.wall_m * scoop.model.width_m;
    double before_n = 0.0;
    for (int mm = 2; mm <= 20; mm += 2) {
      const ScoopLoad load = scoop.Go({0.0, 0.0, -2e-3});
      const double z = 1e-3 * mm;
      const double plate_pa = laws.k * std::pow(z, laws.n);
      const double strength_pa = laws.blade_strength_pa + laws.blade_strength_pa_m * z;
      const double wide_pa =
          laws.k * std::pow(z * scoop.model.width_m / scoop.model.wall_m, laws.n);
      const double blade_pa = strength_pa * wide_pa / (strength_pa + wide_pa);
      EXPECT_NEAR(load.lip_n, area_m2 * std::max(plate_pa, blade_pa), 1e-3 * load.lip_n) << mm;
      EXPECT_GT(load.lip_n, before_n);
      EXPECT_NEAR(load.deepest_m, z, 1e-9);
      before_n = load.lip_n;
      if (mm == 10 && std::string(name) == "loose_sand") {
        EXPECT_LT(load.lip_n, 2.0);
      }
    }
  }
}

// A lip that is drawn back is let go, and soil never pulls it.
TEST(ScoopSoil, LetsALipGoWithoutPulling) {
  Scoop scoop("compact_gravel");
  EXPECT_GT(scoop.Go({0.0, 0.0, -5e-3}).lip_n, 5.0);
  EXPECT_EQ(scoop.Go({0.0, 0.0, 1e-3}).lip_n, 0.0);
}

// Pushed flat on, a wall of depth D takes Rankine's passive force with the heap's part:
// w (4.8 gamma D^2 N_phi / 2 + 2 c D sqrt N_phi), over the pieces that are below the ground.
TEST(ScoopSoil, WallsTakeThePassivePressureOfTheSoilBeforeThem) {
  Scoop scoop("loose_sand");
  scoop.Go({0.0, 0.0, -0.025});
  const ScoopLoad load = scoop.Go({0.05, 0.0, 0.0});
  const double phi = scoop.laws.friction_angle_rad, depth_m = 0.025;
  const double root = std::tan(0.25 * kPi + 0.5 * phi);
  const double gamma = scoop.laws.density_kg_m3 * kEarthGravity_m_s2;
  const double passive_n =
      scoop.model.width_m * (0.5 * 4.8 * gamma * depth_m * depth_m * root * root +
                             2.0 * scoop.laws.cohesion_pa * depth_m * root);
  EXPECT_NEAR(-load.force_G.x(), passive_n, 0.15 * passive_n);
}

// A trench as deep as the lip was, the soil of it in the heap before the scoop and beside it, and
// no slope above the friction angle but where the scoop stands.
TEST(ScoopSoil, LeavesATrenchAndAHeapOfTheSameVolume) {
  Scoop scoop("loose_sand");
  scoop.Go({0.0, 0.0, -0.015});
  scoop.Go({0.08, 0.0, 0.0});
  double sum_m = 0.0, low_m = 0.0, high_m = 0.0;
  for (const double height_m : scoop.ground.heights_m) {
    sum_m += height_m;
    low_m = std::min(low_m, height_m);
    high_m = std::max(high_m, height_m);
  }
  EXPECT_NEAR(sum_m, 0.0, 1e-9);
  EXPECT_LT(low_m, -0.008);
  EXPECT_GT(low_m, -0.020);
  EXPECT_GT(high_m, 0.004);
  // Where it went before there is less to push.
  const double first_n = -scoop.Go({0.01, 0.0, 0.0}).force_G.x();
  scoop.Go({0.0, 0.0, 0.05});
  const double tan_phi = std::tan(scoop.laws.friction_angle_rad);
  EXPECT_LT(Steepest(scoop.ground, scoop.motion.X_GL.p.head<2>(), 0.15), tan_phi + 0.003);
  scoop.Go({-0.06, 0.0, 0.0});
  scoop.Go({0.0, 0.0, -0.05});
  EXPECT_LT(-scoop.Go({0.01, 0.0, 0.0}).force_G.x(), 0.75 * first_n);
}

TEST(ScoopSoil, DoesNothingAboveTheGround) {
  Scoop scoop("loose_sand");
  scoop.Go({0.0, 0.0, -0.02});
  const ScoopLoad load = scoop.Go({0.0, 0.0, 0.03});
  EXPECT_EQ(load.force_G.norm(), 0.0);
}

}  // namespace
}  // namespace dockyard
