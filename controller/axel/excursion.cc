#include "controller/axel/excursion.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/drive.h"
#include "controller/axel/haul.h"

namespace dockyard::axel {

double FallBySeatedArm(const Nominal& nominal, double elevation_rad) {
  return elevation_rad - std::asin(nominal.X_DB.R.col(2).z());
}

double OutwardTension(const AxelOptions& options, double fall_rad) {
  const double downhill_n = options.noise.weight_n * std::sin(std::max(0.0, fall_rad));
  return options.tether.reverse_tension_n + options.excursion.weight_share * downhill_n;
}

double UndockedWay(const Nominal& nominal, const ExcursionOptions& options) {
  return nominal.seat_depth_m + options.clear_gap_m;
}

double WayOut(double paid_out_m, double rolled_back_m) {
  return std::min(paid_out_m, rolled_back_m);
}

double WayBack(double way_out_m, const ExcursionOptions& options) {
  return std::max(0.0, way_out_m - options.return_m);
}

void Excursion::Begin(Senses* senses) {
  senses->filter().Restart(SeatedFix(nominal_));
  seated_ = MomentOf(*senses);
  tension_n_ = OutwardTension(options_, FallBySeatedArm(nominal_, senses->elevation_rad()));
}

double Excursion::OutOf(const Senses& senses) const {
  return WayOut(seated_.reeled_m - senses.reeled_m(), seated_.rolled_m - senses.rolled_m());
}

Excursion::Status Excursion::Step(double distance_m, Tick in_phase, Senses* senses,
                                  Commands* commands) const {
  const DriveOptions& drive = options_.drive;
  const double limit_s = drive.patience * distance_m / drive.reverse_m_s;
  if (kTickSeconds * static_cast<double>(in_phase) > limit_s) return Status::kLate;
  if (OutOf(*senses) >= distance_m) return Status::kOut;
  const double turn_rad_s =
      options_.excursion.yaw_gain_per_s * WrapPi(seated_.yaw_rad - senses->yaw_rad());
  CommandWheels(nominal_, {-drive.reverse_m_s, turn_rad_s}, drive.wheel_accel_rad_s2, commands);
  const TetherOptions& tether = options_.tether;
  CommandOf(commands, Motor::kSpool) =
      Winch(nominal_, tether.catch_up_m_s, tension_n_, tether.accel_rad_s2);
  // Seated it learns the tether's length, and further out its distance from it.
  senses->UseTether(tether.taut_share * tension_n_);
  return Status::kUnderWay;
}

void Excursion::PlanReturn(const Senses& senses) {
  back_m_ = WayBack(OutOf(senses), options_.excursion);
}

}  // namespace dockyard::axel
