#include "controller/rocky7/face_tracker.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "controller/rocky7/odometry.h"

namespace dockyard::rocky7 {
namespace {

// Where the target may be off its prediction, 1 sigma: across the way driven (along it:
// kSlipSigma), and what a step over rough ground lifts the rover. Assumed, 0.02-0.06 of the way and
// 1-3 cm.
constexpr double kAcrossShare = 0.03, kLifts_m = 0.015;
// Half the window, in sigmas; at least and at most. Assumed, 3-4, 6-12 and 40-80 px.
constexpr double kWindowSigmas = 3.0, kLeastWindow_px = 8.0, kMostWindow_px = 60.0;
// After misses all is wider: three times at most. Assumed, 2-4.
constexpr int kMostWider = 2;
// A range that differs from the prediction by more sigmas is another surface. Assumed, 3-5.
constexpr double kRangeSigmas = 3.5;
// Beside the target the face may be so much nearer or farther. Assumed, 5-15 cm.
constexpr double kFaceDepth_m = 0.1;
// From further away the target's direction will do where its range is not seen. Assumed, 2-4 m.
constexpr double kDirectionBeyond_m = 3.0;
// Disparities of the face about its plane, roughness and the fit's error included. Assumed, 2-5 px.
constexpr double kOnFace_px = 3.0;
// A normal that is less sure than this does not turn the patch. Assumed, 10-25 deg.
constexpr double kSureNormal_rad = Radians(15.0);
// The picture to compare with is taken anew when the face is so much nearer or seen from so much
// aside, and not each time: errors add up with each. Assumed, 1.2-1.6 and 10-20 deg.
constexpr double kNearer = 1.35, kAside_rad = Radians(15.0);

std::string WhyNotFound(const PatchFound& found) {
  switch (found.verdict) {
    case PatchVerdict::kFound:
      break;
    case PatchVerdict::kUnseen:
      return "the target is not in the picture";
    case PatchVerdict::kPlain:
      return "the face has no contrast about the target";
    case PatchVerdict::kElsewhere:
      return "nothing looks like the target: score " + Fixed(found.score, 2);
    case PatchVerdict::kAmbiguous:
      return "two places look like the target: scores " + Fixed(found.score, 2) + " and " +
             Fixed(found.second, 2);
  }
  return "";
}

// Disparities of what is so far away, in the camera's depth.
Disparities Between(const Disparities& all, const RectifiedPair& pair, double nearest_m,
                    double farthest_m) {
  const double scale_px_m = pair.focal_px * pair.baseline_m;
  const double least_px = scale_px_m / farthest_m;
  const double most_px = nearest_m > 0.0 ? scale_px_m / nearest_m : HUGE_VAL;
  Disparities some = all;
  for (float& px : some.px) {
    if (!(px >= least_px && px <= most_px)) px = 0.0F;
  }
  return some;
}

// Pixels whose disparity is that of the patch's plane.
GrayImage OnFace(const FaceView& view, const FacePatch& patch) {
  RectifiedPair pair = view.pair;
  pair.X_RC = Pose3{};
  const PlaneDisparity plane = DisparityOf(pair, {patch.normal_C, patch.normal_C.dot(patch.p_C)});
  GrayImage on_face{view.disparities.width, view.disparities.height, {}};
  on_face.pixels.reserve(view.disparities.px.size());
  for (int v = 0; v < view.disparities.height; ++v) {
    for (int u = 0; u < view.disparities.width; ++u) {
      const bool near = std::abs(view.disparities.at(u, v) - plane.At(u, v)) < kOnFace_px;
      on_face.pixels.push_back(near ? 255 : 0);
    }
  }
  return on_face;
}

}  // namespace

FaceSighting PatchTracker::Measure(const FaceStereo& stereo, const FaceView& view,
                                   const Eigen::Vector2d& pixel) {
  FaceSighting seen;
  const auto p_C = PointUnder(view.pair, view.disparities, pixel);
  if (!p_C) {
    seen.why = "no range data about the target";
    return seen;
  }
  seen.found = true;
  seen.p_E = view.pair.X_RC * *p_C;
  seen.range_m = p_C->norm();
  if (const auto plane = stereo.PlaneAt(view, pixel)) {
    seen.p_E = plane->p;
    seen.normal_E = plane->normal;
    seen.normal_sigma_rad = plane->normal_sigma_rad;
    seen.bend_E = plane->bend_per_m;
  }
  return seen;
}

void PatchTracker::Keep(const FaceView& view, const FaceSighting& seen) {
  const Pose3 X_CE = Inverse(view.pair.X_RC);
  patch_.left = view.images.left;
  patch_.focal_px = view.pair.focal_px;
  patch_.centre_px = view.pair.centre_px;
  patch_.p_C = X_CE * seen.p_E;
  const bool sure = seen.normal_E && seen.normal_sigma_rad < kSureNormal_rad;
  patch_.normal_C = sure ? Eigen::Vector3d(X_CE.R * *seen.normal_E) : -patch_.p_C.normalized();
  patch_.on_face = OnFace(view, patch_);
  X_EC_ = view.pair.X_RC;
  p_ET_ = seen.p_E;
  turned_rad_ = 0.0;
}

FaceSighting PatchTracker::Begin(const FaceStereo& stereo, const FaceView& view,
                                 const Eigen::Vector2d& pixel) {
  FaceSighting seen = Measure(stereo, view, pixel);
  if (!seen.found) {
    seen.why = "no range data where the user clicked";
    return seen;
  }
  seen.score = 1.0;
  range_m_ = seen.range_m;
  Keep(view, seen);
  return seen;
}

FaceSighting PatchTracker::Follow(const FaceStereo& stereo, const FaceView& view,
                                  const FaceExpected& target) {
  const FaceSighting sighting = Search(stereo, view, target);
  missed_ = sighting.found ? 0 : missed_ + 1;
  return sighting;
}

// Each miss says that odometry is off by more than was thought.
FaceSighting PatchTracker::Search(const FaceStereo& stereo, const FaceView& view,
                                  const FaceExpected& target) {
  const double wider = 1.0 + std::min(missed_, kMostWider);
  // The older picture's E in the present one: turned, and so that its target lies where odometry
  // has it since the last look.
  const double turned_rad = turned_rad_ + target.turned_rad;
  const Eigen::Matrix3d R_turn = RotZ(-turned_rad);
  const Pose3 X_EO{R_turn, target.p_E - R_turn * p_ET_};
  const Pose3 X_NC = Inverse(view.pair.X_RC) * X_EO * X_EC_;
  const double range_m = (X_NC * patch_.p_C).norm();
  const double off_m = wider * std::hypot(kSlipSigma * target.way_m, kLifts_m);
  // What it is off along the way moves the picture only where it is not looked along the way.
  const Eigen::Vector3d ray_E = (target.p_E - view.pair.X_RC.p).normalized();
  const double aside = ray_E.tail<2>().norm();
  const double across_m =
      std::hypot(kSlipSigma * target.way_m * aside, kAcrossShare * target.way_m, kLifts_m);
  const double sigma_px = wider * view.pair.focal_px *
                          std::hypot(across_m / range_m, target.drift_m / range_m, kPoints_rad);
  const double window_px =
      std::clamp(kWindowSigmas * sigma_px, kLeastWindow_px, wider * kMostWindow_px);
  const PatchFound found =
      FindPatch(patch_, view.images.left, X_NC, sigma_px, window_px, settings_);
  if (found.verdict != PatchVerdict::kFound)
    return {.score = found.score, .why = WhyNotFound(found)};
  // Before and behind an edge there are other ranges: the prediction tells which is the face's.
  const double sigma_m =
      std::hypot(off_m, RangeSigma(view.pair, range_m), RangeSigma(view.pair, range_m_));
  const double depth_m = (X_NC * patch_.p_C).z(), within_m = kRangeSigmas * sigma_m;
  FaceView face = view;
  face.disparities = Between(view.disparities, view.pair, depth_m - within_m - kFaceDepth_m,
                             depth_m + within_m + kFaceDepth_m);
  FaceSighting seen = Measure(stereo, face, found.pixel);
  seen.score = found.score;
  if (!seen.found) {
    if (range_m < kDirectionBeyond_m) return seen;
    const Eigen::Vector2d from_px = found.pixel - view.pair.centre_px;
    const Eigen::Vector3d ray_C(from_px.x(), from_px.y(), view.pair.focal_px);
    seen = {.found = true,
            .ranged = false,
            .p_E = view.pair.X_RC * (range_m * ray_C.normalized()),
            .range_m = range_m,
            .score = found.score};
  }
  if (std::abs(seen.range_m - range_m) > within_m) {
    return {.score = found.score,
            .why = "what looks like the target is " + Fixed(seen.range_m - range_m, 3) +
                   " m behind where it should be"};
  }
  range_m_ = seen.range_m;
  turned_rad_ = turned_rad;
  const Eigen::Vector3d from_then = X_EO.R * (X_EC_.p - p_ET_);
  const Eigen::Vector3d from_now = view.pair.X_RC.p - seen.p_E;
  if (from_then.norm() > kNearer * from_now.norm() ||
      AngleBetween(from_then, from_now) > kAside_rad) {
    Keep(view, seen);
  }
  return seen;
}

}  // namespace dockyard::rocky7
