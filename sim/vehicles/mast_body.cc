#include "sim/vehicles/mast_body.h"

#include "sim/rigid/solid_link.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Of the shoulder's housing; assumed, 3-8 cm.
constexpr double kHousing_m = 0.05;

Matrix3d BlockInertia(double mass_kg, const Vector3d& size_m) {
  const Vector3d s2 = size_m.cwiseAbs2();
  return mass_kg / 12.0 *
         Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y()).asDiagonal().toDenseMatrix();
}

SolidMass Block(double mass_kg, const Vector3d& middle, const Vector3d& size_m) {
  return {mass_kg, middle, BlockInertia(mass_kg, size_m)};
}

// The second link: a bar, and the instrument at its end.
SolidMass BarMass(const MastModel& mast) {
  const double bar_m = mast.link2_m - mast.instrument.length_m;
  return Block(mast.link2_kg, {0.5 * bar_m, 0.0, 0.0}, {bar_m, kMastBar_m, kMastBar_m});
}

SolidMass CanMass(const MastModel& mast) {
  const InstrumentModel& can = mast.instrument;
  return Block(can.mass_kg, {mast.link2_m - 0.5 * can.length_m, 0.0, 0.0},
               {can.length_m, 2.0 * can.radius_m, 2.0 * can.radius_m});
}

}  // namespace

std::vector<TreeLink> MastLinks(const MastModel& mast, int first) {
  const Vector3d y = Vector3d::UnitY();
  TreeLink can = SolidLink(first + kMastElbow, Vector3d::Zero(), Vector3d::UnitX(), CanMass(mast));
  can.joint = JointKind::kSlide;
  can.stiffness_nm_per_rad = mast.instrument.mast_n_per_m;
  can.damping_nms_per_rad = mast.instrument.mast_ns_per_m;
  const auto rotor = [&](std::size_t i) { return mast.motors[i].reflected_inertia_kg_m2; };
  return {SolidLink(0, mast.p_RM, Vector3d::UnitZ(),
                    Block(mast.housing_kg, Vector3d::Zero(), Vector3d::Constant(kHousing_m)),
                    rotor(kMastRoll)),
          SolidLink(first + kMastRoll, Vector3d::Zero(), y,
                    Block(mast.link1_kg, {0.5 * mast.link1_m, 0.0, 0.0},
                          {mast.link1_m, kMastBar_m, kMastBar_m}),
                    rotor(kMastShoulder)),
          SolidLink(first + kMastShoulder, {mast.link1_m, 0.0, 0.0}, y, BarMass(mast),
                    rotor(kMastElbow)),
          can};
}

double MastInertia(const MastModel& mast, int motor) {
  const SolidMass outer = Together({BarMass(mast), CanMass(mast)});
  const auto About = [](double mass_kg, double away_m, double moment) {
    return moment + mass_kg * away_m * away_m;
  };
  const double outer_yy = outer.I_com(1, 1);
  const double rotor = mast.motors[static_cast<std::size_t>(motor)].reflected_inertia_kg_m2;
  if (motor == kMastElbow) return rotor + About(outer.mass_kg, outer.p_com.x(), outer_yy);
  return rotor + mast.link1_kg * mast.link1_m * mast.link1_m / 3.0 +
         About(outer.mass_kg, mast.link1_m + outer.p_com.x(), outer_yy);
}

void LimitMast(const MastModel& mast, const BodyLink& first, RigidWorld& world) {
  for (std::size_t i = 0; i < kMastMotors; ++i) {
    world.Limit({first.body, first.link + static_cast<int>(i)},
                StopsAt(mast.stop, mast.low_rad[i], mast.high_rad[i]));
  }
}

}  // namespace dockyard
