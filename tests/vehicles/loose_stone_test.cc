// Stones by themselves: mass, flight, rest and sinking, against closed forms.
#include "sim/vehicles/loose_stone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "models/parts/scoop_shape.h"
#include "sim/rigid/solid_mass.h"
#include "vehicles/stone_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

TEST(SolidMass, OfABoxAwayFromTheOriginIsTheTextbooks) {
  const Vector3d size(0.2, 0.3, 0.5), at(1.0, -2.0, 3.0);
  const SolidMass mass = MassOf(Pose3{RotZ(0.0), at} * BoxBody(size), 1000.0);
  EXPECT_NEAR(mass.mass_kg, 30.0, 1e-9);
  EXPECT_LT((mass.p_com - at).norm(), 1e-12);
  const Vector3d squares = size.cwiseProduct(size);
  const Vector3d moments = 30.0 / 12.0 * (Vector3d::Constant(squares.sum()) - squares);
  EXPECT_LT((mass.I_com - Eigen::Matrix3d(moments.asDiagonal())).norm(), 1e-9);
}

TEST(SolidMass, OfTwoHalvesIsThatOfTheWhole) {
  const Vector3d half(0.1, 0.2, 0.3), aside(0.05, 0.0, 0.0);
  const SolidMass whole = Together({MassOf(Pose3{RotZ(0.0), aside} * BoxBody(half), 500.0),
                                    MassOf(Pose3{RotZ(0.0), -aside} * BoxBody(half), 500.0)});
  const SolidMass at_once = MassOf(BoxBody({0.2, 0.2, 0.3}), 500.0);
  EXPECT_NEAR(whole.mass_kg, at_once.mass_kg, 1e-12);
  EXPECT_LT((whole.I_com - at_once.I_com).norm(), 1e-12);
}

// Plates face outwards and are solid: their volume is that of sheet of this thickness, less the
// corners that bend inwards and the lip that is cut off.
TEST(ScoopPlates, AreClosedAndMirrorEachOther) {
  ScoopModel scoop = RoverRig::Model("rocky7").arm->scoop;
  EXPECT_EQ(ScoopPlates(scoop, true).size(), 3u);  // Rocky 7's sides are open
  scoop.sides = ScoopSides::kClosed;
  const auto front = ScoopPlates(scoop, true), back = ScoopPlates(scoop, false);
  ASSERT_EQ(front.size(), 5u);
  const auto profile = ScoopProfile(scoop);
  for (std::size_t i = 0; i < 5; ++i) {
    const SolidMass mass = MassOf(HullOf(front[i].vertices), 1.0);
    const SolidMass mirrored = MassOf(HullOf(back[i].vertices), 1.0);
    EXPECT_NEAR(mass.mass_kg, mirrored.mass_kg, 1e-12);
    EXPECT_NEAR(mass.p_com.x(), -mirrored.p_com.x(), 1e-12);
    double volume_m3[2] = {};
    const TriangleMesh* meshes[2] = {&front[i], &back[i]};
    for (int side = 0; side < 2; ++side) {
      for (const auto& t : meshes[side]->triangles) {
        const auto& v = meshes[side]->vertices;
        volume_m3[side] += v[t[0]].dot(v[t[1]].cross(v[t[2]])) / 6.0;
      }
      EXPECT_NEAR(volume_m3[side], mass.mass_kg, 1e-12) << i;
    }
    if (i >= 3) continue;
    const double sheet = (profile[3 - i] - profile[2 - i]).norm() * scoop.width_m * scoop.wall_m;
    EXPECT_NEAR(mass.mass_kg, sheet, 0.1 * sheet) << i;
  }
}

TEST(LooseStoneShape, HasItsLengthAndRoughlyItsRatiosAboutItsCentreOfMass) {
  for (std::uint64_t key = 1; key <= 20; ++key) {
    const ConvexBody shape = LooseStoneShape(0.04, key);
    Vector3d low = shape.vertices[0], high = low;
    for (const Vector3d& p : shape.vertices) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    EXPECT_NEAR((high - low).x(), 0.04, 1e-12);
    EXPECT_NEAR((high - low).y() / 0.04, 0.8, 0.12);
    EXPECT_NEAR((high - low).z() / 0.04, 0.65, 0.10);
    EXPECT_LT(MassOf(shape, 1.0).p_com.norm(), 1e-12);
  }
  EXPECT_EQ(LooseStoneShape(0.04, 3).vertices, LooseStoneShape(0.04, 3).vertices);
}

TEST(LooseStone, FliesAParabolaWithItsAngularMomentumAndEnergyOfTurning) {
  TreeBody stone = BodyOf(
      MakeLooseStone(LooseStoneShape(0.05, 2), kStoneDensity_kg_m3, Pose3::Translation(0, 0, 1)));
  const Vector3d v(0.3, -0.2, 2.0), w(3.0, 8.0, -2.0), gravity(0.0, 0.0, -kEarthGravity_m_s2);
  TreeBody::Speeds start(6);
  start << v, w;
  stone.AddSpeeds(start);
  const auto Spin = [&] {
    const Eigen::Matrix3d& R = stone.motion(0).X_GL.R;
    return Vector3d(R * stone.link(0).model.I_LCom_L * R.transpose() * stone.motion(0).w_GL_G);
  };
  const Vector3d spin = Spin();
  const double turning =
      stone.KineticEnergy() - 0.5 * stone.link(0).model.mass_kg * v.squaredNorm();
  for (int i = 0; i < 1000; ++i) {
    stone.TakeLoads(gravity, 1e-3);
    stone.Move(1e-3);
  }
  // Steps of h fall g h t / 2 further than the parabola.
  const Vector3d at = Vector3d(0, 0, 1) + v + 0.5 * gravity + 0.5e-3 * gravity;
  EXPECT_LT((stone.motion(0).X_GL.p - at).norm(), 1e-9);
  EXPECT_LT((Spin() - spin).norm(), 1e-12 * spin.norm());
  const Vector3d last = v + gravity;
  EXPECT_NEAR(stone.KineticEnergy() - 0.5 * stone.link(0).model.mass_kg * last.squaredNorm(),
              turning, 1e-4 * turning);
}

/// Stones alone on level soil.
struct Ground {
  explicit Ground(const std::string& soil)
      : grid(LevelGrid(-0.5, 1.0, 1.0, 5e-3)), stones(world, {SoilNamed(soil)}, 0.6) {}
  void Add(const LooseStone& stone) {
    const int number = stones.Add(stone);
    parts.Add({.at = {stones.body(number), 0},
               .body_L = stone.shape_S,
               .material = MaterialOf(0.6),
               .groups = kStoneGroups});
  }
  void Run(double time_s, bool awake = false) {
    for (int i = 0; i < std::lround(1e3 * time_s); ++i) {
      for (int k = 0; awake && k < stones.count(); ++k) stones.AddForce(k, {0.0, 0.0, 0.0});
      parts.AddContacts();
      stones.AddSoilContacts(grid, 1e-3);
      world.Step(1e-3);
      stones.Rest(grid, 1e-3);
    }
  }

  HeightGrid grid;
  RigidWorld world{{0.0, 0.0, -kEarthGravity_m_s2}};
  PartContacts parts{world};
  LooseStones stones;
};

// A flat block sinks by p(z) A = m g.
TEST(LooseStones, BlockSinksAsTheSoilsPressureSays) {
  for (const char* name : {"loose_sand", "compact_gravel"}) {
    Ground ground(name);
    const Vector3d size(0.04, 0.03, 0.02);
    ground.Add(OnGround(BoxBody(size), 0.0, 0.0, 0.3));
    ground.Run(3.0, true);
    const SoilModel soil = SoilNamed(name);
    const double pressure_pa = kStoneDensity_kg_m3 * size.z() * kEarthGravity_m_s2;
    // Where that is less than the soil gives way elastically, it is the latter.
    const double sunk_m = std::max(std::pow(pressure_pa / soil.k_phi, 1.0 / soil.n),
                                   pressure_pa / soil.unloading_stiffness_pa_per_m);
    const double below_m = 0.5 * size.z() - ground.stones.motion(0).X_GL.p.z();
    EXPECT_NEAR(below_m, sunk_m, 0.02 * sunk_m) << name;
  }
}

// Of any shape: the soil's pressures at the corners bear the weight, and none is above p(z).
TEST(LooseStones, StoneRestsWhereThePressureAtItsCornersBearsIt) {
  for (std::uint64_t key = 1; key <= 5; ++key) {
    Ground ground("loose_sand");
    ground.Add(OnGround(LooseStoneShape(0.04, key), 0.0, 0.0, 0.0));
    ground.Run(2.0, true);
    double borne_n = 0.0;
    for (const WorldContact& contact : ground.world.contacts()) {
      borne_n += 1e3 * contact.impulse_G.z();
      EXPECT_GE(contact.impulse_G.z(), 0.0);
    }
    const double weight_n = ground.stones.mass_kg(0) * kEarthGravity_m_s2;
    EXPECT_NEAR(borne_n, weight_n, 1e-3 * weight_n);
  }
}

TEST(LooseStones, StoneAtRestCreepsLessThanHalfAMillimetreInTenSecondsThoughItMayNotSleep) {
  for (const char* name : {"loose_sand", "compact_gravel"}) {
    Ground ground(name);
    ground.Add(OnGround(LooseStoneShape(0.05, 4), 0.0, 0.0, 0.0));
    ground.Run(2.0, true);
    const Vector3d from = ground.stones.motion(0).X_GL.p;
    ground.Run(10.0, true);
    EXPECT_LT((ground.stones.motion(0).X_GL.p - from).norm(), 0.1e-3) << name;
  }
}

// Where it was put down so, a stone of any shape neither tips nor rolls, and not all lie on their
// flattest side.
TEST(LooseStones, StoneStaysInItsAttitudeOfRest) {
  int upright = 0;
  for (std::uint64_t key = 1; key <= 20; ++key) {
    Ground ground("compact_gravel");
    const ConvexBody shape = LooseStoneShape(0.04, key);
    const Eigen::Matrix3d R_GS = RestingTurn(shape, key);
    ground.Add(MakeLooseStone(shape, kStoneDensity_kg_m3, StandingAt(shape, R_GS, {0, 0}, 0.0)));
    ground.Run(3.0, true);
    const Eigen::Matrix3d turned = ground.stones.motion(0).X_GL.R * R_GS.transpose();
    EXPECT_LT(std::acos(std::clamp(turned(2, 2), -1.0, 1.0)), 0.05) << key;
    upright += std::abs(R_GS(2, 2)) < std::cos(0.8);  // not on its shortest axis
    EXPECT_EQ(RestingTurn(shape, key), R_GS);
  }
  EXPECT_GE(upright, 2);
  EXPECT_LE(upright, 12);
}

// The soil under a stone that lay there bears it; as the soil of new sinkage it would lift it out.
TEST(LooseStones, BuriedStoneStaysWhereItLies) {
  for (const char* name : {"loose_sand", "compact_gravel"}) {
    double rose_m[2] = {};
    for (const int bedded : {0, 1}) {
      Ground ground(name);
      const ConvexBody shape = LooseStoneShape(0.04, 2);
      ground.Add(MakeLooseStone(shape, kStoneDensity_kg_m3,
                                StandingAt(shape, Eigen::Matrix3d::Identity(), {0, 0}, 0.0, 0.3)));
      if (bedded == 1) ground.stones.Bed(0, ground.grid);
      const double from_m = ground.stones.motion(0).X_GL.p.z();
      ground.Run(2.0, true);
      rose_m[bedded] = ground.stones.motion(0).X_GL.p.z() - from_m;
    }
    EXPECT_LT(std::abs(rose_m[1]), 0.3e-3) << name;
    EXPECT_GT(rose_m[0], 2.0 * std::abs(rose_m[1])) << name;
  }
}

TEST(LooseStones, SleeperStaysExactlyUntilTheGroundBelowItChanges) {
  Ground ground("loose_sand");
  ground.Add(OnGround(LooseStoneShape(0.03, 1), 0.0, 0.0, 0.0));
  ground.Run(2.0);
  ASSERT_TRUE(ground.stones.asleep(0));
  const Pose3 at = ground.stones.motion(0).X_GL;
  ground.Run(1.0);
  EXPECT_EQ(ground.stones.motion(0).X_GL.p, at.p);
  EXPECT_EQ(ground.stones.motion(0).X_GL.R, at.R);
  for (double& height_m : ground.grid.heights_m) height_m -= 0.01;
  ground.Run(2.0);
  EXPECT_NEAR(ground.stones.motion(0).X_GL.p.z(), at.p.z() - 0.01, 2e-3);
}

// A stone dropped on another comes to rest and no lower than the other lets it.
TEST(LooseStones, OneStoneLiesOnAnother) {
  Ground ground("compact_gravel");
  const Vector3d size(0.06, 0.06, 0.02);
  ground.Add(OnGround(BoxBody(size), 0.0, 0.0, 0.0));
  const ConvexBody small = BoxBody({0.02, 0.02, 0.02});
  ground.Add(MakeLooseStone(small, kStoneDensity_kg_m3, Pose3::Translation(0.0, 0.0, 0.05)));
  ground.Run(2.0);
  const double above_m = ground.stones.motion(1).X_GL.p.z() - ground.stones.motion(0).X_GL.p.z();
  EXPECT_NEAR(above_m, 0.02, 0.2e-3);
  EXPECT_TRUE(ground.stones.asleep(1));
}

}  // namespace
}  // namespace dockyard
