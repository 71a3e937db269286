#include "models/read/load_pins.h"

#include <algorithm>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostPins = 32;

void VisitPlace(Keys& keys, const char* key, const char* meaning, Eigen::Vector3d& p_L) {
  keys.Vector3({key, "m", meaning, Presence::kRequired}, p_L, Between(-10.0, 10.0));
}

void VisitDirection(Keys& keys, double& yaw_rad, double& pitch_rad) {
  keys.Degrees(
      {"yaw_deg", "deg", "where it points or faces: 0 along the link's x axis, 90 along y"},
      yaw_rad, Between(-180.0, 180.0));
  keys.Degrees({"pitch_deg", "deg", "the same, down positive"}, pitch_rad, Between(-90.0, 90.0));
}

void VisitNames(Keys& keys, std::string& contact, std::string& pole, std::string& link) {
  keys.Text({"contact", "", "the electrical contact that it belongs to", Presence::kRequired},
            contact);
  keys.Text({"pole", "", "pins and pads of one pole meet", Presence::kRequired}, pole);
  keys.Text({"link", "", "of the URDF file", Presence::kRequired}, link);
}

void VisitPin(Keys& keys, PinsFile::Pin& file) {
  using enum Presence;
  SpringPin& pin = file.pin;
  VisitNames(keys, pin.contact, pin.pole, file.link);
  VisitPlace(keys, "tip_m", "the tip in the link's frame, when it is out", pin.p_L);
  VisitDirection(keys, file.yaw_rad, file.pitch_rad);
  keys.Number({"stroke_m", "m", "how far it can be pressed in", kRequired}, pin.stroke_m,
              Between(1e-4, 0.1));
  keys.Number({"first_n", "N", "force as it begins to yield", kRequired}, pin.first_n,
              Positive(100.0));
  keys.Number({"last_n", "N", "force at the stroke's end", kRequired}, pin.last_n,
              Positive(1000.0));
  keys.Number({"closes_n", "N", "a lighter touch does not conduct", kRequired}, pin.closes_n,
              Positive(100.0));
  keys.Number({"friction", "", "of the tip across"}, pin.friction, NonNegative(2.0));
  keys.Number({"damping_ns_per_m", "N s/m", "of the plunger in its barrel"}, pin.damping_ns_per_m,
              NonNegative(1e4));
  keys.Check("last_n", pin.last_n > pin.first_n, "more than first_n");
  keys.Check("closes_n", pin.closes_n < pin.last_n, "less than last_n, or it never closes");
}

void VisitPad(Keys& keys, PinsFile::Pad& file) {
  using enum Presence;
  ContactPad& pad = file.pad;
  VisitNames(keys, pad.contact, pad.pole, file.link);
  VisitPlace(keys, "middle_m", "in the link's frame, on the surface that it lies in", pad.X_LP.p);
  VisitDirection(keys, file.yaw_rad, file.pitch_rad);
  keys.Number({"width_m", "m", "level", kRequired}, pad.width_m, Between(1e-4, 1.0));
  keys.Number({"height_m", "m", "across that", kRequired}, pad.height_m, Between(1e-4, 1.0));
}

void VisitSupply(Keys& keys, ContactSupply& supply) {
  using enum Presence;
  keys.Text({"contact", "", "that it feeds", kRequired}, supply.contact);
  keys.Number({"open_v", "V", "without a load", kRequired}, supply.open_v, Positive(1000.0));
  keys.Number({"inner_ohm", "ohm", "of source and cable"}, supply.inner_ohm, NonNegative(100.0));
  keys.Number({"touch_ohm", "ohm", "of each pin on its pad"}, supply.touch_ohm, NonNegative(100.0));
  keys.Number({"draws_a", "A", "by the robot's charger"}, supply.draws_a, NonNegative(1000.0));
}

Eigen::Matrix3d Towards(double yaw_rad, double pitch_rad) {
  return RotZ(yaw_rad) * RotY(pitch_rad);
}

// z out along x of the turned link, x level.
Eigen::Matrix3d FaceAxes(double yaw_rad, double pitch_rad) {
  Eigen::Matrix3d out_along_x;
  out_along_x << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  return Towards(yaw_rad, pitch_rad) * out_along_x;
}

std::string PlaceOf(const YamlReader& in, const char* list, std::size_t i) {
  return in.List(list, 0, 1000).items[i].place.Text() + ": " +
         YamlReader::PathOf(in.PathOf(list), i) + ".link";
}

}  // namespace

void VisitPins(Keys& keys, PinsFile& file) {
  keys.Items({"contact_pins", "", "spring pins of electrical contacts", Presence::kUnset},
             file.pins, 0, kMostPins, VisitPin);
  keys.Items({"contact_pads", "", "conducting plates that pins meet", Presence::kUnset}, file.pads,
             0, kMostPins, VisitPad);
  keys.Items({"supplies", "", "the sources behind contacts", Presence::kUnset}, file.supplies, 0,
             kMostPins, VisitSupply);
}

ElectricalParts TakePins(const YamlReader& in, const PinsFile& file, const LinkFinder& link_of) {
  ElectricalParts parts;
  parts.supplies = file.supplies;
  for (std::size_t i = 0; i < file.pins.size(); ++i) {
    const PinsFile::Pin& each = file.pins[i];
    const LinkPlace at = link_of(each.link, PlaceOf(in, "contact_pins", i));
    SpringPin& pin = parts.pins.emplace_back(each.pin);
    pin.link = at.link;
    pin.p_L = at.X_LF * each.pin.p_L;
    pin.out_L = at.X_LF.R * Towards(each.yaw_rad, each.pitch_rad).col(0);
  }
  for (std::size_t i = 0; i < file.pads.size(); ++i) {
    const PinsFile::Pad& each = file.pads[i];
    const LinkPlace at = link_of(each.link, PlaceOf(in, "contact_pads", i));
    ContactPad& pad = parts.pads.emplace_back(each.pad);
    pad.link = at.link;
    pad.X_LP = at.X_LF * Pose3{FaceAxes(each.yaw_rad, each.pitch_rad), each.pad.X_LP.p};
  }
  return parts;
}

}  // namespace dockyard
