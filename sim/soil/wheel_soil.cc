#include "sim/soil/wheel_soil.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

constexpr int kStrips = 144;  // 2.5 deg each
constexpr int kFours = kStrips / 4;
// Ground this much above the highest of the sampled points may touch the wheel; assumed, range
// 0.005-0.03: below it ruts' walls between the samples are missed, above it time is lost.
constexpr double kGroundMargin_m = 0.015;
// Time between two passes in which the rut is pressed and slopes beside it slump; assumed, range
// 1-8 ms: at 0.05 m/s a wheel goes 0.1 mm in it, of a cell of 23 mm. A time, not a count of steps:
// the soil must not run faster when steps are short.
constexpr double kRutPeriod_s = 2e-3;

}  // namespace

WheelSoil::WheelSoil(const WheelModel& wheel, const SoilModel& soil) : wheel_(wheel) {
  DOCKYARD_CHECK(wheel.rim_radius_m > 0.0 && wheel.width_m > 0.0 && wheel.paddle_count >= 0);
  line_width_m_ = wheel.width_m / kLines;
  if (wheel.paddle_count > 0) {
    DOCKYARD_CHECK(wheel.paddle_height_m > 0.0 && wheel.paddle_thickness_m > 0.0);
    paddle_spacing_m_ = 2.0 * kPi * wheel.rim_radius_m / wheel.paddle_count;
    rim_share_ = std::max(0.0, 1.0 - wheel.paddle_thickness_m / paddle_spacing_m_);
  }
  AddSoil(soil);
  Use(laws_.front());
  strips_.resize(kFours);
  for (int i = 0; i < kFours; ++i) {
    const auto angle = [&](int k) { return (4 * i + k + 0.5) * 2.0 * kPi / kStrips; };
    strips_[i].cos = {std::cos(angle(0)), std::cos(angle(1)), std::cos(angle(2)),
                      std::cos(angle(3))};
    strips_[i].sin = {std::sin(angle(0)), std::sin(angle(1)), std::sin(angle(2)),
                      std::sin(angle(3))};
  }
  paddles_.resize(wheel.paddle_count);
  for (int i = 0; i < wheel.paddle_count; ++i) {
    const double angle = wheel.phase_rad + i * 2.0 * kPi / wheel.paddle_count;
    paddles_[i].cos = std::cos(angle);
    paddles_[i].sin = std::sin(angle);
  }
}

WheelSoil::Laws WheelSoil::LawsOf(const SoilModel& soil) const {
  Laws laws{.rim = MakeRimLaws(soil, wheel_.width_m), .bearing_radius_m = wheel_.rim_radius_m};
  if (wheel_.paddle_count > 0) {
    laws.tip = MakeTipLaws(soil, wheel_.paddle_thickness_m, wheel_.width_m);
    // Soil between two paddles is caught in the passive wedges before the one and behind the other,
    // h tan(45 deg + phi/2) long: two triangles that fill this share of the gap.
    const double height = wheel_.paddle_height_m;
    const double gap = std::max(1e-3 * paddle_spacing_m_, rim_share_ * paddle_spacing_m_);
    const double filled = std::min(1.0, height * laws.rim.sqrt_n_phi / gap);
    laws.bearing_radius_m += height * filled;
    // Of this share of the rim a share as large carries soil out to the tips.
    laws.rim.tan_caught = filled * filled * (laws.rim.tan_phi - laws.rim.tan_rim);
  }
  laws.strip_length_m = laws.bearing_radius_m * 2.0 * kPi / kStrips;
  return laws;
}

void WheelSoil::Use(const Laws& laws) {
  rim_ = laws.rim;
  tip_ = laws.tip;
  bearing_radius_m_ = laws.bearing_radius_m;
  strip_length_m_ = laws.strip_length_m;
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

void WheelSoil::Forget(Strips& strips) {
  if (!strips.in_soil) return;
  strips.patches = {};
  strips.sides = {};
  strips.in_soil = false;
}

void WheelSoil::AddStrips(const Place& at, Strips& strips, LoadSumOf<Four>& sum) {
  const WheelFrame& frame = at.frame;
  const SpokeAxesOf<Four> axes = frame.Along(strips.cos, strips.sin);
  const double area = rim_share_ * strip_length_m_ * line_width_m_;
  const auto height = [&](int i) {
    return PatchHeightOf<Four>(at.ground, frame, axes, bearing_radius_m_, (i - 1) * line_width_m_);
  };
  const std::array<PatchHeightOf<Four>, kLines> heights{height(0), height(1), height(2)};
  const auto depth = [&](int i) { return heights[i].sinkage_m(); };
  const Four deepest = Max(Max(depth(0), depth(2)), depth(1));
  const FourMask in_soil = deepest > 0.0;
  if (!Any(in_soil)) {
    Forget(strips);
    return;
  }
  strips.in_soil = true;
  Row<Four> row;
  for (int i = 0; i < kLines; ++i) {
    const PatchPlaceOf<Four> place(heights[i], axes, wheel_.rim_radius_m, (i - 1) * line_width_m_);
    row[i] = LoadPatch(rim_, travel_, contact_depth_m_, place, area, frame.dt_s, strips.patches[i]);
  }
  sum.Touch(deepest);
  AddRow(axes, bearing_radius_m_, row, sum);
  if (!paddles_.empty()) AddToEnvelope(row);
  const SideStrips sides{bearing_radius_m_, 0.5 * wheel_.width_m, strip_length_m_, depth(0),
                         depth(2)};
  AddSideWalls(rim_, contact_depth_m_, axes, sides, in_soil, frame.dt_s, strips.sides, sum);
}

void WheelSoil::MoveWindow(int first, int count) {
  if (first == first_four_ && count == four_count_) return;
  for (int i = 0; i < four_count_; ++i) {
    const int index = (first_four_ + i) % kFours;
    if ((index - first + kFours) % kFours < count) continue;
    Forget(strips_[index]);
  }
  first_four_ = first;
  four_count_ = count;
}

void WheelSoil::AddRim(const Place& at, LoadSum& sum) {
  // The strips on both sides of the lowest one that are below the highest ground, by fours.
  const WheelFrame& frame = at.frame;
  const double down = std::atan2(frame.z_G.z(), -frame.x_G.z());
  const double upright = std::sqrt(1.0 - frame.y_G.z() * frame.y_G.z());
  const double clearance =
      frame.p_G.z() - std::fabs(frame.y_G.z()) * 0.5 * wheel_.width_m - frame.top_m;
  const double ratio = clearance / (bearing_radius_m_ * upright);
  const double step = 2.0 * kPi / kStrips;
  int first = 0, count = 0;
  half_angle_ = 0.0;
  if (ratio < 1.0) {
    const double half = std::acos(std::max(0.0, ratio));
    const double first_strip = std::ceil((down - half) / step - 0.5);
    const double last_strip = std::floor((down + half) / step - 0.5);
    if (last_strip >= first_strip) {
      half_angle_ = 0.5 * step * (last_strip - first_strip + 1.0);
      first = static_cast<int>(std::floor(0.25 * first_strip));
      count = static_cast<int>(std::floor(0.25 * last_strip)) - first + 1;
      first = (first + kFours) % kFours;
    }
  }
  MoveWindow(first, count);
  LoadSumOf<Four> fours;
  for (int i = 0; i < count; ++i) AddStrips(at, strips_[(first + i) % kFours], fours);
  sum = Together(fours);
}

void WheelSoil::LeaveRut(HeightGrid& grid, const WheelFrame& frame) {
  if (four_count_ == 0) return;
  const RimPlace rim{frame.p_G, frame.y_G, bearing_radius_m_, wheel_.width_m,
                     bearing_radius_m_ * std::sin(std::min(half_angle_, 0.5 * kPi))};
  since_rut_s_ += frame.dt_s;
  if (since_rut_s_ < kRutPeriod_s - 1e-9) return;
  // A wheel that presses nothing rests, and its soil with it.
  if (PressRut(grid, rim, rim_, travel_.excavated_m, scratch_) > 0.0) {
    SlumpBeside(grid, rim, rim_, since_rut_s_, scratch_);
  }
  since_rut_s_ = 0.0;
}

WheelLoad WheelSoil::Step(HeightGrid& grid, const WheelMotion& motion, double dt_s) {
  DOCKYARD_CHECK(dt_s > 0.0 && motion.X_GK.p.allFinite() && motion.X_GK.R.allFinite());
  DOCKYARD_CHECK(grid.nx > 1 && grid.ny > 1);
  if (grid.undisturbed_m.size() != grid.heights_m.size()) grid.undisturbed_m = grid.heights_m;
  if (laws_.size() > 1) Use(laws_.at(grid.SoilAt(motion.X_GK.p)));
  Place at{WheelFrame(motion, dt_s), GroundUnder(grid)};
  const WheelFrame& frame = at.frame;
  FindTop(grid, at.frame);
  FollowMotion(frame);
  contact_depth_m_ = ContactDepth(sinkage_m_ - travel_.excavated_m);
  LoadSum sum;
  envelope_ = {};
  AddRim(at, sum);
  AddPaddles(at, sum);
  AddFaces(frame, sum);
  LeaveRut(grid, frame);
  if (prints_) LeavePrints(grid, frame);
  sinkage_m_ = sum.sinkage_m;
  WheelLoad load;
  load.force_G = motion.X_GK.R * Eigen::Vector3d(sum.force_x, sum.force_y, sum.force_z);
  load.torque_G = motion.X_GK.R * Eigen::Vector3d(sum.torque_x, sum.torque_y, sum.torque_z);
  load.sinkage_m = sum.sinkage_m;
  return load;
}

namespace {

std::uint64_t Hash(std::uint64_t hash, Four four) {
  for (int i = 0; i < 4; ++i) hash = HashDouble(hash, four[i]);
  return hash;
}
std::uint64_t HashPatch(std::uint64_t hash, const PatchOf<Four>& patch) {
  hash = Hash(Hash(hash, patch.shear.t), patch.shear.a);
  hash = Hash(hash, patch.into);
  return Hash(Hash(hash, patch.floor_m), patch.ride_m);
}

}  // namespace

std::uint64_t WheelSoil::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashDouble(HashDouble(seed, sinkage_m_), travel_.excavated_m);
  hash = HashDouble(HashDouble(hash, travel_.going.t), travel_.going.a);
  hash = HashDouble(hash, since_rut_s_);
  for (const Strips& strips : strips_) {
    for (const PatchOf<Four>& patches : strips.patches) hash = HashPatch(hash, patches);
    hash = Hash(Hash(Hash(hash, strips.sides.r), strips.sides.t), strips.sides.a);
  }
  for (const Paddle& paddle : paddles_) {
    hash = HashPatch(hash, paddle.tips);
    hash = Hash(Hash(hash, paddle.faces.t), paddle.faces.a);
    if (prints_) hash = HashDouble(hash, paddle.deepest_m);
  }
  return hash;
}

}  // namespace dockyard
