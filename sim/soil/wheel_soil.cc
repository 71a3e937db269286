#include "sim/soil/wheel_soil.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

constexpr int kStrips = 144;  // 2.5 deg each
// Distance over which the slip that rules sinkage is remembered, in wheel radii: about the length
// of the contact. Assumed, range 0.15-0.6.
constexpr double kSlipMemory_radii = 0.3;
// Sliding is counted up to this many contact lengths, at which a dragged wheel's soil flows
// steadily. Assumed, range 3-6.
constexpr double kMostSlid_lengths = 4.0;
// Shear damping as a time by which the displacement is led by its rate; it stops the shaking of a
// wheel on elastic shear and never exceeds the strength. Assumed, range 0.005-0.03 s on the way;
// twice that at rest, where loaded sand damps small strains by some per cent of critical.
constexpr double kShearLead_s = 0.015;
// A patch of a resting wheel that slides along its own plane takes the soil below along, over about
// this distance, and so does not press it: pressure acts along the normal, and were it to change
// with sliding as well, a rocking wheel would draw energy from the soil. Assumed, range 2-10 mm.
constexpr double kRide_m = 0.005;
// Way after which a wheel counts as going and no more as rocking. Assumed, range 2-20 mm.
constexpr double kGoing_m = 0.005;
// Ground this much above the highest of the sampled points may touch the wheel.
constexpr double kGroundMargin_m = 0.03;
// Steps between write-backs of the rut. A patch knows its own floor, so only later patches wait.
constexpr int kRutPeriod = 8;

Mobilisation LedBy(const Mobilisation& m, double v_t, double v_a, double lead) {
  const Mobilisation led{m.t + lead * v_t, m.a + lead * v_a};
  const double square = led.t * led.t + led.a * led.a;
  if (square <= 1.0) return led;
  const double scale = 1.0 / std::sqrt(square);
  return {led.t * scale, led.a * scale};
}

}  // namespace

/// The wheel's place and motion, in the forms that the patches need. Spoke axes: r outwards, t the
/// way a point of the rim goes when the wheel turns forward, a along the axle.
struct WheelSoil::Frame {
  Eigen::Vector3d p_G, x_G, y_G, z_G;  // centre and axes of K
  Eigen::Vector3d v_K, w_K;
  double top_m = 0.0;  // ground is nowhere higher than this near the wheel
  double dt_s = 0.0;

  struct Axes {
    Eigen::Vector3d r_G;
    double t_z;  // the way t climbs
    double v_r, v_t, v_a, w_r, w_t, w_a;
  };
  /// Axes and motion of the spoke (cos, 0, -sin) in K.
  Axes Along(double cos, double sin) const {
    Axes axes;
    axes.r_G = cos * x_G - sin * z_G;
    axes.t_z = -sin * x_G.z() - cos * z_G.z();
    axes.v_r = v_K.x() * cos - v_K.z() * sin;
    axes.v_t = -v_K.x() * sin - v_K.z() * cos;
    axes.v_a = v_K.y();
    axes.w_r = w_K.x() * cos - w_K.z() * sin;
    axes.w_t = -w_K.x() * sin - w_K.z() * cos;
    axes.w_a = w_K.y();
    return axes;
  }
};

struct WheelSoil::PatchLoad {
  double r = 0.0, t = 0.0, a = 0.0;  // on the wheel, along the spoke's axes [N]
};

/// Force and torque on the wheel in K.
struct WheelSoil::Sum {
  Eigen::Vector3d force_K = Eigen::Vector3d::Zero(), torque_K = Eigen::Vector3d::Zero();
  double sinkage_m = 0.0;
  bool in_contact = false;

  /// Adds the loads of one row across the width, the outer two first, so that a mirrored wheel
  /// adds the same numbers.
  void Add(const Spoke& spoke, double radius_m, double y_m,
           const std::array<PatchLoad, kLines>& row) {
    const double r = (row[0].r + row[2].r) + row[1].r;
    const double t = (row[0].t + row[2].t) + row[1].t;
    const double a = (row[0].a + row[2].a) + row[1].a;
    const double turn_r = -y_m * (row[2].t - row[0].t);
    const double turn_t = y_m * (row[2].r - row[0].r) - radius_m * a;
    const double c = spoke.cos, s = spoke.sin;
    force_K += Eigen::Vector3d(r * c - t * s, a, -r * s - t * c);
    torque_K += Eigen::Vector3d(turn_r * c - turn_t * s, radius_m * t, -turn_r * s - turn_t * c);
  }
};

WheelSoil::WheelSoil(const WheelModel& wheel, const SoilModel& soil)
    : wheel_(wheel), n_(soil.n), n_slip_(soil.n_slip) {
  DOCKYARD_CHECK(wheel.rim_radius_m > 0.0 && wheel.width_m > 0.0 && wheel.paddle_count >= 0);
  rim_ = MakeRimLaws(soil, wheel.width_m);
  strip_length_m_ = wheel.rim_radius_m * 2.0 * kPi / kStrips;
  line_width_m_ = wheel.width_m / kLines;
  strips_.resize(kStrips);
  for (int i = 0; i < kStrips; ++i) {
    const double angle = (i + 0.5) * 2.0 * kPi / kStrips;
    strips_[i].cos = std::cos(angle);
    strips_[i].sin = std::sin(angle);
  }
  if (wheel.paddle_count == 0) return;
  DOCKYARD_CHECK(wheel.paddle_height_m > 0.0 && wheel.paddle_thickness_m > 0.0);
  tip_ = MakeTipLaws(soil, wheel.paddle_thickness_m, wheel.width_m);
  paddles_.resize(wheel.paddle_count);
  for (int i = 0; i < wheel.paddle_count; ++i) {
    const double angle = wheel.phase_rad + i * 2.0 * kPi / wheel.paddle_count;
    paddles_[i].cos = std::cos(angle);
    paddles_[i].sin = std::sin(angle);
  }
  paddle_spacing_m_ = 2.0 * kPi * wheel.rim_radius_m / wheel.paddle_count;
}

WheelSoil::Frame WheelSoil::MakeFrame(const HeightGrid& grid, const WheelMotion& motion,
                                      double dt_s) const {
  Frame frame;
  const Eigen::Matrix3d& R = motion.X_GK.R;
  frame.p_G = motion.X_GK.p;
  frame.x_G = R.col(0);
  frame.y_G = R.col(1);
  frame.z_G = R.col(2);
  frame.v_K = R.transpose() * motion.v_GK_G;
  frame.w_K = R.transpose() * motion.w_GK_G;
  frame.dt_s = dt_s;
  const double reach = wheel_.rim_radius_m + wheel_.paddle_height_m;
  double top = -kNoFloor_m;
  for (int i = -2; i <= 2; ++i) {
    const double ahead = 0.5 * i * reach;
    const GridCell at =
        CellAt(grid, frame.p_G.x() + ahead * frame.y_G.y(), frame.p_G.y() - ahead * frame.y_G.x());
    top = std::max(top, Interpolate(grid, grid.undisturbed_m, at));
  }
  frame.top_m = top + kGroundMargin_m;
  return frame;
}

void WheelSoil::FollowMotion(const Frame& frame) {
  // Level and forward: the axle's left, turned down to the ground and to the right.
  const Eigen::Vector3d ahead_G(frame.y_G.y(), -frame.y_G.x(), 0.0);
  const double v_ahead =
      frame.v_K.x() * frame.x_G.dot(ahead_G) + frame.v_K.z() * frame.z_G.dot(ahead_G);
  // Paddles roll on soil somewhere between their roots and tips: half-way is assumed.
  const double radius = wheel_.rim_radius_m + 0.5 * wheel_.paddle_height_m;
  FollowSlip(slip_, frame.w_K.y() * radius * frame.dt_s, v_ahead * frame.dt_s,
             frame.v_K.y() * frame.dt_s, kSlipMemory_radii * wheel_.rim_radius_m);
  const double v_up = frame.v_K.x() * frame.x_G.z() + frame.v_K.z() * frame.z_G.z();
  going_ = Shear(going_, 0.5 * (frame.w_K.y() * radius + v_ahead) * frame.dt_s, v_up * frame.dt_s,
                 kGoing_m);
  resting_ = 1.0 - (going_.t * going_.t + going_.a * going_.a);
  slip_sinkage_ = MakeSlipSinkage(slip_, n_, n_slip_);
  // From entry to the lowest point; a millimetre more keeps it from vanishing on first touch.
  const double share = std::min(1.0, sinkage_m_ / wheel_.rim_radius_m);
  contact_length_m_ = wheel_.rim_radius_m * std::acos(1.0 - share) + 1e-3;
}

/// A patch over the soil, and its motion along its spoke's axes (r into the soil).
struct WheelSoil::PatchPlace {
  double z_m = 0.0, surface_m = 0.0, undisturbed_m = 0.0;
  double v_r = 0.0, v_t = 0.0, v_a = 0.0;
  double climb_m_s = 0.0;  // of its sliding along its own plane

  double sinkage_m() const { return undisturbed_m - z_m; }

  PatchPlace(const HeightGrid& grid, const Frame& frame, const Frame::Axes& axes, double radius_m,
             double y_m) {
    const Eigen::Vector3d p_G = frame.p_G + radius_m * axes.r_G + y_m * frame.y_G;
    const GridCell cell = CellAt(grid, p_G.x(), p_G.y());
    z_m = p_G.z();
    surface_m = Interpolate(grid, grid.heights_m, cell);
    undisturbed_m = Interpolate(grid, grid.undisturbed_m, cell);
    v_r = axes.v_r + y_m * axes.w_t;
    v_t = axes.v_t + radius_m * axes.w_a - y_m * axes.w_r;
    v_a = axes.v_a - radius_m * axes.w_t;
    climb_m_s = v_t * axes.t_z + v_a * frame.y_G.z();
  }
};

namespace {

/// Elastic from the floor, limited by yield, which lowers the floor [Pa].
double Pressure(const SoilLaws& laws, double n, double z_m, double surface_m, double sinkage_m,
                double carrying_share, double v_in, double ride_m, double& floor_m) {
  const double floor = std::min(surface_m, floor_m);
  const double pressed = floor + ride_m - z_m;
  if (pressed <= 0.0 || sinkage_m <= 0.0) return 0.0;
  const double yield =
      std::max(YieldPressure(laws, n, carrying_share * sinkage_m), BladePressure(laws, sinkage_m));
  const double elastic = laws.elastic_pa_per_m * pressed;
  if (elastic >= yield) {
    floor_m = z_m + yield / laws.elastic_pa_per_m - ride_m;
    return yield;
  }
  floor_m = floor;
  // Yielding soil dissipates by itself; damping is for the elastic rest, and never pulls.
  const double damped = elastic + laws.damping_pa_s_per_m * v_in;
  return std::clamp(damped, 0.0, std::min(2.0 * elastic, yield));
}

}  // namespace

WheelSoil::PatchLoad WheelSoil::LoadPatch(const SoilLaws& laws, const PatchPlace& at,
                                          double area_m2, double dt_s, Patch& patch) const {
  const double share =
      CarryingShare(slip_sinkage_, patch.slid_t_m, patch.slid_a_m, contact_length_m_);
  const double slide_t = at.v_t * dt_s, slide_a = at.v_a * dt_s;
  if (patch.floor_m < kNoFloor_m) {
    const double ride = kRide_m * std::max(resting_, 1e-6);
    const double keep = Decay(std::sqrt(slide_t * slide_t + slide_a * slide_a) / ride);
    patch.ride_m = keep * (patch.ride_m + at.climb_m_s * dt_s);
  }
  const double pressure = Pressure(laws, slip_sinkage_.exponent, at.z_m, at.surface_m,
                                   at.sinkage_m(), share, at.v_r, patch.ride_m, patch.floor_m);
  if (pressure <= 0.0) {
    // Lifted off its own floor, a patch forgets only once it is clear of the rut as well.
    if (at.z_m >= at.surface_m || at.sinkage_m() <= 0.0) patch = {};
    return {};
  }
  patch.slid_t_m += slide_t;
  patch.slid_a_m += slide_a;
  const double most = kMostSlid_lengths * contact_length_m_;
  const double square = patch.slid_t_m * patch.slid_t_m + patch.slid_a_m * patch.slid_a_m;
  if (square > most * most) {
    const double scale = most / std::sqrt(square);
    patch.slid_t_m *= scale;
    patch.slid_a_m *= scale;
  }
  patch.shear = Shear(patch.shear, slide_t, slide_a, laws.shear_modulus_m);
  const double lead = kShearLead_s * (1.0 + resting_) / laws.shear_modulus_m;
  const Mobilisation m = LedBy(patch.shear, at.v_t, at.v_a, lead);
  const double strength = area_m2 * ShearStrength(laws, pressure);
  return {-area_m2 * pressure, -strength * m.t, -strength * m.a};
}

void WheelSoil::AddStrip(const HeightGrid& grid, const Frame& frame, Spoke& strip, Sum& sum) const {
  const double radius = wheel_.rim_radius_m;
  const Frame::Axes axes = frame.Along(strip.cos, strip.sin);
  std::array<PatchLoad, kLines> row;
  std::array<double, kLines> depth;
  for (int i = 0; i < kLines; ++i) {
    const PatchPlace at(grid, frame, axes, radius, (i - 1) * line_width_m_);
    row[i] = LoadPatch(rim_, at, strip_length_m_ * line_width_m_, frame.dt_s, strip.patches[i]);
    depth[i] = std::max(0.0, at.sinkage_m());
  }
  const double deepest = std::max(std::max(depth[0], depth[2]), depth[1]);
  if (deepest <= 0.0) {
    strip.side = 0.0;
    return;
  }
  // The side that moves into the soil bulldozes, over the strip's length along the ground.
  strip.side = Shear(strip.side, (axes.v_a - radius * axes.w_t) * frame.dt_s, rim_.shear_modulus_m);
  const double side_depth = strip.side > 0.0 ? depth[2] : depth[0];
  const double length = strip_length_m_ * std::max(0.0, -axes.r_G.z());
  row[1].a -= strip.side * length * BulldozingResistance(rim_, side_depth);
  sum.sinkage_m = std::max(sum.sinkage_m, deepest);
  sum.in_contact = true;
  sum.Add(strip, radius, line_width_m_, row);
}

void WheelSoil::MoveWindow(int first, int count) {
  if (first == first_strip_ && count == strip_count_) return;
  for (int i = 0; i < strip_count_; ++i) {
    const int index = (first_strip_ + i) % kStrips;
    if ((index - first + kStrips) % kStrips < count) continue;
    strips_[index].patches = {};
    strips_[index].side = 0.0;
  }
  first_strip_ = first;
  strip_count_ = count;
}

void WheelSoil::AddRim(const HeightGrid& grid, const Frame& frame, Sum& sum) {
  // The strips on both sides of the lowest one that are below the highest ground.
  const double down = std::atan2(frame.z_G.z(), -frame.x_G.z());
  const double upright = std::sqrt(1.0 - frame.y_G.z() * frame.y_G.z());
  const double clearance =
      frame.p_G.z() - std::fabs(frame.y_G.z()) * 0.5 * wheel_.width_m - frame.top_m;
  const double ratio = clearance / (wheel_.rim_radius_m * upright);
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

void WheelSoil::AddPaddle(const HeightGrid& grid, const Frame& frame, Spoke& paddle,
                          Sum& sum) const {
  const double height = wheel_.paddle_height_m, tip = wheel_.rim_radius_m + height;
  const double middle = tip - 0.5 * height;
  const Frame::Axes axes = frame.Along(paddle.cos, paddle.sin);
  const double rise = std::max(1e-6, height * -axes.r_G.z());  // of the root over the tip
  std::array<PatchLoad, kLines> tips, faces;
  bool touches = false;
  for (int i = 0; i < kLines; ++i) {
    const double y = (i - 1) * line_width_m_;
    const PatchPlace at(grid, frame, axes, tip, y);
    const double buried = at.surface_m - at.z_m;
    if (buried <= 0.0) {
      paddle.patches[i] = {};
      paddle.faces[i] = 0.0;
      continue;
    }
    touches = true;
    sum.sinkage_m = std::max(sum.sinkage_m, at.sinkage_m());
    tips[i] = LoadPatch(tip_, at, wheel_.paddle_thickness_m * line_width_m_, frame.dt_s,
                        paddle.patches[i]);
    const double v_face = axes.v_t + middle * axes.w_a - y * axes.w_r;
    paddle.faces[i] = Shear(paddle.faces[i], v_face * frame.dt_s, tip_.shear_modulus_m);
    const double share = std::min(1.0, buried / rise);
    const double depth = std::max(0.0, at.sinkage_m() - 0.5 * share * rise);
    // Rankine's passive wedge from the tip up to the surface is z tan(45 deg + phi/2) long;
    // paddles closer than that share one wedge.
    const double wedge = std::max(at.sinkage_m(), height) * rim_.sqrt_n_phi;
    const double own_share = std::min(1.0, paddle_spacing_m_ / wedge);
    faces[i].t = -paddle.faces[i] * own_share * PassivePressure(rim_, depth) * share * height *
                 line_width_m_;
  }
  if (!touches) return;
  sum.in_contact = true;
  sum.Add(paddle, tip, line_width_m_, tips);
  sum.Add(paddle, middle, line_width_m_, faces);
}

void WheelSoil::AddPaddles(const HeightGrid& grid, const Frame& frame, Sum& sum) {
  const double reach = wheel_.rim_radius_m + wheel_.paddle_height_m;
  const double near_m = frame.top_m - frame.p_G.z() + 0.5 * wheel_.width_m;
  for (Spoke& paddle : paddles_) {
    const double rise = paddle.cos * frame.x_G.z() - paddle.sin * frame.z_G.z();
    if (rise < 0.0 && reach * rise < near_m) {
      AddPaddle(grid, frame, paddle, sum);
    } else {
      paddle.patches = {};
      paddle.faces = {};
    }
  }
}

void WheelSoil::LeaveRut(HeightGrid& grid, const Frame& frame) {
  if (strip_count_ == 0 || ++steps_since_rut_ < kRutPeriod) return;
  steps_since_rut_ = 0;
  const double half = strip_count_ * kPi / kStrips;
  const RimPlace rim{frame.p_G, frame.y_G, wheel_.rim_radius_m, wheel_.width_m,
                     wheel_.rim_radius_m * std::sin(std::min(half, 0.5 * kPi))};
  PressRut(grid, rim, rim_, slip_sinkage_.exponent, scratch_);
}

WheelLoad WheelSoil::Step(HeightGrid& grid, const WheelMotion& motion, double dt_s) {
  DOCKYARD_CHECK(dt_s > 0.0 && motion.X_GK.p.allFinite() && motion.X_GK.R.allFinite());
  DOCKYARD_CHECK(grid.nx > 1 && grid.ny > 1);
  if (grid.undisturbed_m.size() != grid.heights_m.size()) grid.undisturbed_m = grid.heights_m;
  const Frame frame = MakeFrame(grid, motion, dt_s);
  FollowMotion(frame);
  Sum sum;
  AddRim(grid, frame, sum);
  AddPaddles(grid, frame, sum);
  LeaveRut(grid, frame);
  sinkage_m_ = sum.sinkage_m;
  WheelLoad load;
  load.force_G = motion.X_GK.R * sum.force_K;
  load.torque_G = motion.X_GK.R * sum.torque_K;
  load.sinkage_m = sum.sinkage_m;
  load.in_contact = sum.in_contact;
  return load;
}

std::uint64_t WheelSoil::StateHash(std::uint64_t seed) const {
  std::uint64_t hash =
      HashDouble(HashDouble(HashDouble(seed, sinkage_m_), slip_.ahead), slip_.aside);
  hash = HashDouble(HashDouble(hash, going_.t), going_.a);
  hash = HashBits(hash, static_cast<std::uint64_t>(steps_since_rut_));
  for (const std::vector<Spoke>* spokes : {&strips_, &paddles_}) {
    for (const Spoke& spoke : *spokes) {
      for (const Patch& patch : spoke.patches) {
        hash = HashDouble(HashDouble(hash, patch.shear.t), patch.shear.a);
        hash = HashDouble(HashDouble(hash, patch.slid_t_m), patch.slid_a_m);
        hash = HashDouble(HashDouble(hash, patch.floor_m), patch.ride_m);
      }
      for (double face : spoke.faces) hash = HashDouble(hash, face);
      hash = HashDouble(hash, spoke.side);
    }
  }
  return hash;
}

}  // namespace dockyard
