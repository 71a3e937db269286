// What the doors' own encoders and currents say of the guide between them.
#pragma once

#include <array>

#include "controller/raposa/dockyard_options.h"
#include "controller/raposa/nominal/nominal.h"

namespace dockyard::raposa {

enum class DoorState {
  kMoving,
  kHeld,     // stalled on the guide's rear cone
  kEmpty,    // closed on nothing
  kPinched,  // stalled on something wider: the guide's widest part
};

class DoorFeel {
 public:
  DoorFeel(const Nominal& nominal, const DockyardOptions& options)
      : nominal_(nominal), options_(options) {}
  /// The doors are told to close from now on.
  void Begin();
  /// Each control period with the readings.
  void Read(const SensorFrame& sensed);
  DoorState state() const { return state_; }
  /// The wider of both openings, from closed.
  double opening_m() const;

 private:
  Nominal nominal_;
  DockyardOptions options_;
  DoorState state_ = DoorState::kMoving;
  std::array<double, 2> opening_m_{}, rested_at_m_{};
  Tick rested_since_ = -1;
  double current_a_ = 0.0;  // of the door that presses less, smoothed
};

}  // namespace dockyard::raposa
