// Spring pins of one body that press on another body's solids, and which of its pads they meet.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/parts/spring_pins.h"
#include "sim/rigid/convex_body.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard {

/// A solid of a link, in the link's frame.
struct LinkSolid {
  int link = 0;  // by its number in the model
  ConvexBody body_L{};
};

/// A body of the world with pins, pads and solids. `places`: where the model's links are in its
/// tree.
struct PinSide {
  int body = 0;
  std::vector<int> places{};
  std::vector<SpringPin> pins{};
  std::vector<ContactPad> pads{};
  std::vector<LinkSolid> solids{};
};

/// A pad lies in the surface that it belongs to, off it by this at most. Assumed, 0.5-3 mm.
inline constexpr double kOffPad_m = 1.5e-3;
/// Whether one of the pads, of the pin's own contact and pole, is at a point of a link.
bool MeetsPad(const SpringPin& pin, const std::vector<ContactPad>& pads, int link,
              const Eigen::Vector3d& p_L);

/// The force of a pin that is pressed in by this depth [N]; rises from the first touch on, and
/// steeply once the stroke is used up.
double PinForce(const SpringPin& pin, double pressed_m);

class SpringPins {
 public:
  SpringPins() = default;
  /// Both sides may have pins and pads.
  SpringPins(PinSide a, PinSide b);

  /// Adds the contacts of the next step to the world. Who is touched wakes.
  void AddContacts(RigidWorld& world);
  /// After the world's step: what they bore.
  void TakeForces(const RigidWorld& world, double step_s);

  /// A pin in the last step.
  struct State {
    double pressed_m = 0.0, force_n = 0.0;
    bool on_pad = false;  // of its own contact and pole
    bool closed = false;
  };
  /// Pins of a first, then those of b.
  const std::vector<State>& states() const { return states_; }
  /// Whether each pole of the contact is closed; false for a contact without pins.
  bool IsClosed(const std::string& contact) const;
  /// Sum over its pins [N].
  double Force(const std::string& contact) const;
  /// The worst of its tips: from the middle of the nearest pad of its pole, along the pad [m]; 0
  /// without pads.
  double Offset(const std::string& contact, const RigidWorld& world) const;
  int count() const { return static_cast<int>(states_.size()); }

 private:
  struct Pressed {
    int contact = 0, pin = 0;
  };
  const SpringPin& pin(int i) const;
  void AddSide(const PinSide& from, const PinSide& on, int first, RigidWorld& world);

  PinSide a_, b_;
  std::vector<State> states_;
  std::vector<Pressed> pressed_;
};

}  // namespace dockyard
