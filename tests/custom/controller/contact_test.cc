#include "controller/custom/contact.h"

#include <gtest/gtest.h>

namespace dockyard::custom {
namespace {

SensorFrame Frame(Tick tick, double value) {
  SensorFrame frame;
  frame.tick = tick;
  frame.values = {7.0, value};
  return frame;
}

TEST(Contact, IsClosedAboveHalfOfTheNominalVoltage) {
  Nominal nominal;
  nominal.contact = "charger";
  nominal.contact_voltage_v = 24.0;
  nominal.sensors = {"range_m", "charger_voltage_v"};
  Contact contact = *Contact::Of(nominal);
  contact.Read(Frame(0, 11.9));
  EXPECT_FALSE(contact.closed());
  contact.Read(Frame(20, 12.1));
  EXPECT_TRUE(contact.closed());
  contact.Read(Frame(520, 24.0));
  EXPECT_DOUBLE_EQ(contact.closed_s(520), 0.5);
  contact.Read(Frame(540, 0.0));
  contact.Read(Frame(560, 24.0));
  EXPECT_DOUBLE_EQ(contact.closed_s(560), 0.0);
}

TEST(Contact, MayBeASwitchOrMissing) {
  Nominal nominal;
  nominal.sensors = {"range_m", "charger_closed"};
  EXPECT_FALSE(Contact::Of(nominal)->exists());
  nominal.contact = "charger";
  Contact contact = *Contact::Of(nominal);
  contact.Read(Frame(0, 1.0));
  EXPECT_TRUE(contact.closed());
  nominal.contact = "other";
  EXPECT_FALSE(Contact::Of(nominal));
}

}  // namespace
}  // namespace dockyard::custom
