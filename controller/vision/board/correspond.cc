#include "controller/vision/board/correspond.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include "controller/vision/board/hypotheses.h"
#include "controller/vision/board/layout_namings.h"
#include "controller/vision/board/pose_gates.h"
#include "controller/vision/homography.h"

namespace dockyard {
namespace {

// A rotation counts as read when its correlation beats the others by this much (assumed,
// 0.05-0.2); else the mark may be any.
constexpr double kSureMargin = 0.10;
constexpr std::size_t kMaxOfOneClass = 3;
constexpr std::size_t kTried = 6;  // hypotheses that get a full pose
// A disc's size against the homography's, either way: detection is right to 10 %.
constexpr double kSizeTolerance = 1.35;

/// Distance within which a projected mark and a detection are one [px].
double GatePx(const DetectedFiducial& detection) {
  return 2.5 + 0.16 * detection.rim.mean_radius_px();
}

struct Scene {
  const std::vector<DetectedFiducial>& detections;
  const Camera& camera;
  const FiducialBoard& board;
  TangentPlane plane;
  std::vector<Eigen::Vector2d> points_T;  // by detection
  double gate_T = 0.0;                    // the widest gate on the tangent plane
  int min_marks = 5;                      // four fix a homography and cannot disagree
};

Scene Prepare(const std::vector<DetectedFiducial>& detections, const Camera& camera,
              const FiducialBoard& board, int min_marks) {
  Scene scene{
      .detections = detections, .camera = camera, .board = board, .plane = {}, .points_T = {}};
  scene.min_marks = min_marks;
  std::vector<Eigen::Vector3d> rays;
  for (const DetectedFiducial& detection : detections) {
    rays.push_back(camera.Direction(detection.rim.centre_px));
    scene.gate_T = std::max(scene.gate_T, GatePx(detection) / camera.focal_px().x());
  }
  scene.plane = TangentPlaneAt(rays);
  for (const Eigen::Vector3d& ray : rays) scene.points_T.push_back(scene.plane.FromRay(ray));
  return scene;
}

std::optional<Eigen::Vector2d> Reproject(const Scene& scene, const Eigen::Matrix3d& H,
                                         const Eigen::Vector2d& p_B) {
  const auto point_T = Map(H, p_B);
  if (!point_T) return std::nullopt;
  return scene.camera.Project(scene.plane.ToRay(*point_T));
}

/// Radius of the projected disc [px], zero when it is seen from behind.
double ProjectedRadius(const Scene& scene, const Eigen::Matrix3d& H, const Fiducial& fiducial) {
  const double r = 0.5 * scene.board.disc_diameter_m;
  const auto c = Reproject(scene, H, fiducial.p_BF);
  const auto x = Reproject(scene, H, fiducial.p_BF + Eigen::Vector2d(r, 0.0));
  const auto y = Reproject(scene, H, fiducial.p_BF + Eigen::Vector2d(0.0, r));
  if (!c || !x || !y) return 0.0;
  const Eigen::Vector2d a = *x - *c, b = *y - *c;
  return std::sqrt(std::max(a.x() * b.y() - a.y() * b.x(), 0.0));
}

bool RotationsAgree(const DetectedFiducial& detection, const Fiducial& fiducial) {
  return detection.rotation_margin < kSureMargin ||
         detection.rotation_class == RotationClass(fiducial.rotation);
}

bool SizesAgree(double radius_px, double projected_px) {
  return radius_px < kSizeTolerance * projected_px && projected_px < kSizeTolerance * radius_px;
}

struct Expected {
  Eigen::Vector2d pixel;
  double radius_px = 0.0;
};

/// Nearest pairs first, each fiducial and each detection once, all within gate_scale gates.
std::vector<MarkMatch> Assign(const std::vector<DetectedFiducial>& detections,
                              const FiducialBoard& board,
                              const std::vector<std::optional<Expected>>& expected,
                              double gate_scale) {
  std::vector<std::tuple<double, int, int>> pairs;
  for (std::size_t id = 0; id < expected.size(); ++id) {
    if (!expected[id]) continue;
    for (std::size_t d = 0; d < detections.size(); ++d) {
      const DetectedFiducial& detection = detections[d];
      const double distance = (detection.rim.centre_px - expected[id]->pixel).norm();
      if (distance > gate_scale * GatePx(detection) ||
          !SizesAgree(detection.rim.mean_radius_px(), expected[id]->radius_px) ||
          !RotationsAgree(detection, board.fiducials[id])) {
        continue;
      }
      pairs.emplace_back(distance, static_cast<int>(id), static_cast<int>(d));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<MarkMatch> matches;
  for (const auto& pair : pairs) {
    const MarkMatch match{.id = std::get<1>(pair), .detection = std::get<2>(pair)};
    const bool taken = std::any_of(matches.begin(), matches.end(), [&](const MarkMatch& m) {
      return m.id == match.id || m.detection == match.detection;
    });
    if (!taken) matches.push_back(match);
  }
  std::sort(matches.begin(), matches.end(),
            [](const MarkMatch& a, const MarkMatch& b) { return a.id < b.id; });
  return matches;
}

std::vector<std::optional<Expected>> ReprojectMarks(const Scene& scene, const Eigen::Matrix3d& H,
                                                    const std::vector<Fiducial>& fiducials) {
  std::vector<std::optional<Expected>> expected;
  for (const Fiducial& fiducial : fiducials) {
    const auto pixel = Reproject(scene, H, fiducial.p_BF);
    expected.emplace_back();
    if (pixel) expected.back() = Expected{*pixel, ProjectedRadius(scene, H, fiducial)};
  }
  return expected;
}

std::vector<std::optional<Expected>> ReprojectBoard(const Scene& scene, const Eigen::Matrix3d& H) {
  return ReprojectMarks(scene, H, scene.board.fiducials);
}

std::vector<PlanePair> Pairs(const Scene& scene, const std::vector<MarkMatch>& matches) {
  std::vector<PlanePair> pairs;
  for (const MarkMatch& match : matches) {
    pairs.push_back({.board = scene.board.fiducials[static_cast<std::size_t>(match.id)].p_BF,
                     .image = scene.points_T[static_cast<std::size_t>(match.detection)]});
  }
  return pairs;
}

struct Candidate {
  std::vector<MarkMatch> matches;
  Eigen::Matrix3d H;
  double rms = 0.0;
};

/// One hypothesis: homography, outliers out, re-projection, vote, homography over all that agree.
/// @param kept  how many of the hypothesis's marks must agree with the first homography
std::optional<Candidate> Test(const Scene& scene, const std::vector<MarkMatch>& hypothesis,
                              int kept) {
  if (hypothesis.size() < 4) return std::nullopt;
  const auto first = FitHomographyRobust(Pairs(scene, hypothesis), scene.gate_T, kept);
  if (!first) return std::nullopt;
  std::vector<MarkMatch> matches =
      Assign(scene.detections, scene.board, ReprojectBoard(scene, first->H), 1.0);
  if (static_cast<int>(matches.size()) < scene.min_marks) return std::nullopt;
  const auto all = FitHomographyRobust(Pairs(scene, matches), scene.gate_T, scene.min_marks);
  if (!all) return std::nullopt;
  Candidate candidate{.matches = {}, .H = all->H, .rms = all->rms};
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (all->inlier[i]) candidate.matches.push_back(matches[i]);
  }
  return candidate;
}

/// The candidates of the hypotheses, best first, each naming once.
/// @param whole  those alone that agree with a homography without leaving out any mark
std::vector<Candidate> Vote(const Scene& scene,
                            const std::vector<std::vector<MarkMatch>>& hypotheses, bool whole) {
  std::vector<Candidate> candidates;
  for (const auto& hypothesis : hypotheses) {
    const int size = static_cast<int>(hypothesis.size());
    const auto candidate = Test(scene, hypothesis, whole ? size : std::min(scene.min_marks, size));
    if (!candidate) continue;
    const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const auto& other) {
      return other.matches == candidate->matches;
    });
    if (!known) candidates.push_back(*candidate);
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(-static_cast<int>(a.matches.size()), a.rms) <
           std::make_tuple(-static_cast<int>(b.matches.size()), b.rms);
  });
  if (candidates.size() > kTried) candidates.resize(kTried);
  return candidates;
}

/// A homography is no pose: the board must also be rigid, plumb and face the camera.
std::vector<PlanarBranch> PossiblePoses(const Scene& scene, const Candidate& candidate,
                                        const Eigen::Vector3d& up_C) {
  std::vector<MarkPixel> marks;
  for (const MarkMatch& match : candidate.matches) {
    const std::size_t d = static_cast<std::size_t>(match.detection);
    marks.push_back({.id = match.id,
                     .view = 0,
                     .pixel = scene.detections[d].rim.centre_px,
                     .sigma_px = scene.detections[d].sigma_px});
  }
  std::vector<PlanarBranch> possible;
  for (const PlanarBranch& branch : PlanarPose(marks, scene.camera, scene.board)) {
    if (ShowsItsFace(branch.X_CB) && IsUpright(branch.X_CB, scene.board.upright, Pose3{}, up_C) &&
        branch.rms_px < RmsGatePx(scene.camera, branch.X_CB, scene.board.disc_diameter_m)) {
      possible.push_back(branch);
    }
  }
  return possible;
}

Correspondence Complete(const Scene& scene, const Candidate& candidate,
                        const std::vector<PlanarBranch>& branches) {
  Correspondence named{.matches = candidate.matches, .centres = {}, .branches = branches};
  for (const Fiducial& fiducial : scene.board.fiducials) {
    const Eigen::Vector2d unseen(-1.0, -1.0);
    named.centres.push_back(Reproject(scene, candidate.H, fiducial.p_BF).value_or(unseen));
  }
  for (const MarkMatch& match : candidate.matches) {
    named.centres[static_cast<std::size_t>(match.id)] =
        scene.detections[static_cast<std::size_t>(match.detection)].rim.centre_px;
  }
  return named;
}

/// Whether the layout alone names the marks: nothing else does for plain discs, and of many bars in
/// one rotation there are too many namings.
bool NamedByLayout(const FiducialBoard& board) {
  std::array<int, 4> of_class{};
  for (const Fiducial& fiducial : board.fiducials) {
    of_class[static_cast<std::size_t>(RotationClass(fiducial.rotation))] += 1;
  }
  return !board.HasBars() ||
         *std::max_element(of_class.begin(), of_class.end()) > static_cast<int>(kMaxOfOneClass);
}

/// Whether most of the detections that both name have another name in the other.
bool Contradict(const std::vector<MarkMatch>& a, const std::vector<MarkMatch>& b) {
  int shared = 0, same = 0;
  for (const MarkMatch& m : a) {
    for (const MarkMatch& n : b) {
      if (m.detection != n.detection) continue;
      ++shared;
      same += m.id == n.id;
    }
  }
  return 2 * same <= shared;
}

/// Whether the board, moved in its own plane, would find at most one mark less. A part of its
/// pattern allows this, and so does a part of a larger pattern. The motions tried put the first
/// mark and its nearest upon any two marks as far apart.
bool FitsElsewhere(const Scene& scene, const Candidate& candidate, const Pose3& X_CB,
                   const Eigen::Vector3d& up_C) {
  const auto& marks = scene.board.fiducials;
  const double near_m = 0.25 * scene.board.disc_diameter_m;
  const auto nearest = std::min_element(marks.begin() + 1, marks.end(), [&](auto& a, auto& b) {
    return (a.p_BF - marks[0].p_BF).norm() < (b.p_BF - marks[0].p_BF).norm();
  });
  const Eigen::Vector2d from = nearest->p_BF - marks[0].p_BF;
  for (const Fiducial& a : marks) {
    for (const Fiducial& b : marks) {
      const Eigen::Vector2d to = b.p_BF - a.p_BF;
      if (&a == &b || std::abs(to.norm() - from.norm()) > near_m) continue;
      const Eigen::Rotation2Dd turn(
          std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to)));
      const Pose3 X_CM = X_CB * Pose3{RotZ(turn.angle()), Eigen::Vector3d::Zero()};
      if (!IsUpright(X_CM, scene.board.upright, Pose3{}, up_C)) continue;
      std::vector<Fiducial> moved = marks;
      double most_m = 0.0;
      for (Fiducial& mark : moved) {
        const Eigen::Vector2d p = a.p_BF + turn * (mark.p_BF - marks[0].p_BF);
        most_m = std::max(most_m, (p - mark.p_BF).norm());
        mark.p_BF = p;
      }
      if (most_m < near_m) continue;  // it stays where it is
      const auto found =
          Assign(scene.detections, scene.board, ReprojectMarks(scene, candidate.H, moved), 1.0);
      if (found.size() + 1 >= candidate.matches.size()) return true;
    }
  }
  return false;
}

/// The best naming, unless another comes near it: a rival has at most one mark less, and fits
/// nearly as well or better.
Result<Correspondence, PoseFailure> BestWithoutRival(
    const Scene& scene, const std::vector<std::vector<MarkMatch>>& hypotheses,
    const Eigen::Vector3d& up_C) {
  constexpr double kFitsAsWell = 3.0, kFitsAsWell_px = 0.3;  // assumed, 2-4 and 0.2-0.5
  std::optional<Correspondence> best;
  for (const Candidate& candidate : Vote(scene, hypotheses, false)) {
    if (best && candidate.matches.size() + 1 < best->matches.size()) break;
    const std::vector<PlanarBranch> branches = PossiblePoses(scene, candidate, up_C);
    if (branches.empty()) continue;
    if (!best) {
      if (FitsElsewhere(scene, candidate, branches[0].X_CB, up_C)) return PoseFailure::kAmbiguous;
      best = Complete(scene, candidate, branches);
      continue;
    }
    const double most_px = kFitsAsWell * best->branches[0].rms_px + kFitsAsWell_px;
    if (branches[0].rms_px < most_px && Contradict(candidate.matches, best->matches)) {
      return PoseFailure::kAmbiguous;
    }
  }
  if (!best) return PoseFailure::kNoCorrespondence;
  return *best;
}

}  // namespace

Result<Correspondence, PoseFailure> Correspond(const std::vector<DetectedFiducial>& detections,
                                               const Camera& camera, const FiducialBoard& board,
                                               const Eigen::Vector3d& up_C, int min_marks) {
  if (static_cast<int>(detections.size()) < min_marks) return PoseFailure::kTooFewFiducials;
  const Scene scene = Prepare(detections, camera, board, min_marks);
  if (NamedByLayout(board)) {
    return BestWithoutRival(scene, NamingsByLayout(detections, camera, board, up_C), up_C);
  }
  const auto hypotheses = NamingHypotheses(detections, board, kMaxOfOneClass);
  std::optional<Correspondence> best;
  // Leaving marks out takes most of the time and serves images with false or misread ones. When
  // every detection or every fiducial is named, no other naming can win.
  const std::size_t most = std::min(detections.size(), board.fiducials.size());
  for (const bool whole : {true, false}) {
    if (best && best->matches.size() == most) break;
    for (const Candidate& candidate : Vote(scene, hypotheses, whole)) {
      if (best && candidate.matches.size() < best->matches.size()) break;  // most marks come first
      const std::vector<PlanarBranch> branches = PossiblePoses(scene, candidate, up_C);
      if (branches.empty()) continue;
      const bool more = !best || candidate.matches.size() > best->matches.size();
      if (more || branches[0].rms_px < best->branches[0].rms_px) {
        best = Complete(scene, candidate, branches);
      }
    }
  }
  if (!best) return PoseFailure::kNoCorrespondence;
  return *best;
}

std::vector<MarkMatch> MatchByPose(const std::vector<DetectedFiducial>& detections,
                                   const Camera& camera, const FiducialBoard& board,
                                   const Pose3& X_CB, double gate_px) {
  std::vector<std::optional<Expected>> expected;
  for (const Fiducial& fiducial : board.fiducials) {
    expected.emplace_back();
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(fiducial.p_BF.x(), fiducial.p_BF.y(), 0.0);
    const auto pixel = ProjectDisc(camera, X_CB, fiducial, board.disc_diameter_m);
    if (!pixel || !camera.Sees(*pixel)) continue;
    const double slant = std::max(X_CB.R.col(2).dot(p_C.normalized()), 0.05);
    const double radius =
        0.5 * board.disc_diameter_m * camera.focal_px().x() / p_C.norm() * std::sqrt(slant);
    expected.back() = Expected{*pixel, radius};
  }
  std::vector<MarkMatch> matches = Assign(detections, board, expected, 10.0);
  std::erase_if(matches, [&](const MarkMatch& m) {
    const auto& pixel = expected[static_cast<std::size_t>(m.id)]->pixel;
    return (detections[static_cast<std::size_t>(m.detection)].rim.centre_px - pixel).norm() >
           gate_px;
  });
  return matches;
}

}  // namespace dockyard
