// The electrical contact that closes when the robot is docked.
#pragma once

#include "controller/base/result.h"
#include "controller/custom/nominal/nominal.h"
#include "controller/custom/refusal.h"
#include "controller/io/sensors.h"

namespace dockyard::custom {

class Contact {
 public:
  /// By the sensor <contact>_voltage_v, else by the switch <contact>_closed.
  static Result<Contact, Refusal> Of(const Nominal& nominal);

  void Read(const SensorFrame& sensed);
  bool exists() const { return sensor_ >= 0; }
  bool closed() const { return closed_; }
  /// For how long it has been closed without a break.
  double closed_s(Tick now) const {
    return closed_ ? kTickSeconds * static_cast<double>(now - since_) : 0.0;
  }
  double voltage_v() const { return voltage_v_; }

 private:
  int sensor_ = -1;
  bool is_voltage_ = false;
  double nominal_v_ = 0.0, voltage_v_ = 0.0;
  bool closed_ = false;
  Tick since_ = 0;
};

}  // namespace dockyard::custom
