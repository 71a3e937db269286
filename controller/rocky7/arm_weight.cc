#include "controller/rocky7/arm_weight.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

constexpr double kGravity_m_s2 = 9.81;
// Half of a stone of 3 cm: its hull has 8 to 10 cm^3 of 2700 kg/m^3. Assumed, 8-15 g.
constexpr double kLeast_kg = 0.012;
// Sigmas between that and what is believed. Assumed, 2-4.
constexpr double kSure = 2.5;
constexpr int kLeastReadings = 10;  // assumed, 5-20

}  // namespace

void RisingCurrent::Add(double pitch_rad, double current_a) {
  if (pitch_rad > kWeighFrom_rad || pitch_rad < kWeighTo_rad) return;
  if (count_ > 0) jumps_a2_ += (current_a - last_a_) * (current_a - last_a_);
  last_a_ = current_a;
  ++count_;
  sum_a_ += current_a;
  sum_cos_ += std::cos(pitch_rad);
}

double RisingCurrent::mean_a() const { return sum_a_ / std::max(count_, 1); }

double RisingCurrent::mean_cos() const { return sum_cos_ / std::max(count_, 1); }

double RisingCurrent::sigma_a() const {
  if (count_ < 2) return 0.0;
  // A jump has the noise of two readings. The arm's own moment changes slowly.
  return std::sqrt(0.5 * jumps_a2_ / (count_ - 1) / count_);
}

Load LoadOf(const RisingCurrent& empty, const RisingCurrent& now, const NominalArm& arm,
            const NominalMotor& pitch) {
  if (std::min(empty.count(), now.count()) < kLeastReadings) return Load::kUnknown;
  // A motor that turns draws that much at least.
  if (std::min(empty.mean_a(), now.mean_a()) < 0.5 * pitch.no_load_current_a) return Load::kUnknown;
  const double kg_per_a = pitch.torque_per_amp_nm / (kGravity_m_s2 * arm.length_m * now.mean_cos());
  const double load_kg = kg_per_a * (now.mean_a() - empty.mean_a());
  const double sigma_kg = kg_per_a * std::hypot(now.sigma_a(), empty.sigma_a());
  if (std::abs(load_kg - kLeast_kg) < kSure * sigma_kg || kSure * sigma_kg > kLeast_kg) {
    return Load::kUnknown;
  }
  return load_kg > kLeast_kg ? Load::kStone : Load::kNone;
}

}  // namespace dockyard::rocky7
