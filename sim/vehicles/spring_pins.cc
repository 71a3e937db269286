#include "sim/vehicles/spring_pins.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace dockyard {
namespace {

using Eigen::Vector3d;

// How a tip of metal yields before its spring does, and a pin that is pressed in whole: 0.1 mm
// under 20 N. Assumed, 5e4-1e6 N/m.
constexpr double kHard_n_per_m = 2e5;
// The numbers of other pairs begin at 0, or are near to it.
constexpr std::int64_t kFirstPair = -(std::int64_t{1} << 40);

/// The piece of the line of force at this depth: force there, and its slope.
struct ForceAt {
  double force_n = 0.0, slope_n_per_m = 0.0;
};

ForceAt Line(const SpringPin& pin, double pressed_m) {
  const double touch_m = pin.first_n / kHard_n_per_m;
  if (pressed_m <= touch_m) return {kHard_n_per_m * pressed_m, kHard_n_per_m};
  const double slope = (pin.last_n - pin.first_n) / pin.stroke_m;
  const double yielded_m = pressed_m - touch_m;
  if (yielded_m <= pin.stroke_m) return {pin.first_n + slope * yielded_m, slope};
  return {pin.last_n + kHard_n_per_m * (yielded_m - pin.stroke_m), kHard_n_per_m};
}

const Pose3& PoseOf(const PinSide& side, int link, const RigidWorld& world) {
  return world.body(side.body).motion(side.places[static_cast<std::size_t>(link)]).X_GL;
}

/// How far along the pin, from its root in the link to its tip, a solid begins: share 0 to 1.
struct Hit {
  double share = 1.0;
  int link = 0;
};

std::optional<Hit> FirstHit(const PinSide& on, const RigidWorld& world, const Vector3d& root_G,
                            const Vector3d& tip_G) {
  std::optional<Hit> first;
  for (const LinkSolid& solid : on.solids) {
    const Pose3& X_GL = PoseOf(on, solid.link, world);
    const double reach_m = solid.body_L.radius_m + 2.0 * (tip_G - root_G).norm();
    const Vector3d apart_G = tip_G - X_GL * solid.body_L.centre;
    if (apart_G.squaredNorm() > reach_m * reach_m) continue;
    const Pose3 X_LG = Inverse(X_GL);
    const Vector3d root_L = X_LG * root_G, tip_L = X_LG * tip_G;
    const double far_m = solid.body_L.radius_m + (tip_L - root_L).norm();
    if ((tip_L - solid.body_L.centre).squaredNorm() > far_m * far_m) continue;
    const std::optional<PressedEdge> in = PressEdge(solid.body_L, root_L, tip_L);
    if (in && in->to > in->from && (!first || in->from < first->share)) {
      first = Hit{in->from, solid.link};
    }
  }
  return first;
}

}  // namespace

bool MeetsPad(const SpringPin& pin, const std::vector<ContactPad>& pads, int link,
              const Vector3d& p_L) {
  return std::any_of(pads.begin(), pads.end(), [&](const ContactPad& pad) {
    if (pad.contact != pin.contact || pad.pole != pin.pole || pad.link != link) return false;
    const Vector3d p_P = Inverse(pad.X_LP) * p_L;
    return std::abs(p_P.x()) <= 0.5 * pad.width_m && std::abs(p_P.y()) <= 0.5 * pad.height_m &&
           std::abs(p_P.z()) <= kOffPad_m;
  });
}

double PinForce(const SpringPin& pin, double pressed_m) {
  return pressed_m <= 0.0 ? 0.0 : Line(pin, pressed_m).force_n;
}

SpringPins::SpringPins(PinSide a, PinSide b)
    : a_(std::move(a)), b_(std::move(b)), states_(a_.pins.size() + b_.pins.size()) {}

const SpringPin& SpringPins::pin(int i) const {
  const auto at = static_cast<std::size_t>(i);
  return at < a_.pins.size() ? a_.pins[at] : b_.pins[at - a_.pins.size()];
}

void SpringPins::AddContacts(RigidWorld& world) {
  pressed_.clear();
  std::fill(states_.begin(), states_.end(), State{});
  AddSide(a_, b_, 0, world);
  AddSide(b_, a_, static_cast<int>(a_.pins.size()), world);
}

// The plunger slides along its axis, so a pad that is not square to it pushes along the axis, too.
void SpringPins::AddSide(const PinSide& from, const PinSide& on, int first, RigidWorld& world) {
  if (world.asleep(from.body) && world.asleep(on.body)) return;
  for (std::size_t i = 0; i < from.pins.size(); ++i) {
    const SpringPin& pin = from.pins[i];
    const int place = from.places[static_cast<std::size_t>(pin.link)];
    const Pose3& X_GL = world.body(from.body).motion(place).X_GL;
    // Beyond the stroke, so that a pin that is pressed in whole still bears.
    const double length_m = 2.0 * pin.stroke_m;
    const Vector3d tip_G = X_GL * pin.p_L, out_G = X_GL.R * pin.out_L;
    const Vector3d root_G = tip_G - length_m * out_G;
    const std::optional<Hit> hit = FirstHit(on, world, root_G, tip_G);
    if (!hit) continue;
    for (const int body : {from.body, on.body}) {
      if (world.asleep(body)) world.SetAsleep(body, false);
    }
    const int number = first + static_cast<int>(i);
    State& state = states_[static_cast<std::size_t>(number)];
    state.pressed_m = (1.0 - hit->share) * length_m;
    const Vector3d p_G = root_G + hit->share * (tip_G - root_G);
    const int on_place = on.places[static_cast<std::size_t>(hit->link)];
    const Pose3& X_GO = world.body(on.body).motion(on_place).X_GL;
    state.on_pad = MeetsPad(pin, on.pads, hit->link, Inverse(X_GO) * p_G);
    const ForceAt line = Line(pin, state.pressed_m);
    const int contact = world.AddContact(
        {.a = {from.body, place},
         .b = {on.body, on_place},
         .pair = kFirstPair + number,
         .p_G = p_G,
         .normal_G = -out_G,
         .gap_m = -line.force_n / line.slope_n_per_m,
         .material = {line.slope_n_per_m, pin.damping_ns_per_m, pin.friction, 0.0}});
    pressed_.push_back({contact, number});
  }
}

void SpringPins::TakeForces(const RigidWorld& world, double step_s) {
  for (const Pressed& at : pressed_) {
    const WorldContact& contact = world.contacts()[static_cast<std::size_t>(at.contact)];
    State& state = states_[static_cast<std::size_t>(at.pin)];
    state.force_n = contact.normal_G.dot(contact.impulse_G) / step_s;
    state.closed = state.on_pad && state.force_n >= pin(at.pin).closes_n;
  }
}

bool SpringPins::IsClosed(const std::string& contact) const {
  bool any = false;
  for (int i = 0; i < count(); ++i) {
    if (pin(i).contact != contact) continue;
    any = true;
    bool closed = false;  // some pin of the same pole
    for (int k = 0; k < count(); ++k) {
      closed = closed || (pin(k).contact == contact && pin(k).pole == pin(i).pole &&
                          states_[static_cast<std::size_t>(k)].closed);
    }
    if (!closed) return false;
  }
  return any;
}

double SpringPins::Force(const std::string& contact) const {
  double sum_n = 0.0;
  for (int i = 0; i < count(); ++i) {
    if (pin(i).contact == contact) sum_n += states_[static_cast<std::size_t>(i)].force_n;
  }
  return sum_n;
}

double SpringPins::Offset(const std::string& contact, const RigidWorld& world) const {
  double worst_m = 0.0;
  const auto add = [&](const PinSide& from, const PinSide& on) {
    for (const SpringPin& pin : from.pins) {
      if (pin.contact != contact) continue;
      const Vector3d tip_G = PoseOf(from, pin.link, world) * pin.p_L;
      double nearest_m = -1.0;
      for (const ContactPad& pad : on.pads) {
        if (pad.contact != contact || pad.pole != pin.pole) continue;
        const Vector3d p_P = Inverse(PoseOf(on, pad.link, world) * pad.X_LP) * tip_G;
        const double off_m = p_P.head<2>().norm();
        if (nearest_m < 0.0 || off_m < nearest_m) nearest_m = off_m;
      }
      worst_m = std::max(worst_m, nearest_m);
    }
  };
  add(a_, b_);
  add(b_, a_);
  return worst_m;
}

}  // namespace dockyard
