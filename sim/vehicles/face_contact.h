// An instrument's face at the end of a mast, against a boulder that does not move: contact switches
// and the rim of the can, each a contact of the world. How the mast gives way is the tree's: the
// can slides on a spring (mast_body.h).
#pragma once

#include <array>
#include <vector>

#include "models/parts/mast_model.h"
#include "sim/rigid/rigid_world.h"
#include "sim/rigid/star_body.h"

namespace dockyard {

inline constexpr int kFaceSwitches = 3;

class FaceContact {
 public:
  /// `can`: the link whose x axis is the tool's; the switches' tips are at face_m.
  FaceContact(const InstrumentModel& instrument, const BodyLink& can, double face_m);

  /// Adds the contacts of the next step to the world, of points that lie in the boulder. They yield
  /// by their springs and rub by Coulomb's law.
  void AddContacts(const StarBody& body_G, RigidWorld& world);
  /// After the world's step: what they bore.
  void TakeForces(const RigidWorld& world, double step_s);

  /// Of the last step: whether a switch is closed, and the sum of the points' normal forces [N].
  const std::array<bool, kFaceSwitches>& closed() const { return closed_; }
  double force_n() const { return force_n_; }

 private:
  struct Point {
    Eigen::Vector3d p_L{0, 0, 0};
    ContactMaterial material{};
  };
  /// A contact of the step by its number in the world.
  struct Pressed {
    int contact = 0;
    std::size_t point = 0;
  };

  BodyLink can_;
  double closes_n_ = 0.0;
  double reach_m_ = 0.0;  // of a sphere about the face's middle that holds all points
  Eigen::Vector3d p_L_middle_{0, 0, 0};
  std::vector<Point> points_;  // the switches first
  std::vector<Pressed> pressed_;
  std::array<bool, kFaceSwitches> closed_{};
  double force_n_ = 0.0;
};

}  // namespace dockyard
