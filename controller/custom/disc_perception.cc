#include <algorithm>

#include "controller/custom/sighting.h"
#include "controller/vision/board/correspond.h"
#include "controller/vision/board/fiducials.h"
#include "controller/vision/board/pose_gates.h"
#include "controller/vision/pose_refine.h"

namespace dockyard::custom {
namespace {

// A fit whose errors exceed their prediction by this factor has false marks. Assumed, 2-6: lenses
// and boards of users err more than the prediction.
constexpr double kPoor = 3.0;

std::vector<MarkPixel> MarksOf(const std::vector<MarkMatch>& matches,
                               const std::vector<DetectedFiducial>& detections) {
  std::vector<MarkPixel> marks;
  for (const MarkMatch& match : matches) {
    const DetectedFiducial& mark = detections[static_cast<std::size_t>(match.detection)];
    marks.push_back({.id = match.id, .pixel = mark.rim.centre_px, .sigma_px = mark.sigma_px});
  }
  return marks;
}

/// Both branches, refined with their covariances; fits that cannot be are left out.
std::vector<PoseBranch> BranchesOf(const std::vector<PlanarBranch>& found,
                                   const std::vector<MarkPixel>& marks, const Camera& camera,
                                   const FiducialBoard& board) {
  const std::vector<CameraView> view{{camera, Pose3{}}};
  const RefineOptions options{.fit_turn = false};
  std::vector<PoseBranch> branches;
  for (const PlanarBranch& branch : found) {
    const RefinedPose fit = RefinePose(marks, view, board, branch.X_CB, options);
    const bool again = std::any_of(branches.begin(), branches.end(), [&](const PoseBranch& other) {
      return (fit.X_RB.R - other.X_CB.R).norm() < Radians(0.1);
    });
    if (again || !ShowsItsFace(fit.X_RB)) continue;
    if (fit.freedom > 0 && fit.misfit > kPoor * ChiSquareLimit(fit.freedom)) continue;
    branches.push_back({fit.X_RB, fit.rms_px, fit.misfit, fit.freedom, fit.covariance});
  }
  std::stable_sort(branches.begin(), branches.end(),
                   [](const PoseBranch& a, const PoseBranch& b) { return a.misfit < b.misfit; });
  return branches;
}

BoardSighting Locate(const GrayImage& image, const CameraImage& taken, const RobotCamera& camera,
                     const FiducialBoard& board, int index, const Eigen::Vector3d& up_R) {
  BoardSighting sighting{.exposed = taken.exposed, .camera = taken.camera, .board = index};
  std::vector<DetectedFiducial> detections = DetectFiducials(image, board);
  std::erase_if(detections, [&](const DetectedFiducial& detection) {
    return !camera.camera.HasRay(detection.rim.centre_px);
  });
  sighting.detected = static_cast<int>(detections.size());
  const Eigen::Vector3d up_C = camera.X_RC.R.transpose() * up_R;
  AssignRotations(detections, camera.camera, up_C);
  const auto named = Correspond(detections, camera.camera, board, up_C, MarksNeeded(board));
  if (!named) {
    sighting.failure = Name(named.error());
    return sighting;
  }
  const std::vector<MarkPixel> marks = MarksOf(named->matches, detections);
  for (const MarkPixel& mark : marks)
    sighting.marks.push_back({mark.id, taken.camera, mark.pixel.x(), mark.pixel.y()});
  sighting.branches = BranchesOf(named->branches, marks, camera.camera, board);
  if (sighting.branches.empty()) sighting.failure = Name(PoseFailure::kPoorFit);
  return sighting;
}

}  // namespace

Result<Perceive, Refusal> PerceiveDiscs(const Nominal& nominal) {
  for (const DockBoard& board : nominal.boards) {
    if (board.board.fiducials.empty())
      return Refusal{"board " + board.name + ": expected discs on it"};
  }
  return Perceive([nominal](const CameraImage& image, const Eigen::Vector3d& up_R) {
    std::vector<BoardSighting> sightings;
    const RobotCamera& camera = nominal.cameras[static_cast<std::size_t>(image.camera)];
    const GrayImage grey = GreyOf(image);
    for (std::size_t i = 0; i < nominal.boards.size(); ++i) {
      sightings.push_back(
          Locate(grey, image, camera, nominal.boards[i].board, static_cast<int>(i), up_R));
    }
    return sightings;
  });
}

}  // namespace dockyard::custom
