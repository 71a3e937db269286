// Our laws of pressure and shear in the limit of Wong and Reece's driven rigid wheel (1967): no
// weakening, full friction, their shape of the pressure. Reference: an independent integration of
// their equations with 4000 points, for the three wheels of their paper (r = 0.6274 m).
#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {
namespace {

constexpr double kRadius_m = 0.6274, kShearModulus_m = 0.038;

struct Case {
  const char* name;
  double width_m, load_n, n, k_pa;  // p = k_pa (z / b)^n
  double cohesion_pa, phi_deg, c1;  // angle of most pressure over that of entry: c1 + 0.32 slip
  double slip, sinkage_m, drawbar, torque;  // expected; over W and W r
};

struct Wheel {
  double load_n = 0.0, drawbar_n = 0.0, torque_nm = 0.0;
};

Wheel Integrate(const Case& wheel, double sinkage_m) {
  SoilLaws laws;
  laws.k = wheel.k_pa / std::pow(wheel.width_m, wheel.n);
  laws.n = wheel.n;
  laws.cohesion_pa = wheel.cohesion_pa;
  laws.tan_rim = std::tan(Radians(wheel.phi_deg));
  const double entry = std::acos(1.0 - sinkage_m / kRadius_m);
  const double most = (wheel.c1 + 0.32 * wheel.slip) * entry;
  constexpr int kPoints = 4000;
  const double step = entry / kPoints;
  Wheel sum;
  Mobilisation shear;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = entry - (i + 0.5) * step;
    const double front = angle >= most ? angle : entry - angle / most * (entry - most);
    const double z = kRadius_m * (std::cos(front) - std::cos(entry));
    const double pressure = YieldPressure(laws, z) * BearingShare(laws, 0.3, 0.5);
    // The rim slides back by r (1 - (1 - slip) cos) per angle; half a step to the strip's middle.
    const double slide = kRadius_m * (1.0 - (1.0 - wheel.slip) * std::cos(angle)) * step;
    const Mobilisation middle = Shear(shear, 0.5 * slide, 0.0, kShearModulus_m);
    shear = Shear(shear, slide, 0.0, kShearModulus_m);
    const double stress = ShearStrength(laws, pressure) * middle.t;
    const double area = wheel.width_m * kRadius_m * step;
    sum.load_n += area * (pressure * std::cos(angle) + stress * std::sin(angle));
    sum.drawbar_n += area * (stress * std::cos(angle) - pressure * std::sin(angle));
    sum.torque_nm += area * stress * kRadius_m;
  }
  return sum;
}

TEST(WongReece, IntegralsOfOurLawsAreTheirs) {
  constexpr double kPsi = 6894.757, kPoundPerCubicInch = 271447.0;
  const auto compact = [&](double slip, double z, double drawbar, double torque) {
    return Case{"compact", 0.1524, 8923.0, 0.47, 20.0 * kPsi + 2.5 * kPoundPerCubicInch * 0.1524,
                690.0,     33.3,   0.43,   slip, z,
                drawbar,   torque};
  };
  const auto loose = [&](double b, double w, double slip, double z, double drawbar, double torque) {
    return Case{"loose", b, w,       1.15,  2.0 * kPoundPerCubicInch * b, 830.0, 31.1, 0.18,
                slip,    z, drawbar, torque};
  };
  for (const Case& wheel :
       {compact(0.1, 0.1227, 0.0755, 0.3848), compact(0.2, 0.1231, 0.1362, 0.4469),
        compact(0.4, 0.1267, 0.1860, 0.5057), loose(0.1524, 8834.0, 0.1, 0.2724, 0.1184, 0.5068),
        loose(0.1524, 8834.0, 0.2, 0.2763, 0.1198, 0.5187),
        loose(0.1524, 8834.0, 0.4, 0.2867, 0.1031, 0.5274),
        loose(0.3048, 9275.0, 0.1, 0.1990, 0.1425, 0.4718),
        loose(0.3048, 9275.0, 0.2, 0.2011, 0.1641, 0.5009),
        loose(0.3048, 9275.0, 0.4, 0.2079, 0.1670, 0.5231)}) {
    double low = 1e-3, high = 0.6;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (Integrate(wheel, middle).load_n < wheel.load_n ? low : high) = middle;
    }
    const Wheel result = Integrate(wheel, low);
    SCOPED_TRACE(testing::Message()
                 << wheel.name << " " << wheel.width_m << " slip " << wheel.slip);
    EXPECT_NEAR(low / wheel.sinkage_m, 1.0, 0.005);
    EXPECT_NEAR(result.drawbar_n / wheel.load_n, wheel.drawbar, 0.005 * wheel.torque);
    EXPECT_NEAR(result.torque_nm / (wheel.load_n * kRadius_m) / wheel.torque, 1.0, 0.005);
  }
}

}  // namespace
}  // namespace dockyard
