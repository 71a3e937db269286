#include "controller/vision/locate.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "controller/vision/correspond.h"
#include "controller/vision/fiducials.h"
#include "controller/vision/pose_gates.h"
#include "controller/vision/pose_refine.h"
#include "controller/vision/stereo_pose.h"

namespace dockyard {
namespace {

constexpr int kMinSecondEye = 3;  // marks that make the other picture worth a joint fit
// How far a mark may lie from where the other eye's pose puts it [px]: a mono range error of 0.3 m
// at 5 m shifts it by 3 px, 0.5 deg between the cameras by 6 px.
constexpr double kCrossGatePx = 12.0;
constexpr double kFinalGatePx = 4.0;  // the same once both eyes carried the pose

using EyeResult = Result<EyeCorrespondence, PoseFailure>;

struct Eyes {
  std::array<std::vector<DetectedFiducial>, 2> detections;
  std::vector<CameraView> views;
};

std::vector<MarkPixel> Marks(const Eyes& eyes, int view, const std::vector<MarkMatch>& matches) {
  std::vector<MarkPixel> marks;
  for (const MarkMatch& match : matches) {
    const auto& seen = eyes.detections[static_cast<std::size_t>(view)];
    const Eigen::Vector2d pixel = seen[static_cast<std::size_t>(match.detection)].rim.centre_px;
    marks.push_back({.id = match.id, .view = view, .pixel = pixel});
  }
  return marks;
}

std::vector<MarkPixel> Joined(std::vector<MarkPixel> a, const std::vector<MarkPixel>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A pose with the marks that carry it.
struct Fix {
  RefinedPose fit;
  std::vector<MarkPixel> marks;
  std::string method;
};

/// The least-cost joint fit from several starts.
std::optional<Fix> BestJointFit(const Eyes& eyes, const FiducialBoard& board,
                                const std::vector<MarkPixel>& marks,
                                const std::vector<Pose3>& starts) {
  std::optional<Fix> best;
  for (const Pose3& X_RB : starts) {
    RefinedPose fit = RefinePose(marks, eyes.views, board, X_RB);
    if (!best || fit.cost < best->fit.cost) best = Fix{std::move(fit), marks, "stereo"};
  }
  return best;
}

/// Gathers what both pictures show where the fit expects it, and fits again.
Fix WithAllMarks(const Eyes& eyes, const FiducialBoard& board, const Fix& fix) {
  std::vector<MarkPixel> marks;
  for (int view = 0; view < 2; ++view) {
    const std::size_t v = static_cast<std::size_t>(view);
    const Pose3 X_CB = Inverse(eyes.views[v].X_RC) * fix.fit.X_RB;
    marks = Joined(marks, Marks(eyes, view,
                                MatchByPose(eyes.detections[v], eyes.views[v].camera, board, X_CB,
                                            kFinalGatePx)));
  }
  const auto count = [&](int view) {
    return std::count_if(marks.begin(), marks.end(), [&](const auto& m) { return m.view == view; });
  };
  if (marks.size() <= fix.marks.size() || count(0) < kMinSecondEye || count(1) < kMinSecondEye) {
    return fix;
  }
  const Fix wider{RefinePose(marks, eyes.views, board, fix.fit.X_RB), marks, "stereo"};
  return wider.fit.rms_px < fix.fit.rms_px + 0.5 ? wider : fix;
}

std::vector<Pose3> InRover(const std::vector<PlanarBranch>& branches, const Pose3& X_RC) {
  std::vector<Pose3> poses;
  for (const PlanarBranch& branch : branches) poses.push_back(X_RC * branch.X_CB);
  return poses;
}

/// Both eyes know their marks: point stereo on complete sets, rigid fit, joint fit.
std::optional<Fix> FromBoth(const Eyes& eyes, const StereoRig& rig, const FiducialBoard& board,
                            const EyeCorrespondence& left, const EyeCorrespondence& right) {
  std::vector<Pose3> starts = InRover(left.branches, eyes.views[0].X_RC);
  const auto stereo = StereoPose(rig, board, left.centres, right.centres);
  if (stereo) starts.insert(starts.begin(), *stereo);
  const auto marks = Joined(Marks(eyes, 0, left.matches), Marks(eyes, 1, right.matches));
  return BestJointFit(eyes, board, marks, starts);
}

/// One eye knows its marks; the other is searched where they should be.
std::optional<Fix> FromOneAndSearch(const Eyes& eyes, const FiducialBoard& board, int view,
                                    const EyeCorrespondence& eye) {
  const int other = 1 - view;
  const std::size_t v = static_cast<std::size_t>(view), o = static_cast<std::size_t>(other);
  std::optional<Fix> best;
  for (const Pose3& X_RB : InRover(eye.branches, eyes.views[v].X_RC)) {
    const Pose3 X_OB = Inverse(eyes.views[o].X_RC) * X_RB;
    const auto matches =
        MatchByPose(eyes.detections[o], eyes.views[o].camera, board, X_OB, kCrossGatePx);
    if (static_cast<int>(matches.size()) < kMinSecondEye) continue;
    const auto marks = Joined(Marks(eyes, view, eye.matches), Marks(eyes, other, matches));
    const auto fix = BestJointFit(eyes, board, marks, {X_RB});
    if (fix && (!best || fix->marks.size() > best->marks.size() ||
                (fix->marks.size() == best->marks.size() && fix->fit.cost < best->fit.cost))) {
      best = fix;
    }
  }
  return best;
}

std::optional<Fix> FromOne(const Eyes& eyes, const FiducialBoard& board, int view,
                           const EyeCorrespondence& eye, const LocateHints& hints) {
  const CameraView& camera = eyes.views[static_cast<std::size_t>(view)];
  const auto chosen = ChooseBranch(eye.branches, camera.X_RC, hints);
  if (!chosen) return std::nullopt;
  std::vector<MarkPixel> marks = Marks(eyes, view, eye.matches);
  for (MarkPixel& mark : marks) mark.view = 0;
  RefinedPose fit = RefinePose(marks, {camera}, board, camera.X_RC * eye.branches[*chosen].X_CB);
  for (MarkPixel& mark : marks) mark.view = view;
  return Fix{std::move(fit), marks, view == 0 ? "left" : "right"};
}

SightingReport Report(const Fix& fix, SightingReport report) {
  report.method = fix.method;
  report.reprojection_px = fix.fit.rms_px;
  report.X_RB = fix.fit.X_RB;
  for (const MarkPixel& mark : fix.marks) {
    report.marks.push_back({.id = mark.id,
                            .right_camera = mark.view == 1,
                            .u_px = mark.pixel.x(),
                            .v_px = mark.pixel.y()});
  }
  return report;
}

LocateOutput Refuse(PoseFailure failure, SightingReport report) {
  report.accepted = false;
  report.reason = Name(failure);
  return {failure, std::move(report)};
}

LocateOutput Settle(const Eyes& eyes, const FiducialBoard& board, const LocateHints& hints,
                    const Fix& fix, SightingReport report) {
  report = Report(fix, std::move(report));
  const bool stereo = fix.method == "stereo";
  const std::vector<CameraView> used =
      stereo ? eyes.views : std::vector<CameraView>{eyes.views[fix.method == "left" ? 0 : 1]};
  if (const auto failure = Judge(fix.fit, used, board, hints)) {
    return Refuse(*failure, std::move(report));
  }
  report.accepted = true;
  const DockSighting sighting{.X_RB = fix.fit.X_RB,
                              .reprojection_px = fix.fit.rms_px,
                              .fiducials_used = static_cast<int>(fix.marks.size()),
                              .stereo = stereo};
  return {sighting, std::move(report)};
}

/// The reason of the eye that came further.
PoseFailure Nearer(PoseFailure left, PoseFailure right) {
  return left == PoseFailure::kTooFewFiducials ? right : left;
}

}  // namespace

const char* Name(PoseFailure failure) {
  switch (failure) {
    case PoseFailure::kTooFewFiducials:
      return "too few fiducials";
    case PoseFailure::kNoCorrespondence:
      return "no correspondence";
    case PoseFailure::kBehindCamera:
      return "behind camera";
    case PoseFailure::kPoorFit:
      return "poor fit";
    case PoseFailure::kEyesDisagree:
      return "eyes disagree";
    case PoseFailure::kNotUpright:
      return "not upright";
  }
  return "unknown";
}

LocateOutput LocateBoard(const StereoImages& images, const StereoRig& rig,
                         const FiducialBoard& board, const LocateHints& hints) {
  Eyes eyes{
      .detections = {DetectFiducials(images.left, board), DetectFiducials(images.right, board)},
      .views = Views(rig)};
  std::vector<EyeResult> found;
  for (std::size_t v = 0; v < 2; ++v) {
    const Eigen::Vector3d up_C = eyes.views[v].X_RC.R.transpose() * hints.up_R;
    AssignRotations(eyes.detections[v], eyes.views[v].camera, up_C);
    found.push_back(Correspond(eyes.detections[v], eyes.views[v].camera, board, up_C));
  }
  SightingReport report;
  report.detected_left = static_cast<int>(eyes.detections[0].size());
  report.detected_right = static_cast<int>(eyes.detections[1].size());
  if (!found[0] && !found[1]) {
    return Refuse(Nearer(found[0].error(), found[1].error()), std::move(report));
  }
  const int view = found[0] ? 0 : 1;
  const EyeCorrespondence& eye = *found[static_cast<std::size_t>(view)];
  std::optional<Fix> fix = found[0] && found[1] ? FromBoth(eyes, rig, board, *found[0], *found[1])
                                                : FromOneAndSearch(eyes, board, view, eye);
  if (fix) fix = WithAllMarks(eyes, board, *fix);
  if (!fix) fix = FromOne(eyes, board, view, eye, hints);
  if (!fix) return Refuse(PoseFailure::kNotUpright, std::move(report));
  return Settle(eyes, board, hints, *fix, std::move(report));
}

}  // namespace dockyard
