#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "controller/vision/board/blobs.h"
#include "controller/vision/board/correspond.h"
#include "controller/vision/board/fiducials.h"
#include "controller/vision/board/fix_fit.h"
#include "controller/vision/board/guided.h"
#include "controller/vision/board/locate.h"
#include "controller/vision/board/noise_raise.h"
#include "controller/vision/board/pose_gates.h"
#include "controller/vision/board/sighting_report.h"
#include "controller/vision/pose_refine.h"
#include "controller/vision/stereo_pose.h"

namespace dockyard {
namespace {

// How far a mark may lie from where the other camera's pose puts it [px]: a mono range error of 0.3
// m at 5 m shifts it by 3 px, 0.5 deg between the cameras by 6 px.
constexpr double kCrossGate_px = 12.0;
constexpr double kFinalGate_px = 4.0;   // the same once both cameras gave the pose
constexpr double kGuidedGate_px = 2.5;  // of a missing mark from its place, and 4 % of its diameter

using CorrespondenceResult = Result<Correspondence, PoseFailure>;

struct DetectedPair {
  std::array<const GrayImage*, 2> images;
  std::array<std::vector<BlobLevel>, 2> levels;
  std::array<std::vector<DetectedFiducial>, 2> detections;
  std::vector<CameraView> views;
  std::array<Eigen::Vector3d, 2> up_C;
  RefineOptions refine;
  bool raise_noise = false;
};

std::size_t Index(int view) { return static_cast<std::size_t>(view); }

std::vector<MarkPixel> Marks(const DetectedPair& pair, int view,
                             const std::vector<MarkMatch>& matches) {
  std::vector<MarkPixel> marks;
  for (const MarkMatch& match : matches) {
    const auto& seen = pair.detections[Index(view)];
    const DetectedFiducial& mark = seen[Index(match.detection)];
    marks.push_back(
        {.id = match.id, .view = view, .pixel = mark.rim.centre_px, .sigma_px = mark.sigma_px});
  }
  return marks;
}

std::vector<MarkPixel> Joined(std::vector<MarkPixel> a, const std::vector<MarkPixel>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

bool Near(const Pose3& a, const Pose3& b) {
  return (a.p - b.p).norm() < 0.05 * a.p.norm() &&
         (a.R - b.R).norm() < std::sqrt(2.0) * Radians(3.0);  // Frobenius: 2 sqrt(2) sin(turn / 2)
}

/// The least-cost joint fit from several starts.
std::optional<Fix> BestJointFit(const DetectedPair& pair, const FiducialBoard& board,
                                const std::vector<MarkPixel>& marks,
                                const std::vector<Pose3>& starts) {
  std::optional<Fix> best;
  for (const Pose3& X_RB : starts) {
    if (best && Near(best->fit.X_RB, X_RB)) continue;  // it would end there again
    RefinedPose fit = RefinePose(marks, pair.views, board, X_RB, pair.refine);
    if (!best || fit.cost < best->fit.cost) best = Fix{std::move(fit), marks, "stereo"};
  }
  return best;
}

/// Where the fit sees the board from, the estimated turn of the cameras included.
Pose3 CameraFromBoard(const DetectedPair& pair, const Fix& fix, int view) {
  return TurnedView(pair.views, Index(view), fix.fit.turn.mean_rad) * fix.fit.X_RB;
}

Fix Refit(const DetectedPair& pair, const FiducialBoard& board, const Fix& fix,
          const std::vector<MarkPixel>& marks) {
  return Refit({.views = pair.views, .board = board, .refine = pair.refine}, fix, marks);
}

/// Gathers the detections of both images where the fit expects them, and fits again.
Fix WithAllMarks(const DetectedPair& pair, const FiducialBoard& board, const Fix& fix) {
  std::vector<MarkPixel> marks;
  for (int view = 0; view < 2; ++view) {
    const auto found = MatchByPose(pair.detections[Index(view)], pair.views[Index(view)].camera,
                                   board, CameraFromBoard(pair, fix, view), kFinalGate_px);
    marks = Joined(marks, Marks(pair, view, found));
  }
  if (marks.size() <= fix.marks.size() || CountIn(marks, 0) < kMinSecondCamera ||
      CountIn(marks, 1) < kMinSecondCamera) {
    return fix;
  }
  const Fix wider = Refit(pair, board, fix, marks);
  return wider.fit.rms_px < fix.fit.rms_px + 0.5 ? wider : fix;
}

/// Searches both images again for the missing fiducials, where the fit puts them.
Fix WithGuidedMarks(const DetectedPair& pair, const FiducialBoard& board, const Fix& fix) {
  std::vector<MarkPixel> marks = fix.marks;
  for (int view = 0; view < 2; ++view) {
    const Pose3 X_CB = fix.method == "stereo"
                           ? CameraFromBoard(pair, fix, view)
                           : Inverse(pair.views[Index(view)].X_RC) * fix.fit.X_RB;
    if (fix.method == (view == 0 ? "right" : "left")) continue;
    const Camera& camera = pair.views[Index(view)].camera;
    for (int id = 0; id < static_cast<int>(board.fiducials.size()); ++id) {
      const bool known = std::any_of(fix.marks.begin(), fix.marks.end(),
                                     [&](const auto& m) { return m.id == id && m.view == view; });
      if (known) continue;
      const Fiducial& fiducial = board.fiducials[Index(id)];
      const auto rim = ExpectedRim(camera, X_CB, fiducial, board.disc_diameter_m);
      if (!rim) continue;
      const auto found = DetectAt(*pair.images[Index(view)], pair.levels[Index(view)], *rim,
                                  ExpectedBar(camera, X_CB, fiducial, board.bar_length_m, *rim),
                                  board, kGuidedGate_px + 0.08 * rim->mean_radius_px());
      if (found)
        marks.push_back(
            {.id = id, .view = view, .pixel = found->rim.centre_px, .sigma_px = found->sigma_px});
    }
  }
  if (marks.size() == fix.marks.size()) return fix;
  const Fix wider = Refit(pair, board, fix, marks);
  return wider.fit.rms_px < fix.fit.rms_px + 0.3 ? wider : fix;
}

std::vector<Pose3> InRover(const std::vector<PlanarBranch>& branches, const Pose3& X_RC) {
  std::vector<Pose3> poses;
  for (const PlanarBranch& branch : branches) poses.push_back(X_RC * branch.X_CB);
  return poses;
}

/// The marks of both images are named: point stereo on complete sets, rigid fit, joint fit.
std::optional<Fix> FromBoth(const DetectedPair& pair, const StereoRig& rig,
                            const FiducialBoard& board, const Correspondence& left,
                            const Correspondence& right) {
  std::vector<Pose3> starts = InRover(left.branches, pair.views[0].X_RC);
  const auto stereo = StereoPose(rig, board, left.centres, right.centres);
  if (stereo) starts.insert(starts.begin(), *stereo);
  const auto marks = Joined(Marks(pair, 0, left.matches), Marks(pair, 1, right.matches));
  return BestJointFit(pair, board, marks, starts);
}

/// The marks of one image are named; the other image is searched where they should be.
std::optional<Fix> FromOneAndSearch(const DetectedPair& pair, const FiducialBoard& board, int view,
                                    const Correspondence& named) {
  const int other = 1 - view;
  std::optional<Fix> best;
  for (const Pose3& X_RB : InRover(named.branches, pair.views[Index(view)].X_RC)) {
    const Pose3 X_OB = Inverse(pair.views[Index(other)].X_RC) * X_RB;
    const auto matches = MatchByPose(pair.detections[Index(other)], pair.views[Index(other)].camera,
                                     board, X_OB, kCrossGate_px);
    if (static_cast<int>(matches.size()) < kMinSecondCamera) continue;
    const auto marks = Joined(Marks(pair, view, named.matches), Marks(pair, other, matches));
    const auto fix = BestJointFit(pair, board, marks, {X_RB});
    if (fix && (!best || fix->marks.size() > best->marks.size() ||
                (fix->marks.size() == best->marks.size() && fix->fit.cost < best->fit.cost))) {
      best = fix;
    }
  }
  return best;
}

/// Neither image has five marks. Four of one prove nothing alone, so two or more of the other must
/// lie where those four put them. Four plain discs are found in too many images.
std::optional<Fix> FromFew(const DetectedPair& pair, const FiducialBoard& board) {
  if (!board.HasBars()) return std::nullopt;
  std::optional<Fix> best;
  for (int view = 0; view < 2; ++view) {
    const auto named = Correspond(pair.detections[Index(view)], pair.views[Index(view)].camera,
                                  board, pair.up_C[Index(view)], 4);
    if (!named) continue;
    auto fix = FromOneAndSearch(pair, board, view, *named);
    if (!fix) continue;
    fix = WithGuidedMarks(pair, board, WithAllMarks(pair, board, *fix));
    if (static_cast<int>(fix->marks.size()) < kMinTogether) continue;
    if (!best || fix->marks.size() > best->marks.size()) best = fix;
  }
  return best;
}

Result<Fix, PoseFailure> FromOne(const DetectedPair& pair, const FiducialBoard& board, int view,
                                 const Correspondence& named, const LocateHints& hints) {
  const CameraView& camera = pair.views[Index(view)];
  const auto chosen = ChooseBranch(named.branches, camera.X_RC, hints, board.upright);
  if (!chosen) return PoseFailure::kNotUpright;
  const Fix at{.fit = {.X_RB = camera.X_RC * named.branches[*chosen].X_CB},
               .marks = {},
               .method = view == 0 ? "left" : "right"};
  const Fix fix = Refit(pair, board, at, Marks(pair, view, named.matches));
  // Errors of board and lens move both branches' costs by as much as they exceed the prediction.
  const double freedom = std::max(1.0, 2.0 * static_cast<double>(named.matches.size()) - 6.0);
  const double noise =
      pair.raise_noise ? std::max(1.0, named.branches[*chosen].cost / freedom) : 1.0;
  if (IsAmbiguous(named.branches, *chosen, camera.X_RC, hints, board.upright, noise))
    return PoseFailure::kAmbiguous;
  return WithGuidedMarks(pair, board, fix);
}

/// The failure of the image that came further.
PoseFailure Nearer(PoseFailure left, PoseFailure right) {
  return left == PoseFailure::kTooFewFiducials ? right : left;
}

Result<Fix, PoseFailure> FindFix(const DetectedPair& pair, const StereoRig& rig,
                                 const FiducialBoard& board, const LocateHints& hints) {
  std::vector<CorrespondenceResult> found;
  for (std::size_t v = 0; v < 2; ++v) {
    found.push_back(Correspond(pair.detections[v], pair.views[v].camera, board, pair.up_C[v],
                               MarksNeeded(board)));
  }
  if (!found[0] && !found[1]) {
    const auto few = FromFew(pair, board);
    if (few) return *few;
    return Nearer(found[0].error(), found[1].error());
  }
  const int view = found[0] ? 0 : 1;
  const Correspondence& named = *found[Index(view)];
  const std::optional<Fix> fix = found[0] && found[1]
                                     ? FromBoth(pair, rig, board, *found[0], *found[1])
                                     : FromOneAndSearch(pair, board, view, named);
  if (!fix) return FromOne(pair, board, view, named, hints);
  return WithGuidedMarks(pair, board, WithAllMarks(pair, board, *fix));
}

RefineOptions Refinement(const LocateHints& hints, const ErrorAllowance& errors) {
  // Root mean square of a parabolic bow about the plane nearest to it, over its height: the root of
  // 4/45.
  constexpr double kOfABow = 0.3;
  RefineOptions refine{.turn = hints.camera_turn, .with_covariance = false};
  refine.off_plane_m = kOfABow * errors.flatness_m;
  if (errors.calibration_px > 0.0) {
    refine.model_px = std::hypot(refine.model_px, errors.calibration_px);
  }
  return refine;
}

}  // namespace

LocateOutput LocateDockyard(const StereoImages& images, const StereoRig& rig,
                            const FiducialBoard& board, const LocateHints& hints,
                            const ErrorAllowance& errors) {
  DetectedPair pair{.images = {&images.left, &images.right},
                    .levels = {BuildLevels(images.left), BuildLevels(images.right)},
                    .detections = {},
                    .views = Views(rig),
                    .up_C = {},
                    .refine = Refinement(hints, errors),
                    .raise_noise = errors.raise_noise};
  SightingReport report;
  for (std::size_t v = 0; v < 2; ++v) {
    pair.up_C[v] = pair.views[v].X_RC.R.transpose() * hints.up_R;
    pair.detections[v] = DetectFiducials(*pair.images[v], pair.levels[v], board);
    // Masked: where the lens's polynomial has turned back, no direction belongs to a pixel.
    std::erase_if(pair.detections[v], [&](const DetectedFiducial& detection) {
      return !pair.views[v].camera.HasRay(detection.rim.centre_px);
    });
    AssignRotations(pair.detections[v], pair.views[v].camera, pair.up_C[v]);
  }
  report.detected = {static_cast<int>(pair.detections[0].size()),
                     static_cast<int>(pair.detections[1].size())};
  const auto found = FindFix(pair, rig, board, hints);
  if (!found) return Refused(found.error(), std::move(report));
  const FitInputs inputs{.views = pair.views, .board = board, .refine = pair.refine};
  const RaisedFix raised = errors.raise_noise ? WithNoiseRaised(inputs, *found)
                                              : RaisedFix{.fix = WithoutStrays(inputs, *found)};
  const Fix& fix = raised.fix;
  Describe(fix, pair.views, board, &report);
  if (raised.failure) return Refused(*raised.failure, std::move(report));
  const bool stereo = fix.method == "stereo";
  const std::vector<CameraView> used =
      stereo ? pair.views : std::vector<CameraView>{pair.views[fix.method == "left" ? 0 : 1]};
  if (const auto failure = Judge(fix.fit, used, hints, board.upright)) {
    return Refused(*failure, std::move(report));
  }
  return Accepted(fix, hints, std::move(report));
}

}  // namespace dockyard
