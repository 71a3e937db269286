// Wheels and soils that took no part in any fit (data/), with constants as published. The bands say
// how far the model is off, not how far it may be: docs/results/soil.md has the causes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "controller/geometry/pose.h"
#include "sim/soil/wheel_data.h"
#include "soil/rig.h"
#include "support/source_tree.h"

namespace dockyard::soil_test {
namespace {

struct Errors {
  double pull = 0.0, torque_nm = 0.0;  // rms; pull over the load
};

Errors Compare(const char* file, const char* name, const WheelModel& wheel, const SoilModel& soil) {
  const std::string path = SourceFile("tests/soil/data/") + file;
  const std::vector<MeasuredRow> rows = LoadMeasuredRows(path, name);
  Errors sum;
  SingleWheelSetup setup;
  setup.wheel = wheel;
  setup.soil = soil;
  setup.speed_m_s = 0.03;
  SingleWheelResult model;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool repeat =
        i > 0 && rows[i].slip == rows[i - 1].slip && rows[i].load_n == rows[i - 1].load_n;
    setup.slip = rows[i].slip;
    setup.load_n = rows[i].load_n;
    if (!repeat) model = RunSingleWheel(setup);
    std::printf("%s slip %.2f: pull %.3f (%.3f) of the load, torque %.2f (%.2f) N m\n", name,
                rows[i].slip, model.ahead_n / rows[i].load_n, rows[i].ahead_n / rows[i].load_n,
                model.torque_nm, rows[i].torque_nm);
    sum.pull += std::pow((model.ahead_n - rows[i].ahead_n) / rows[i].load_n, 2);
    sum.torque_nm += std::pow(model.torque_nm - rows[i].torque_nm, 2);
  }
  const auto count = static_cast<double>(rows.size());
  const Errors errors{std::sqrt(sum.pull / count), std::sqrt(sum.torque_nm / count)};
  std::printf("%s of %s: rms %.3f of the load, %.2f N m\n", name, file, errors.pull,
              errors.torque_nm);
  return errors;
}

TEST(OtherWheels, DingsSmoothWheelIsWithinATwentiethOfItsLoad) {
  const Errors errors = Compare("ding_2011.csv", "smooth", Wheel("ding_smooth"), Soil("ding_2011"));
  EXPECT_LT(errors.pull, 0.055);
  EXPECT_LT(errors.torque_nm, 1.1);
}

TEST(OtherWheels, DingsLugsAreWithinATwentiethOfTheirLoad) {
  const Errors errors = Compare("ding_2011.csv", "lugs", Wheel("ding_lugs"), Soil("ding_2011"));
  EXPECT_LT(errors.pull, 0.055);
  EXPECT_LT(errors.torque_nm, 0.6);
}

TEST(OtherWheels, VipersWheelIsWithinAFifteenthOfItsLoadWithEitherGrousers) {
  WheelModel wheel = Wheel("viper");
  EXPECT_LT(Compare("viper_trec.csv", "viper", wheel, Soil("grc_3")).pull, 0.07);
  wheel.paddle_height_m = 0.025;  // an earlier wheel
  wheel.width_m = 0.18;
  EXPECT_LT(Compare("viper_trec.csv", "viper", wheel, Soil("grc_3")).pull, 0.08);
}

// GRC-1 with the friction that the authors give and no cohesion, as grc_3.yaml has it.
TEST(OtherWheels, ARoverOnSlopesOfGrc1IsWithinATwelfthOfItsLoad) {
  SoilModel soil = Soil("grc_1");
  soil.cohesion_pa = 0.0;
  soil.friction_angle_rad = Radians(37.8);
  EXPECT_LT(Compare("mgru3_slopes.csv", "viper", Wheel("viper"), soil).pull, 0.085);
}

/// A row of plates_90.csv: a plate's mean pressure at a depth.
struct PlateRow {
  double width_m = 0.0, depth_m = 0.0, pressure_pa = 0.0;
};

std::vector<PlateRow> Plates() {
  std::ifstream file(SourceFile("tests/soil/data/plates_90.csv"));
  std::vector<PlateRow> rows;
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("plate,")) continue;
    std::stringstream cells(line.substr(6));
    std::vector<double> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    rows.push_back({1e-3 * values.at(0), 1e-3 * values.at(1), 1e3 * values.at(2)});
  }
  return rows;
}

// k_phi is that of the trials' wheels, 60 mm wide; the plates took no part in it.
TEST(Plates, OfSixToTenCentimetresPressAsMeasuredFromTenMillimetresOn) {
  const std::vector<PlateRow> rows = Plates();
  ASSERT_EQ(rows.size(), 9u);
  for (const PlateRow& row : rows) {
    const SoilLaws laws = MakeRimLaws(Soil("pavlov_90"), row.width_m);
    const double ratio = YieldPressure(laws, row.depth_m) / row.pressure_pa;
    std::printf("%.0f mm wide, %.0f mm deep: %.2f of the measured\n", 1e3 * row.width_m,
                1e3 * row.depth_m, ratio);
    // At 4 mm the sand is firmer than its own exponent says, the most under the narrowest plate.
    EXPECT_NEAR(ratio, 1.0, row.depth_m > 0.005 ? 0.15 : 0.37);
  }
}

/// Force that presses a wheel in, not turning, to this depth of its lowest point.
double Press(const WheelModel& wheel, double depth_m) {
  HeightGrid grid = LevelGrid(-0.3, 0.6, 0.6, 0.01);
  WheelSoil contact(wheel, Soil("pavlov_90"));
  WheelMotion motion;
  motion.v_GK_G = Eigen::Vector3d(0.0, 0.0, -1e-3);
  const double step_m = 1e-5;
  double force_n = 0.0;
  for (double z_m = step_m; z_m <= depth_m; z_m += step_m) {
    motion.X_GK.p = Eigen::Vector3d(0.0, 0.0, RollingRadius(wheel) - z_m);
    force_n = contact.Step(grid, motion, step_m / 1e-3).force_G.z();
  }
  return force_n;
}

// plates_90.csv: means of three, standard deviations of 10 % at 10 mm and 5-11 % at 20 mm. They
// decide between two published shapes of the wheels (docs/results/soil.md). At 10 mm most of the
// rim is less than 5 mm deep, where the sand is firmer than its exponent says; and grousers' tips,
// each a blade of its own for us, bear too much.
TEST(Plates, AndTheTrialsWheelsPressedInBearAsMeasured) {
  struct Row {
    const char* wheel;
    double depth_m, force_n;
  };
  for (const Row& row : {Row{"pavlov_smooth", 0.010, 18.4}, Row{"pavlov_smooth", 0.020, 66.4},
                         Row{"pavlov_grouser", 0.010, 13.4}, Row{"pavlov_grouser", 0.020, 59.4}}) {
    const double force_n = Press(Wheel(row.wheel), row.depth_m);
    std::printf("%s %.0f mm deep: %.1f (%.1f) N\n", row.wheel, 1e3 * row.depth_m, force_n,
                row.force_n);
    EXPECT_NEAR(force_n / row.force_n, 1.0, row.depth_m > 0.015 ? 0.1 : 0.45) << row.wheel;
  }
}

}  // namespace
}  // namespace dockyard::soil_test
