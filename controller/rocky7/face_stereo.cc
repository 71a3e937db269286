#include "controller/rocky7/face_stereo.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/stereo/face_bend.h"
#include "controller/stereo/plain_parts.h"

namespace dockyard::rocky7 {
namespace {

// Disparities to either side of the expected one that are searched: at 0.66 m from 0.56 to 0.81 m,
// beyond 3.5 m up to infinity; at first from 1.8 m on. A multiple of 8. Assumed, 32-64 px.
constexpr int kEitherSide_px = 48;
// A face's own slope is taken out within this range, and searched for what is left of it. Assumed,
// 2-5 m and 8-24 px.
constexpr double kSlopesWithin_m = 3.0;
constexpr int kAboutSlope_px = 16;
constexpr int kSlopePasses = 2;
// Small blocks for rocks (docs/rocky7.md).
constexpr int kFaceBlock_px = 5;
// Smaller patches of alike disparity are left out: faint ground far away is matched wrongly in
// such. A boulder of 0.5 m at 7 m has 2500 px. Assumed, 100-400 px.
constexpr int kSpeckle_px = 200;
// Of a disparity: half a block's noise, and what calibration leaves, 0.05 deg of yaw (0.7 px;
// models/rocky7/rocky7.yaml). Assumed, 0.3-1.5 px.
constexpr double kRange_px = 0.8;
// Part of the face whose plane is taken: a can's radius near by, and from afar what has enough
// pixels. Assumed, 3-4 cm, 3-5 % of the range and 8-15 cm.
constexpr double kFaceNear_m = 0.035, kFaceShare = 0.035, kFaceFar_m = 0.1;
MatchSettings SearchAbout(const PlaneDisparity& expected, int either_side_px) {
  return {.matcher = Matcher::kSemiGlobal,
          .block_px = kFaceBlock_px,
          .least_px = -either_side_px,
          .count_px = 2 * either_side_px,
          .speckle_px = kSpeckle_px,
          .ground = expected};
}

// The paper's front end: 128 px about the expected disparity, which reach from 0 on at first.
MatchSettings Blocks7About(double expected_px) {
  constexpr int kCount_px = 128;
  const int least_px = std::max(0, static_cast<int>(expected_px) - kCount_px / 2);
  return {
      .matcher = Matcher::kBandPassed, .block_px = 7, .least_px = least_px, .count_px = kCount_px};
}

GrayImage Rows(const GrayImage& image, int top, int bottom) {
  const auto begin = image.pixels.begin();
  return {image.width,
          bottom - top + 1,
          {begin + top * image.width, begin + (bottom + 1) * image.width}};
}

}  // namespace

Pose3 LevelFrame(const Nominal& nominal, const ImuSample& attitude) {
  return {RotY(attitude.pitch_rad) * RotX(attitude.roll_rad),
          Eigen::Vector3d(0.0, 0.0, nominal.rolling_radius_m)};
}

FaceStereo::FaceStereo(const Nominal& nominal, FrontEnd front_end)
    : nominal_(nominal), front_end_(front_end), rectifier_(nominal.mast.pair_K) {}

FaceView FaceStereo::Look(const StereoImages& images, const MastAngles& angles,
                          const ImuSample& attitude,
                          const std::optional<Eigen::Vector3d>& p_ET) const {
  FaceView view;
  view.X_ER = LevelFrame(nominal_, attitude);
  view.X_EK = view.X_ER * SecondLink(nominal_.mast, angles);
  view.pair = rectifier_.pair();
  view.pair.X_RC = view.X_EK * view.pair.X_RC;
  const double scale_px_m = view.pair.focal_px * view.pair.baseline_m;
  PlaneDisparity expected{static_cast<double>(kEitherSide_px)};
  if (p_ET) {
    const double depth_m = (Inverse(view.pair.X_RC) * *p_ET).z();
    expected.a = scale_px_m / std::max(0.2, depth_m);
  }
  view.images = rectifier_.Rectified(images);
  if (front_end_ == FrontEnd::kBlocks7) {
    view.disparities = Match(rectifier_, images, Blocks7About(expected.a));
    return view;
  }
  view.disparities = WithoutPlainParts(
      Match(rectifier_, images, SearchAbout(expected, kEitherSide_px)), view.images.left);
  return view;
}

Eigen::Vector2d FaceStereo::Rectified(const Eigen::Vector2d& pixel) const {
  const RectifiedPair& pair = rectifier_.pair();
  const StereoRig& rig = nominal_.mast.pair_K;
  const Eigen::Vector3d ray_C = pair.X_RC.R.transpose() * rig.X_RL.R * rig.left.Direction(pixel);
  return pair.centre_px + pair.focal_px * ray_C.head<2>() / std::max(1e-3, ray_C.z());
}

std::optional<Eigen::Vector2d> FaceStereo::Pixel(const FaceView& view, const Eigen::Vector3d& p_E,
                                                 bool right) const {
  const StereoRig& rig = nominal_.mast.pair_K;
  const Pose3 X_EC = view.X_EK * (right ? rig.X_RQ : rig.X_RL);
  const Camera& camera = right ? rig.right : rig.left;
  const auto pixel = camera.Project(Inverse(X_EC) * p_E);
  return pixel && camera.Sees(*pixel) ? pixel : std::nullopt;
}

std::optional<FacePlane> FaceStereo::PlaneAt(const FaceView& view,
                                             const Eigen::Vector2d& pixel) const {
  const auto p_C = PointUnder(view.pair, view.disparities, pixel);
  if (!p_C) return std::nullopt;
  const FacePlaneSettings settings{.radius_m =
                                       std::clamp(kFaceShare * p_C->z(), kFaceNear_m, kFaceFar_m)};
  auto plane = PlaneUnder(view.pair, view.disparities, pixel, settings);
  if (!plane || p_C->z() > kSlopesWithin_m || front_end_ == FrontEnd::kBlocks7) return plane;
  const double radius_px = view.pair.focal_px * settings.radius_m / p_C->z();
  const int reach = static_cast<int>(std::ceil(radius_px)) + 2 * kFaceBlock_px;
  const int top = std::max(0, static_cast<int>(pixel.y()) - reach);
  const int bottom = std::min(view.pair.height - 1, static_cast<int>(pixel.y()) + reach);
  const StereoImages rows{Rows(view.images.left, top, bottom),
                          Rows(view.images.right, top, bottom)};
  RectifiedPair strip = view.pair;
  strip.centre_px.y() -= top;
  for (int pass = 0; pass < kSlopePasses; ++pass) {
    const PlaneDisparity slope = DisparityOf(strip, {plane->normal, plane->normal.dot(plane->p)});
    const Disparities again = Match(rows, SearchAbout(slope, kAboutSlope_px));
    const auto better = PlaneUnder(strip, again, pixel - Eigen::Vector2d(0.0, top), settings);
    if (!better) break;
    plane = better;
    plane->bend_per_m =
        BendAbout(strip, again, *plane, settings.radius_m).value_or(Eigen::Matrix3d::Zero());
  }
  return plane;
}

ElevationMap FaceStereo::HeightsAbout(const FaceView& view, const Eigen::Vector2d& p_E,
                                      double half_m) const {
  ElevationSettings settings{.x_low_m = p_E.x() - half_m,
                             .x_high_m = p_E.x() + half_m,
                             .y_low_m = p_E.y() - half_m,
                             .y_high_m = p_E.y() + half_m};
  // A pixel's footprint across the view, at least.
  const double away_m = (p_E - view.pair.X_RC.p.head<2>()).norm();
  settings.cell_m = std::max(settings.cell_m, away_m / view.pair.focal_px);
  return MapHeights(view.pair, view.disparities, Plane{}, kFaceBlock_px, settings);
}

std::optional<StereoImages> MastPair(const SensorFrame& frame, Tick not_before) {
  for (const CameraImage& image : frame.images) {
    if (image.exposed < not_before) return std::nullopt;
  }
  const GrayImage* left = GrayImageOf(frame, kMastLeft);
  const GrayImage* right = GrayImageOf(frame, kMastRight);
  if (left == nullptr || right == nullptr) return std::nullopt;
  return StereoImages{*left, *right};
}

double RangeSigma(const RectifiedPair& pair, double range_m) {
  return kRange_px * range_m * range_m / (pair.focal_px * pair.baseline_m);
}

}  // namespace dockyard::rocky7
