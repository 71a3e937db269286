// The paddles' part of a wheel in the soil: what presses on their tips and what their faces push.
#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/soil/moved_soil.h"
#include "sim/soil/wheel_soil.h"

namespace dockyard {
namespace {

// About a paddle's print slopes slump within this many cells of its edges, in this number of
// passes: where two prints meet, their ridges are too steep. Assumed, 2-6 cells and 10-200 passes.
constexpr double kSlumpCells = 3.0;
constexpr int kSlumpPasses = 50;

}  // namespace

/// Passive pressure on a paddle's faces, buried from the tip up.
Four WheelSoil::LoadFaces(const PatchPlaceOf<Four>& tip, const SpokeVelocityOf<Four>& v,
                          double rise_m, double dt_s, MobilisationOf<Four>& faces) const {
  const double height = wheel_.paddle_height_m;
  const Four none = 0.0, whole = 1.0;
  faces = Shear(faces, v.t * dt_s, v.a * dt_s, ShearModulus(tip_, contact_depth_m_));
  // The soil that a face pushes heaps against it, up to the rim once the rim bears on caught soil.
  const double caught_m = bearing_radius_m_ - wheel_.rim_radius_m;
  const double free_share = std::max(0.1, 1.0 - caught_m / height);
  const Four share = Min((tip.surface_m - tip.z_m) * (1.0 / (free_share * rise_m)), whole);
  const Four depth = Max(tip.sinkage_m() - 0.5 * share * rise_m, none);
  // Rankine's passive wedge from the tip up to the surface is z tan(45 deg + phi/2) long; where it
  // runs into the next paddle, the soil of that paddle's wedge is not counted twice.
  const Four wedge = Max(tip.sinkage_m(), Four(height)) * rim_.sqrt_n_phi;
  const Four apart = Min(paddle_spacing_m_ / wedge, whole);
  const Four own_share = apart * (2.0 - apart);
  const Four driving = Max(faces.t * travel_.going.t, none);
  const Four area = share * (height * line_width_m_);
  return -(faces.t * own_share * FacePressure(rim_, depth, driving) * area);
}

void WheelSoil::AddPaddle(const Place& at, Paddle& paddle, LoadSum& sum) {
  const WheelFrame& frame = at.frame;
  const double height = wheel_.paddle_height_m, tip = wheel_.rim_radius_m + height;
  const double width = line_width_m_;
  const Four y(-width, 0.0, width, width);
  const SpokeAxesOf<Four> axes = frame.Along(Four(paddle.cos), Four(paddle.sin));
  const PatchPlaceOf<Four> place(at.ground, frame, axes, tip, y, tip);
  const FourMask in_soil = place.z_m < place.surface_m, out = place.surface_m <= place.z_m;
  paddle.pushes = Any(in_soil);
  if (!paddle.pushes) {
    paddle.tips = {};
    paddle.faces = {};
    return;
  }
  sum.Touch(Largest(Select(in_soil, place.sinkage_m(), Four(0.0))));
  const double area = wheel_.paddle_thickness_m * width;
  const SpokeLoadOf<Four> load =
      LoadPatch(tip_, travel_, contact_depth_m_, place, area, frame.dt_s, paddle.tips);
  const double rise = std::max(1e-6, height * -axes.r_z[0]);  // of the root over the tip
  const SpokeVelocityOf<Four> v = VelocityAt(axes, tip - 0.5 * height, y);
  const Four face = LoadFaces(place, v, rise, frame.dt_s, paddle.faces);
  Put<Four>(out, {}, paddle.tips);
  paddle.faces.t = Select(in_soil, paddle.faces.t, Four(0.0));
  paddle.faces.a = Select(in_soil, paddle.faces.a, Four(0.0));

  const unsigned bits = Bits(in_soil);
  Row<double> tips;
  for (int i = 0; i < kLines; ++i) {
    const bool on = (bits >> i & 1) != 0;
    tips[i] = on ? SpokeLoad{load.r[i], load.t[i], load.a[i]} : SpokeLoad{};
    paddle.face_loads[i] = {0.0, on ? face[i] : 0.0, 0.0};
  }
  AddRow(frame.Along(paddle.cos, paddle.sin), tip, tips, sum);
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
    Row<double> faces = paddle.face_loads;
    for (SpokeLoad& face : faces) face.t *= share;
    AddRow(frame.Along(paddle.cos, paddle.sin), tip - 0.5 * height, faces, sum);
  }
}

void WheelSoil::AddPaddles(const Place& at, LoadSum& sum) {
  const WheelFrame& frame = at.frame;
  const double reach = wheel_.rim_radius_m + wheel_.paddle_height_m;
  const double near_m =
      frame.top_m - frame.p_G.z() + 0.5 * wheel_.width_m * std::fabs(frame.y_G.z());
  for (Paddle& paddle : paddles_) {
    const double rise = paddle.cos * frame.x_G.z() - paddle.sin * frame.z_G.z();
    if (rise < 0.0 && reach * rise < near_m) {
      AddPaddle(at, paddle, sum);
    } else if (paddle.pushes) {
      paddle.tips = {};
      paddle.faces = {};
      paddle.pushes = false;
    }
    if (prints_ && paddle.pushes) FollowPrint(at, paddle);
  }
}

/// Keeps the place where the paddle's middle is deepest.
void WheelSoil::FollowPrint(const Place& at, Paddle& paddle) const {
  const WheelFrame& frame = at.frame;
  const double tip_m = wheel_.rim_radius_m + wheel_.paddle_height_m;
  const Eigen::Vector3d p_G = frame.p_G + tip_m * (paddle.cos * frame.x_G - paddle.sin * frame.z_G);
  double surface_m = 0.0, undisturbed_m = 0.0;
  at.ground.Read(p_G.x(), p_G.y(), surface_m, undisturbed_m);
  if (undisturbed_m - p_G.z() <= paddle.deepest_m) return;
  paddle.deepest_m = undisturbed_m - p_G.z();
  paddle.print = {.at = p_G.head<2>(),
                  .across = frame.y_G.head<2>().normalized(),
                  .width_m = wheel_.width_m,
                  .thickness_m = wheel_.paddle_thickness_m,
                  .depth_m = surface_m - p_G.z()};
}

/// Of the paddles that have come out of the soil. Soil under the rim does not slide.
void WheelSoil::LeavePrints(HeightGrid& grid, const WheelFrame& frame) {
  const double reach_m = bearing_radius_m_ * std::sin(std::min(half_angle_, 0.5 * kPi));
  const RoundArea under_rim{frame.p_G.head<2>(), std::max(reach_m, 0.5 * wheel_.width_m)};
  for (Paddle& paddle : paddles_) {
    if (paddle.pushes || paddle.deepest_m == 0.0) continue;
    LeavePrint(grid, paddle.print, rim_.tan_phi);
    const double half_m = 0.5 * wheel_.width_m + kSlumpCells * grid.cell_m;
    Slump(grid, {paddle.print.at, half_m, rim_.tan_phi, {&under_rim, 1}}, kSlumpPasses);
    paddle.print = {};
    paddle.deepest_m = 0.0;
  }
}

}  // namespace dockyard
