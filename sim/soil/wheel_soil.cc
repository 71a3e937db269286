#include "sim/soil/wheel_soil.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

constexpr int kStrips = 144;  // 2.5 deg each
// Ground this much above the highest of the sampled points may touch the wheel; assumed, range
// 0.005-0.03: below it ruts' walls between the samples are missed, above it time is lost.
constexpr double kGroundMargin_m = 0.015;
// Time between two passes in which the rut is pressed and slopes beside it slump; assumed, range
// 1-8 ms: at 0.05 m/s a wheel goes 0.1 mm in it, of a cell of 23 mm. A time, not a count of steps:
// the soil must not run faster when steps are short.
constexpr double kRutPeriod_s = 2e-3;

}  // namespace

WheelSoil::WheelSoil(const WheelModel& wheel, const SoilModel& soil)
    : wheel_(wheel), rim_(MakeRimLaws(soil, wheel.width_m)) {
  DOCKYARD_CHECK(wheel.rim_radius_m > 0.0 && wheel.width_m > 0.0 && wheel.paddle_count >= 0);
  bearing_radius_m_ = wheel.rim_radius_m;
  line_width_m_ = wheel.width_m / kLines;
  if (wheel.paddle_count > 0) {
    const double height = wheel.paddle_height_m;
    DOCKYARD_CHECK(height > 0.0 && wheel.paddle_thickness_m > 0.0);
    tip_ = MakeTipLaws(soil, wheel.paddle_thickness_m, wheel.width_m);
    paddle_spacing_m_ = 2.0 * kPi * wheel.rim_radius_m / wheel.paddle_count;
    rim_share_ = std::max(0.0, 1.0 - wheel.paddle_thickness_m / paddle_spacing_m_);
    // Soil between two paddles is caught in the passive wedges before the one and behind the other,
    // h tan(45 deg + phi/2) long: two triangles that fill this share of the gap.
    const double gap = std::max(1e-3 * paddle_spacing_m_, rim_share_ * paddle_spacing_m_);
    const double filled = std::min(1.0, height * rim_.sqrt_n_phi / gap);
    bearing_radius_m_ += height * filled;
    // Of this share of the rim a share as large carries soil out to the tips.
    rim_.tan_caught = filled * filled * (rim_.tan_phi - rim_.tan_rim);
  }
  strip_length_m_ = bearing_radius_m_ * 2.0 * kPi / kStrips;
  strips_.resize(kStrips);
  for (int i = 0; i < kStrips; ++i) {
    const double angle = (i + 0.5) * 2.0 * kPi / kStrips;
    strips_[i].cos = std::cos(angle);
    strips_[i].sin = std::sin(angle);
  }
  paddles_.resize(wheel.paddle_count);
  for (int i = 0; i < wheel.paddle_count; ++i) {
    const double angle = wheel.phase_rad + i * 2.0 * kPi / wheel.paddle_count;
    paddles_[i].cos = std::cos(angle);
    paddles_[i].sin = std::sin(angle);
  }
}

void WheelSoil::FindTop(const HeightGrid& grid, WheelFrame& frame) const {
  const double reach = wheel_.rim_radius_m + wheel_.paddle_height_m;
  double top = -kNoFloor_m;
  for (int i = -2; i <= 2; ++i) {
    const double ahead = 0.5 * i * reach;
    const GridCell at =
        CellAt(grid, frame.p_G.x() + ahead * frame.y_G.y(), frame.p_G.y() - ahead * frame.y_G.x());
    top = std::max(top, Interpolate(grid, grid.undisturbed_m, at));
  }
  frame.top_m = top + kGroundMargin_m;
}

void WheelSoil::FollowMotion(const WheelFrame& frame) {
  // Level and forward: the axle's left, turned down to the ground and to the right.
  const Eigen::Vector3d ahead_G(frame.y_G.y(), -frame.y_G.x(), 0.0);
  const double height = PaddleReach(wheel_);
  WheelWay way;
  way.rolled_m = frame.dt_s * frame.w_K.y() * (wheel_.rim_radius_m + height);
  way.ahead_m = frame.dt_s *
                (frame.v_K.x() * frame.x_G.dot(ahead_G) + frame.v_K.z() * frame.z_G.dot(ahead_G));
  way.left_m = frame.dt_s * frame.v_K.y();
  way.up_m = frame.dt_s * (frame.v_K.x() * frame.x_G.z() + frame.v_K.z() * frame.z_G.z());
  Follow(travel_, way, {wheel_.rim_radius_m, std::min(height, sinkage_m_)});
}

/// Adds the loads of one row across the width, the outer two first, so that a mirrored wheel adds
/// the same numbers.
void WheelSoil::AddRow(const SpokeAxes& axes, double radius_m,
                       const std::array<SpokeLoad, kLines>& row, LoadSum& sum) const {
  const SpokeLoad load{(row[0].r + row[2].r) + row[1].r, (row[0].t + row[2].t) + row[1].t,
                       (row[0].a + row[2].a) + row[1].a};
  sum.Add(axes, radius_m, load, -line_width_m_ * (row[2].t - row[0].t),
          line_width_m_ * (row[2].r - row[0].r));
}

void WheelSoil::AddToEnvelope(const std::array<SpokeLoad, kLines>& row) {
  envelope_.pressed_n -= (row[0].r + row[2].r) + row[1].r;
  envelope_.rim_and_tips_n += (row[0].t + row[2].t) + row[1].t;
}

void WheelSoil::AddStrip(const HeightGrid& grid, const WheelFrame& frame, Strip& strip,
                         LoadSum& sum) {
  const SpokeAxes axes = frame.Along(strip.cos, strip.sin);
  const double area = rim_share_ * strip_length_m_ * line_width_m_;
  std::array<SpokeLoad, kLines> row;
  std::array<double, kLines> depth;
  for (int i = 0; i < kLines; ++i) {
    const PatchPlace at(grid, frame, axes, bearing_radius_m_, (i - 1) * line_width_m_,
                        wheel_.rim_radius_m);
    row[i] = LoadPatch(rim_, travel_, contact_depth_m_, at, area, frame.dt_s, strip.patches[i]);
    depth[i] = at.sinkage_m();
  }
  const double deepest = std::max(std::max(depth[0], depth[2]), depth[1]);
  if (deepest <= 0.0) {
    strip.side = {};
    return;
  }
  sum.Touch(deepest);
  AddRow(axes, bearing_radius_m_, row, sum);
  if (!paddles_.empty()) AddToEnvelope(row);
  const SideStrip side{bearing_radius_m_, 0.5 * wheel_.width_m, strip_length_m_, depth[0],
                       depth[2]};
  AddSideWall(rim_, contact_depth_m_, axes, side, frame.dt_s, strip.side, sum);
}

void WheelSoil::MoveWindow(int first, int count) {
  if (first == first_strip_ && count == strip_count_) return;
  for (int i = 0; i < strip_count_; ++i) {
    const int index = (first_strip_ + i) % kStrips;
    if ((index - first + kStrips) % kStrips < count) continue;
    strips_[index].patches = {};
    strips_[index].side = {};
  }
  first_strip_ = first;
  strip_count_ = count;
}

void WheelSoil::AddRim(const HeightGrid& grid, const WheelFrame& frame, LoadSum& sum) {
  // The strips on both sides of the lowest one that are below the highest ground.
  const double down = std::atan2(frame.z_G.z(), -frame.x_G.z());
  const double upright = std::sqrt(1.0 - frame.y_G.z() * frame.y_G.z());
  const double clearance =
      frame.p_G.z() - std::fabs(frame.y_G.z()) * 0.5 * wheel_.width_m - frame.top_m;
  const double ratio = clearance / (bearing_radius_m_ * upright);
  const double step = 2.0 * kPi / kStrips;
  int first = 0, count = 0;
  if (ratio < 1.0) {
    const double half = std::acos(std::max(0.0, ratio));
    first = static_cast<int>(std::ceil((down - half) / step - 0.5));
    count = static_cast<int>(std::floor((down + half) / step - 0.5)) - first + 1;
    first = ((first % kStrips) + kStrips) % kStrips;
  }
  MoveWindow(first, count);
  for (int i = 0; i < count; ++i) AddStrip(grid, frame, strips_[(first + i) % kStrips], sum);
}

/// Passive pressure on a paddle's face, buried from the tip up.
SpokeLoad WheelSoil::LoadFace(const PatchPlace& tip, const SpokeVelocity& v, double rise_m,
                              double dt_s, Mobilisation& face) const {
  const double height = wheel_.paddle_height_m;
  face = Shear(face, v.t * dt_s, v.a * dt_s, ShearModulus(tip_, contact_depth_m_));
  // The soil that a face pushes heaps against it, up to the rim once the rim bears on caught soil.
  const double caught_m = bearing_radius_m_ - wheel_.rim_radius_m;
  const double free_share = std::max(0.1, 1.0 - caught_m / height);
  const double share = std::min(1.0, (tip.surface_m - tip.z_m) / (free_share * rise_m));
  const double depth = std::max(0.0, tip.sinkage_m() - 0.5 * share * rise_m);
  // Rankine's passive wedge from the tip up to the surface is z tan(45 deg + phi/2) long; where it
  // runs into the next paddle, the soil of that paddle's wedge is not counted twice.
  const double wedge = std::max(tip.sinkage_m(), height) * rim_.sqrt_n_phi;
  const double apart = std::min(1.0, paddle_spacing_m_ / wedge);
  const double own_share = apart * (2.0 - apart);
  const double driving = std::max(0.0, face.t * travel_.going.t);
  const double area = share * height * line_width_m_;
  return {0.0, -face.t * own_share * FacePressure(rim_, depth, driving) * area, 0.0};
}

void WheelSoil::AddPaddle(const HeightGrid& grid, const WheelFrame& frame, Paddle& paddle,
                          LoadSum& sum) {
  const double height = wheel_.paddle_height_m, tip = wheel_.rim_radius_m + height;
  const double middle = tip - 0.5 * height;
  const SpokeAxes axes = frame.Along(paddle.cos, paddle.sin);
  const double rise = std::max(1e-6, height * -axes.r_G.z());  // of the root over the tip
  const double area = wheel_.paddle_thickness_m * line_width_m_;
  std::array<SpokeLoad, kLines> tips;
  paddle.face_loads = {};
  paddle.pushes = false;
  for (int i = 0; i < kLines; ++i) {
    const double y = (i - 1) * line_width_m_;
    const PatchPlace at(grid, frame, axes, tip, y, tip);
    if (at.surface_m <= at.z_m) {
      paddle.tips[i] = {};
      paddle.faces[i] = {};
      continue;
    }
    paddle.pushes = true;
    sum.Touch(at.sinkage_m());
    tips[i] = LoadPatch(tip_, travel_, contact_depth_m_, at, area, frame.dt_s, paddle.tips[i]);
    paddle.face_loads[i] =
        LoadFace(at, VelocityAt(axes, middle, y), rise, frame.dt_s, paddle.faces[i]);
  }
  if (!paddle.pushes) return;
  AddRow(axes, tip, tips, sum);
  AddToEnvelope(tips);
  const auto& faces = paddle.face_loads;
  envelope_.faces_n += (faces[0].t + faces[2].t) + faces[1].t;
}

/// The faces' thrust as far as the soil that they all push against holds.
void WheelSoil::AddFaces(const WheelFrame& frame, LoadSum& sum) const {
  if (envelope_.faces_n == 0.0) return;
  const double height = wheel_.paddle_height_m, tip = wheel_.rim_radius_m + height;
  const double share = FaceShare(
      envelope_, EnvelopeStrength(rim_, envelope_.pressed_n, tip, wheel_.width_m, sum.sinkage_m));
  for (const Paddle& paddle : paddles_) {
    if (!paddle.pushes) continue;
    std::array<SpokeLoad, kLines> faces = paddle.face_loads;
    for (SpokeLoad& face : faces) face.t *= share;
    AddRow(frame.Along(paddle.cos, paddle.sin), tip - 0.5 * height, faces, sum);
  }
}

void WheelSoil::AddPaddles(const HeightGrid& grid, const WheelFrame& frame, LoadSum& sum) {
  const double reach = wheel_.rim_radius_m + wheel_.paddle_height_m;
  const double near_m = frame.top_m - frame.p_G.z() + 0.5 * wheel_.width_m;
  for (Paddle& paddle : paddles_) {
    const double rise = paddle.cos * frame.x_G.z() - paddle.sin * frame.z_G.z();
    if (rise < 0.0 && reach * rise < near_m) {
      AddPaddle(grid, frame, paddle, sum);
    } else {
      paddle.tips = {};
      paddle.faces = {};
      paddle.pushes = false;
    }
  }
}

void WheelSoil::LeaveRut(HeightGrid& grid, const WheelFrame& frame) {
  if (strip_count_ == 0) return;
  const double half = strip_count_ * kPi / kStrips;
  const RimPlace rim{frame.p_G, frame.y_G, bearing_radius_m_, wheel_.width_m,
                     bearing_radius_m_ * std::sin(std::min(half, 0.5 * kPi))};
  since_rut_s_ += frame.dt_s;
  if (since_rut_s_ < kRutPeriod_s - 1e-9) return;
  // A wheel that presses nothing rests, and its soil with it.
  if (PressRut(grid, rim, rim_, travel_.excavated_m) > 0.0) {
    SlumpBeside(grid, rim, rim_, since_rut_s_, scratch_);
  }
  since_rut_s_ = 0.0;
}

WheelLoad WheelSoil::Step(HeightGrid& grid, const WheelMotion& motion, double dt_s) {
  DOCKYARD_CHECK(dt_s > 0.0 && motion.X_GK.p.allFinite() && motion.X_GK.R.allFinite());
  DOCKYARD_CHECK(grid.nx > 1 && grid.ny > 1);
  if (grid.undisturbed_m.size() != grid.heights_m.size()) grid.undisturbed_m = grid.heights_m;
  WheelFrame frame(motion, dt_s);
  FindTop(grid, frame);
  FollowMotion(frame);
  contact_depth_m_ = ContactDepth(sinkage_m_ - travel_.excavated_m);
  LoadSum sum;
  envelope_ = {};
  AddRim(grid, frame, sum);
  AddPaddles(grid, frame, sum);
  AddFaces(frame, sum);
  LeaveRut(grid, frame);
  sinkage_m_ = sum.sinkage_m;
  WheelLoad load;
  load.force_G = motion.X_GK.R * sum.force_K;
  load.torque_G = motion.X_GK.R * sum.torque_K;
  load.sinkage_m = sum.sinkage_m;
  load.in_contact = sum.in_contact;
  return load;
}

namespace {

std::uint64_t HashPatch(std::uint64_t hash, const Patch& patch) {
  hash = HashDouble(HashDouble(hash, patch.shear.t), patch.shear.a);
  hash = HashDouble(hash, patch.into);
  return HashDouble(HashDouble(hash, patch.floor_m), patch.ride_m);
}

}  // namespace

std::uint64_t WheelSoil::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashDouble(HashDouble(seed, sinkage_m_), travel_.excavated_m);
  hash = HashDouble(HashDouble(hash, travel_.going.t), travel_.going.a);
  hash = HashDouble(hash, since_rut_s_);
  for (const Strip& strip : strips_) {
    for (const Patch& patch : strip.patches) hash = HashPatch(hash, patch);
    hash = HashDouble(HashDouble(HashDouble(hash, strip.side.r), strip.side.t), strip.side.a);
  }
  for (const Paddle& paddle : paddles_) {
    for (const Patch& patch : paddle.tips) hash = HashPatch(hash, patch);
    for (const Mobilisation& face : paddle.faces) {
      hash = HashDouble(HashDouble(hash, face.t), face.a);
    }
  }
  return hash;
}

}  // namespace dockyard
