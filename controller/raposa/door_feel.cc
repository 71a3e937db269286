#include "controller/raposa/door_feel.h"

#include <algorithm>
#include <cmath>

#include "controller/raposa/odometry.h"

namespace dockyard::raposa {
namespace {

constexpr std::array<Motor, 2> kDoors{Motor::kLeftDoor, Motor::kRightDoor};
constexpr double kSmooth = 0.4;  // share of a new reading; assumed, 0.2-0.6

}  // namespace

void DoorFeel::Begin() {
  state_ = DoorState::kMoving;
  rested_since_ = -1;
  current_a_ = 0.0;
}

double DoorFeel::opening_m() const { return std::max(opening_m_[0], opening_m_[1]); }

void DoorFeel::Read(const SensorFrame& sensed) {
  double current_a = 1e9;
  for (std::size_t i = 0; i < kDoors.size(); ++i) {
    const auto motor = static_cast<std::size_t>(kDoors[i]);
    const double angle_rad = MotorAngle(nominal_, sensed, kDoors[i]);
    opening_m_[i] = nominal_.door_travel_m - angle_rad * nominal_.door_pinion_radius_m;
    current_a = std::min(current_a, sensed.motors[motor].current_a);
  }
  current_a_ += kSmooth * (current_a - current_a_);
  const bool moved = rested_since_ < 0 ||
                     std::abs(opening_m_[0] - rested_at_m_[0]) > options_.stall_m ||
                     std::abs(opening_m_[1] - rested_at_m_[1]) > options_.stall_m;
  if (moved) {
    rested_at_m_ = opening_m_;
    rested_since_ = sensed.tick;
    state_ = DoorState::kMoving;
    return;
  }
  const double rest_s = static_cast<double>(sensed.tick - rested_since_) * kTickSeconds;
  if (rest_s < options_.stall_s) return;
  // Doors that have not begun to move yet rest as well.
  if (opening_m() > 0.9 * nominal_.door_travel_m && current_a_ < options_.stall_a) return;
  const double least_m = std::min(opening_m_[0], opening_m_[1]);
  if (opening_m() > options_.held_share * 0.5 * nominal_.marks.guide_diameter_m) {
    state_ = DoorState::kPinched;
  } else if (least_m < options_.shut_m || current_a_ < options_.stall_a) {
    state_ = DoorState::kEmpty;
  } else {
    state_ = DoorState::kHeld;
  }
}

}  // namespace dockyard::raposa
