#include "sim/vehicles/belt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"
#include "sim/base/hash.h"
#include "sim/vehicles/belt_place.h"

namespace dockyard {
namespace {

// Way of the belt over which its rolling loss turns round. Assumed, range 0.3-3 mm: the shear of
// the rubber that is kneaded.
constexpr double kLossTurns_m = 0.001;
// Where a pad meets a roller its arc is taken as a parabola about the lowest point: over a pad's
// length, in radii, it is off by 1/24 of this to the fourth, 0.5 % of the radius.
constexpr double kLongestPad = 0.6;
// How much higher than at three places under a roller the ground may be between them, in pads.
// Assumed, range 0.2-1.
constexpr double kMargin = 0.5;

}  // namespace

Belt::Belt(const BeltModel& belt, const BeltGround& ground)
    : belt_(belt), grounds_{{ground}}, loop_(MakeBeltLoop(belt)) {
  DOCKYARD_CHECK(belt.pads > 0 && belt.width_m > 0.0 && belt.stiffness_pa_per_m > 0.0);
  DOCKYARD_CHECK(belt.shear_stiffness_pa_per_m > 0.0 && ground.shear_displacement_m >= 0.0);
  pitch_m_ = loop_.length_m / belt.pads;
  DOCKYARD_CHECK(pitch_m_ < kLongestPad * std::min(belt.front.radius_m, belt.rear.radius_m));
  pads_.resize(static_cast<std::size_t>(belt.pads));
}

Belt::Belt(const BeltModel& belt, const SoilModel& soil, double rolling_loss)
    : Belt(belt, BeltGround{.friction = std::tan(soil.friction_angle_rad),
                            .cohesion_pa = soil.cohesion_pa,
                            .rolling_loss = rolling_loss}) {
  const SoilLaws laws = MakeRimLaws(soil, belt.width_m);
  const double rebound = 1.0 / (1.0 / belt.stiffness_pa_per_m + 1.0 / laws.elastic_pa_per_m);
  grounds_.front().soil = laws;
  grounds_.front().plate = {laws.k, laws.n, rebound};
}

BeltLoad Belt::Step(const HeightGrid& ground, const LinkMotion& carrier, double belt_speed_m_s,
                    double dt_s) {
  BeltPlace at(ground, carrier, belt_.y_m);
  at.speed_m_s = belt_speed_m_s;
  at.dt_s = dt_s;
  std::array<BeltWindow, 4> windows;
  for (std::size_t i = 0; i < 4; ++i) {
    windows[i] = WindowOf(loop_.segments[i], at, kMargin * pitch_m_);
  }
  travel_m_ += belt_speed_m_s * dt_s;
  travel_m_ -= loop_.length_m * std::floor(travel_m_ / loop_.length_m);
  ++step_;
  // Round the loop from behind a segment that touches nothing, so that the parts of a pad that lies
  // over two segments follow each other.
  std::size_t start = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (windows[i].begin_m >= windows[i].end_m) start = i + 1;
  }
  BeltLoad load;
  BeltTouch touch;
  int touching = -1;
  for (std::size_t i = start; i < start + 4; ++i) {
    const BeltWindow& window = windows[i % 4];
    int k = static_cast<int>(std::floor((window.begin_m - travel_m_) / pitch_m_));
    for (; travel_m_ + k * pitch_m_ < window.end_m; ++k) {
      const double begin_m = std::max(window.begin_m, travel_m_ + k * pitch_m_);
      const double end_m = std::min(window.end_m, travel_m_ + (k + 1) * pitch_m_);
      if (begin_m >= end_m) continue;
      // By rounding the loop's end may be the begin of the pad after its last one.
      const int pad = ((k % belt_.pads) + belt_.pads) % belt_.pads;
      if (pad != touching) {
        LoadPad(touching, touch, ground, at, load);
        touch = {};
        touching = pad;
      }
      AddPiece(loop_.segments[i % 4], begin_m, end_m, at, touch);
    }
  }
  LoadPad(touching, touch, ground, at, load);
  turned_m_ = std::clamp(turned_m_ + belt_speed_m_s * dt_s, -kLossTurns_m, kLossTurns_m);
  const double rolling_loss = grounds_.at(ground.SoilAt(carrier.X_GL.p)).firm.rolling_loss;
  const double loss_n = rolling_loss * load.normal_n * (turned_m_ / kLossTurns_m);
  load.drive_torque_nm = belt_.sprocket_radius_m * (load.traction_n + loss_n);
  return load;
}

double Belt::Pressure(const Ground& on, double depth_m, Pad& pad) const {
  return on.soil ? PressPlate(on.plate, depth_m, pad.sunk_m) : belt_.stiffness_pa_per_m * depth_m;
}

void Belt::LoadPad(int index, const BeltTouch& touch, const HeightGrid& ground, BeltPlace& at,
                   BeltLoad& load) {
  if (!(touch.area_m2 > 0.0)) return;
  Pad& pad = pads_.at(static_cast<std::size_t>(index));
  if (pad.step != step_ - 1) pad = {};
  pad.step = step_;
  const double per_area = 1.0 / touch.area_m2, per_length = 1.0 / touch.length_m;
  const Eigen::Vector3d arm_G = per_area * touch.arm_G;
  const Ground& on = grounds_.at(ground.SoilAt(at.p_G + arm_G));
  // Firm ground is elastic and presses along its own normal. Soil stays down behind a roller, so
  // that what presses on the roller before it leans against the way: the soil's resistance.
  const Eigen::Vector3d& pressing_G = on.soil ? touch.in_G : touch.up_G;
  if (pressing_G != touch.area_m2 * at.n_G) at.Face(pressing_G.normalized());
  const Eigen::Vector3d v_G = at.v_G + at.w_G.cross(arm_G);
  const double depth_m = touch.area_m2 * per_length, area_m2 = belt_.width_m * touch.length_m;
  const double damping_pa = belt_.damping_pa_s_per_m * per_area *
                            v_G.dot(touch.up_G);  // the carrier's way, not the belt's
  const double normal_n = area_m2 * std::max(0.0, Pressure(on, depth_m, pad) - damping_pa);

  const Eigen::Vector2d slide_m_s(v_G.dot(at.forward_G) - at.speed_m_s, v_G.dot(at.left_G));
  // What has run on in this step has not slid yet.
  const double run_on_m =
      std::clamp(touch.length_m - pad.length_m, 0.0, std::fabs(at.speed_m_s) * at.dt_s);
  const double stays = 1.0 - run_on_m * per_length;
  pad.length_m = touch.length_m;
  pad.bend_m = stays * pad.bend_m + at.dt_s * slide_m_s;
  pad.slid_m = stays * pad.slid_m + at.dt_s * slide_m_s;
  const double here = FrictionFactor(patches_, at.p_G.x() + arm_G.x(), at.p_G.y() + arm_G.y());
  const double strength_n =
      here * (on.firm.friction * normal_n + std::min(on.firm.cohesion_pa * area_m2, normal_n));
  const double shear_m =
      on.soil ? ShearModulus(*on.soil, ContactDepth(depth_m)) : on.firm.shear_displacement_m;
  const Eigen::Vector2d grip = Grip(slide_m_s, strength_n, shear_m, pad);
  const double side_n = on.soil ? touch.length_m * BulldozingResistance(*on.soil, pad.sunk_m) : 0.0;
  const double forward_n = strength_n * grip.x();
  const double left_n = (on.firm.lateral_ratio * strength_n + side_n) * grip.y();

  const Eigen::Vector3d force_G = normal_n * at.n_G + forward_n * at.forward_G + left_n * at.left_G;
  load.force_G += force_G;
  load.torque_G += arm_G.cross(force_G);
  load.normal_n += normal_n;
  load.traction_n += forward_n;
  load.front_m = std::max(load.front_m, touch.front_m);
  load.rear_m = std::min(load.rear_m, touch.rear_m);
  ++load.pads;
}

/// Share of the strength that stands against the sliding, forward and left; clips the pad's bend.
Eigen::Vector2d Belt::Grip(const Eigen::Vector2d& slide_m_s, double strength_n, double shear_m,
                           Pad& pad) const {
  if (!(strength_n > 0.0)) {
    pad.bend_m.setZero();
    return Eigen::Vector2d::Zero();
  }
  const double most = shear_m > 0.0 ? -std::expm1(-pad.slid_m.norm() / shear_m) : 1.0;
  const double per_strength = belt_.width_m * pad.length_m / strength_n;
  const double stiffness = per_strength * belt_.shear_stiffness_pa_per_m;
  const double held = stiffness * pad.bend_m.norm();
  if (held > most) pad.bend_m *= most / held;
  const Eigen::Vector2d grip =
      -stiffness * pad.bend_m - per_strength * belt_.shear_damping_pa_s_per_m * slide_m_s;
  const double size = grip.norm();
  return size > most ? (most / size) * grip : grip;
}

std::uint64_t Belt::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashDouble(HashDouble(seed, travel_m_), turned_m_);
  for (const Pad& last : pads_) {
    const Pad pad = last.step == step_ ? last : Pad{};
    for (const double value : {pad.slid_m.x(), pad.slid_m.y(), pad.bend_m.x(), pad.bend_m.y(),
                               pad.length_m, pad.sunk_m}) {
      hash = HashDouble(hash, value);
    }
  }
  return hash;
}

}  // namespace dockyard
