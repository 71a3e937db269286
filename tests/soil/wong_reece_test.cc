// Our laws of pressure and shear in the limit of Wong and Reece's driven rigid wheel (1967): no
// weakening, full friction, their shape of the pressure. Reference: an independent integration of
// their equations with 4000 points, for the three wheels of their paper (r = 0.6274 m).
#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {
namespace {

constexpr double kRadius_m = 0.6274, kShearModulus_m = 0.0381;  // 24.7 and 1.5 in

struct Case {
  const char* name;
  double width_m, load_n, n, k_pa;  // p = k_pa (z / b)^n
  double cohesion_pa, phi_deg, c1;  // angle of most pressure over that of entry: c1 + 0.32 slip
  double slip, sinkage_m, drawbar, torque;  // expected; over W and W r
};

struct Wheel {
  double load_n = 0.0, thrust_n = 0.0, resistance_n = 0.0, torque_nm = 0.0;
  double drawbar_n() const { return thrust_n - resistance_n; }
};

/// One strip of the rim: stresses at an angle, along the whole width.
void AddStrip(const Case& wheel, double angle, double step, double pressure, double stress,
              Wheel& sum) {
  const double area = wheel.width_m * kRadius_m * step;
  sum.load_n += area * (pressure * std::cos(angle) + stress * std::sin(angle));
  sum.thrust_n += area * stress * std::cos(angle);
  sum.resistance_n += area * pressure * std::sin(angle);
  sum.torque_nm += area * stress * kRadius_m;
}

/// Angles of entry, of most pressure, and the depth that rules a strip's pressure: behind the
/// highest it falls off as before it.
struct Contact {
  double entry = 0.0, most = 0.0;
  Contact(const Case& wheel, double sinkage_m)
      : entry(std::acos(1.0 - sinkage_m / kRadius_m)),
        most((wheel.c1 + 0.32 * wheel.slip) * entry) {}
  double Depth(double angle) const {
    const double front = angle >= most ? angle : entry - angle / most * (entry - most);
    return kRadius_m * (std::cos(front) - std::cos(entry));
  }
};

constexpr int kPoints = 4000;

/// With our laws, the shear followed strip by strip as a patch is.
Wheel Ours(const Case& wheel, double sinkage_m) {
  SoilLaws laws;
  laws.k = wheel.k_pa / std::pow(wheel.width_m, wheel.n);
  laws.n = wheel.n;
  laws.cohesion_pa = wheel.cohesion_pa;
  laws.tan_rim = std::tan(Radians(wheel.phi_deg));
  const Contact contact(wheel, sinkage_m);
  const double step = contact.entry / kPoints;
  Wheel sum;
  Mobilisation shear;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = contact.entry - (i + 0.5) * step;
    const double pressure =
        YieldPressure(laws, contact.Depth(angle)) * BearingShare(laws, 0.3, 0.5);
    // The rim slides back by r (1 - (1 - slip) cos) per angle; half a step to the strip's middle.
    const double slide = kRadius_m * (1.0 - (1.0 - wheel.slip) * std::cos(angle)) * step;
    const Mobilisation middle = Shear(shear, 0.5 * slide, 0.0, kShearModulus_m);
    shear = Shear(shear, slide, 0.0, kShearModulus_m);
    AddStrip(wheel, angle, step, pressure, ShearStrength(laws, pressure) * middle.t, sum);
  }
  return sum;
}

/// With their equations: p = k (z / b)^n, tau = (c + p tan phi)(1 - exp(-j / K)) and the slid way
/// in closed form, j = r ((entry - angle) - (1 - slip)(sin(entry) - sin(angle))).
Wheel Theirs(const Case& wheel, double sinkage_m) {
  const Contact contact(wheel, sinkage_m);
  const double step = contact.entry / kPoints, tan_phi = std::tan(Radians(wheel.phi_deg));
  Wheel sum;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = contact.entry - (i + 0.5) * step;
    const double pressure = wheel.k_pa * std::pow(contact.Depth(angle) / wheel.width_m, wheel.n);
    const double j = kRadius_m * (contact.entry - angle -
                                  (1.0 - wheel.slip) * (std::sin(contact.entry) - std::sin(angle)));
    const double stress =
        (wheel.cohesion_pa + pressure * tan_phi) * (1.0 - std::exp(-j / kShearModulus_m));
    AddStrip(wheel, angle, step, pressure, stress, sum);
  }
  return sum;
}

/// Depth at which the wheel carries its load.
template <typename Integral>
double SinkageOf(const Case& wheel, const Integral& integral) {
  double low = 1e-3, high = 0.6;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (integral(wheel, middle).load_n < wheel.load_n ? low : high) = middle;
  }
  return low;
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
    SCOPED_TRACE(testing::Message()
                 << wheel.name << " " << wheel.width_m << " slip " << wheel.slip);
    // Their equations give the table, whose drawbar is stated to 0.07 % at worst, ...
    const double sinkage_m = SinkageOf(wheel, Theirs);
    const Wheel theirs = Theirs(wheel, sinkage_m);
    EXPECT_NEAR(sinkage_m / wheel.sinkage_m, 1.0, 0.001);
    EXPECT_NEAR(theirs.drawbar_n() / wheel.load_n / wheel.drawbar, 1.0, 0.001);
    EXPECT_NEAR(theirs.torque_nm / (wheel.load_n * kRadius_m) / wheel.torque, 1.0, 0.001);
    // ... and our laws what they give, the drawbar's two parts each.
    const double our_sinkage_m = SinkageOf(wheel, Ours);
    const Wheel ours = Ours(wheel, our_sinkage_m);
    EXPECT_NEAR(our_sinkage_m / sinkage_m, 1.0, 0.001);
    EXPECT_NEAR(ours.thrust_n / theirs.thrust_n, 1.0, 0.001);
    EXPECT_NEAR(ours.resistance_n / theirs.resistance_n, 1.0, 0.001);
    EXPECT_NEAR(ours.torque_nm / theirs.torque_nm, 1.0, 0.001);
  }
}

}  // namespace
}  // namespace dockyard
