// Belts on soil against Bekker's law by hand: p = (k_c / b + k_phi) z^n, and the work that pressing
// the rut takes, w k z^(n+1) / (n+1) per length (Wong, Theory of Ground Vehicles, 4th ed., 2.4).
#include <gtest/gtest.h>

#include <cmath>

#include "models/read/load_soil.h"
#include "sim/soil/soil_laws.h"
#include "support/bad_files.h"
#include "vehicles/belt_rig.h"

namespace dockyard {
namespace {

constexpr double kBelt_m = 0.386, kGauge_m = 0.426;

SoilModel Soil(const std::string& name) {
  return LoadSoil(SourceFile("models/soils/" + name + ".yaml"));
}

BeltRig OnSoil(const SoilModel& soil, double radius_m, double pad_m, double dt_s = 1e-3) {
  BeltRig rig;
  for (const double y_m : {0.5 * kGauge_m, -0.5 * kGauge_m}) {
    rig.belts.push_back(
        {{}, RigBeltModel(-0.5 * kBelt_m, 0.5 * kBelt_m, radius_m, y_m, pad_m), 0.0});
  }
  rig.X_GR.p.z() = radius_m;
  rig.PutOn(soil, 0.0);
  rig.LayDown(4.0, dt_s);
  rig.Run(0.5, dt_s);
  return rig;
}

/// Load of both belts this deep, the rollers' arcs included.
double BekkerLoad(const SoilLaws& laws, double width_m, double radius_m, double depth_m) {
  double sum = kBelt_m * std::pow(depth_m, laws.n);
  const double reach_m = std::sqrt(2.0 * radius_m * depth_m - depth_m * depth_m);
  constexpr int kCells = 5000;
  for (int i = 0; i < kCells; ++i) {
    const double x = (i + 0.5) * reach_m / kCells;
    const double z = depth_m - radius_m + std::sqrt(radius_m * radius_m - x * x);
    sum += 2.0 * std::pow(std::max(0.0, z), laws.n) * reach_m / kCells;
  }
  return 2.0 * width_m * laws.k * sum;
}

TEST(BeltOnSoil, SinksByBekkersLaw) {
  const SoilModel soil = Soil("loose_sand");
  for (const double radius_m : {0.05, 0.09}) {
    const BeltRig rig = OnSoil(soil, radius_m, 0.028);
    const double width_m = rig.belts[0].model.width_m, depth_m = radius_m - rig.X_GR.p.z();
    const double load_n = BekkerLoad(MakeRimLaws(soil, width_m), width_m, radius_m, depth_m);
    EXPECT_NEAR(load_n, rig.Weight(), 0.02 * rig.Weight()) << radius_m;
    EXPECT_GT(depth_m, 0.005);
  }
}

TEST(BeltOnSoil, MeetsTheWorkOfPressingItsRut) {
  const SoilModel soil = Soil("loose_sand");
  BeltRig rig = OnSoil(soil, 0.09, 0.007);
  rig.Drive(0.1, 0.1);
  rig.Run(6.0);
  double thrust_n = 0.0, rear_m = 0.0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    rig.Step(1e-3);
    for (const RigBelt& belt : rig.belts) {
      thrust_n += belt.load.drive_torque_nm / belt.model.sprocket_radius_m / kSteps;
    }
    rear_m += (0.09 - (rig.X_GR * Eigen::Vector3d(-0.5 * kBelt_m, 0.0, 0.0)).z()) / kSteps;
  }
  // Nose up, the rear goes deepest and leaves the rut.
  const SoilLaws laws = MakeRimLaws(soil, 0.07);
  const double work_n = 2.0 * 0.07 * laws.k * std::pow(rear_m, laws.n + 1.0) / (laws.n + 1.0);
  EXPECT_NEAR(thrust_n, work_n, 0.1 * work_n);
  EXPECT_GT(thrust_n, 1.5);
}

TEST(BeltOnSoil, StaysWhereItSankToo) {
  for (const char* name : {"loose_sand", "compact_gravel"}) {
    BeltRig rig = OnSoil(Soil(name), 0.09, 0.028);
    rig.gravity_G = 9.81 * Eigen::Vector3d(std::sin(0.3), 0.1, -std::cos(0.3)).normalized();
    rig.Run(3.0);
    const Eigen::Vector3d p = rig.X_GR.p;
    rig.Run(60.0);
    EXPECT_LT((rig.X_GR.p - p).norm(), 1e-6) << name;
  }
}

TEST(BeltOnSoil, IsFirmWhereCompactGravelBearsIt) {
  // Under 5 kPa the gravel gives 0.03 mm, the belt ten times as much: no rut, hence no resistance.
  BeltRig rig = OnSoil(Soil("compact_gravel"), 0.09, 0.028);
  rig.Drive(0.1, 0.1);
  rig.Run(4.0);
  const double torque = rig.belts[0].load.drive_torque_nm + rig.belts[1].load.drive_torque_nm;
  EXPECT_LT(std::fabs(torque / 0.09), 1e-3 * rig.Weight());
  EXPECT_NEAR(rig.VelocityInR().x(), 0.1, 2e-4);
}

TEST(BeltOnSoil, PushesSoilAsideWhereItSank) {
  SoilModel soil = Soil("loose_sand");
  BeltRig rig = OnSoil(soil, 0.09, 0.028);
  const double depth_m = 0.09 - rig.X_GR.p.z();
  rig.v_GCom_G = {0.0, 0.05, 0.0};
  Eigen::Vector3d force;
  for (int i = 0; i < 4000; ++i) {
    force = rig.Load(1e-3).first;
    rig.X_GR.p += 1e-3 * rig.v_GCom_G;
  }
  const SoilLaws laws = MakeRimLaws(soil, 0.07);
  const double area_m2 = 2.0 * 0.07 * (rig.belts[0].load.front_m - rig.belts[0].load.rear_m);
  const double shear_n = laws.tan_phi * force.z() + laws.cohesion_pa * area_m2;
  const double aside_n = 2.0 * kBelt_m * BulldozingResistance(laws, depth_m);
  EXPECT_GT(aside_n, 0.05 * shear_n);
  EXPECT_NEAR(-force.y(), shear_n + aside_n, 0.02 * shear_n);
}

TEST(BeltOnSoil, TurnsAsFarWithHalfTheStep) {
  const SoilModel soil = Soil("loose_sand");
  BeltRig coarse = OnSoil(soil, 0.09, 0.028, 2e-3), fine = OnSoil(soil, 0.09, 0.028, 1e-3);
  const double at_two = TurnInPlace(coarse, 0.1, 2e-3).gauge_m;
  const double at_one = TurnInPlace(fine, 0.1, 1e-3).gauge_m;
  EXPECT_NEAR(at_two, at_one, 2e-3 * at_one);
  EXPECT_GT(at_one, 0.5);  // the firm floor's 0.493: soil at the sides resists too
}

}  // namespace
}  // namespace dockyard
