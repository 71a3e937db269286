#include "controller/custom/contact.h"

#include "controller/base/check.h"

namespace dockyard::custom {
namespace {

// Closed above this share of the source's voltage: an open contact has none, a closed one nearly
// all. Assumed, 0.3-0.8.
constexpr double kClosedShare = 0.5;

}  // namespace

Result<Contact, Refusal> Contact::Of(const Nominal& nominal) {
  Contact contact;
  if (nominal.contact.empty()) return contact;
  const std::string voltage = nominal.contact + "_voltage_v", closed = nominal.contact + "_closed";
  contact.sensor_ = SensorOf(nominal, voltage);
  contact.is_voltage_ = contact.exists();
  contact.nominal_v_ = nominal.contact_voltage_v;
  if (!contact.exists()) contact.sensor_ = SensorOf(nominal, closed);
  if (!contact.exists())
    return Refusal{"contact " + nominal.contact + ": expected a sensor " + voltage + " or " +
                   closed};
  if (contact.is_voltage_ && !(contact.nominal_v_ > 0.0))
    return Refusal{"contact " + nominal.contact +
                   ": expected a voltage above zero: a source of this contact, " +
                   "under supplies of the dock's or the robot's file"};
  return contact;
}

void Contact::Read(const SensorFrame& sensed) {
  if (!exists()) return;
  const auto i = static_cast<std::size_t>(sensor_);
  DOCKYARD_CHECK(i < sensed.values.size());
  const double value = sensed.values[i];
  if (is_voltage_) voltage_v_ = value;
  const bool closed = value > (is_voltage_ ? kClosedShare * nominal_v_ : 0.5);
  if (closed && !closed_) since_ = sensed.tick;
  closed_ = closed;
}

}  // namespace dockyard::custom
