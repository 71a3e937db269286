#include <algorithm>
#include <array>

#include "controller/vision/board/tsai2013.h"
#include "controller/vision/homography.h"

namespace dockyard {
namespace {

/// "Closeness threshold" (III-A.3).
double ClosenessPx(const DetectedFiducial& detection, const Tsai2013Vision& settings) {
  return settings.closeness_px + settings.closeness_radii * detection.rim.mean_radius_px();
}

std::vector<PlanePair> Pairs(const std::vector<DetectedFiducial>& detections,
                             const FiducialBoard& board, const std::vector<MarkMatch>& matches) {
  std::vector<PlanePair> pairs;
  for (const MarkMatch& match : matches) {
    pairs.push_back({.board = board.fiducials[static_cast<std::size_t>(match.id)].p_BF,
                     .image = detections[static_cast<std::size_t>(match.detection)].rim.centre_px});
  }
  return pairs;
}

/// The board must not be mirrored or upside down (III-A.3: "cannot be upside down").
bool IsProper(const Eigen::Matrix3d& H) {
  const auto o = Map(H, {0.0, 0.0}), x = Map(H, {0.1, 0.0}), y = Map(H, {0.0, 0.1});
  if (!o || !x || !y) return false;
  const Eigen::Vector2d a = *x - *o, b = *y - *o;
  return a.x() > 0.0 && b.y() > 0.0 && a.x() * b.y() - a.y() * b.x() > 0.0;
}

struct Hypothesis {
  std::vector<MarkMatch> matches;
  std::vector<double> residual_px;
  Eigen::Matrix3d H = Eigen::Matrix3d::Identity();
  double error_px = 0.0;  // mean over the matches
};

/// Detections near the re-projected model, each fiducial and each detection once.
std::vector<MarkMatch> Close(const std::vector<DetectedFiducial>& detections,
                             const FiducialBoard& board, const Eigen::Matrix3d& H,
                             const Tsai2013Vision& settings) {
  struct Pair {
    double distance;
    MarkMatch match;
  };
  std::vector<Pair> pairs;
  for (int id = 0; id < static_cast<int>(board.fiducials.size()); ++id) {
    const auto at = Map(H, board.fiducials[static_cast<std::size_t>(id)].p_BF);
    if (!at) continue;
    for (int d = 0; d < static_cast<int>(detections.size()); ++d) {
      const DetectedFiducial& detection = detections[static_cast<std::size_t>(d)];
      const double distance = (detection.rim.centre_px - *at).norm();
      if (distance < ClosenessPx(detection, settings)) pairs.push_back({distance, {id, d}});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<MarkMatch> close;
  for (const Pair& pair : pairs) {
    const bool taken = std::any_of(close.begin(), close.end(), [&](const MarkMatch& m) {
      return m.id == pair.match.id || m.detection == pair.match.detection;
    });
    if (!taken) close.push_back(pair.match);
  }
  std::sort(close.begin(), close.end(),
            [](const MarkMatch& a, const MarkMatch& b) { return a.id < b.id; });
  return close;
}

/// named: of the detections in `first`, which alone give the homography.
std::optional<Hypothesis> Test(const std::vector<DetectedFiducial>& first,
                               const std::vector<DetectedFiducial>& detections,
                               const FiducialBoard& board, const std::vector<MarkMatch>& named,
                               const VisionSettings& settings) {
  std::optional<Eigen::Matrix3d> H;
  if (settings.min_points <= 4) {
    if (named.size() < 4) return std::nullopt;
    H = FitHomography(Pairs(first, board, named));
  } else {
    // Five or more may vote one out, down to four that agree.
    const auto robust = FitHomographyRobust(Pairs(first, board, named), 6.0, 4);
    if (robust) H = robust->H;
  }
  if (!H || !IsProper(*H)) return std::nullopt;
  Hypothesis hypothesis{.matches = Close(detections, board, *H, settings.tsai2013),
                        .residual_px = {}};
  // Verified by the remaining detections, if there are any.
  const std::size_t agreeing =
      std::min(static_cast<std::size_t>(settings.tsai2013.agreeing_points), detections.size());
  if (hypothesis.matches.size() < agreeing) return std::nullopt;
  const std::vector<PlanePair> pairs = Pairs(detections, board, hypothesis.matches);
  const auto last = FitHomography(pairs);
  if (!last || !IsProper(*last)) return std::nullopt;
  hypothesis.H = *last;
  for (const PlanePair& pair : pairs) {
    const auto at = Map(*last, pair.board);
    if (!at) return std::nullopt;
    hypothesis.residual_px.push_back((*at - pair.image).norm());
    hypothesis.error_px += hypothesis.residual_px.back() / static_cast<double>(pairs.size());
  }
  return hypothesis;
}

/// Smaller comes first.
double Rank(const DetectedFiducial& detection, Tsai2013First first) {
  switch (first) {
    case Tsai2013First::kLowest:
      return -detection.rim.centre_px.y();
    case Tsai2013First::kTopmost:
      return detection.rim.centre_px.y();
    case Tsai2013First::kLeftmost:
      return detection.rim.centre_px.x();
    case Tsai2013First::kLargest:
      break;
  }
  return -detection.rim.mean_radius_px();
}

/// The few detections that are put into the homography (V-D): one of each rotation in the order of
/// their rank, whose namings are the 16 that the paper counts, then the others.
std::vector<DetectedFiducial> Initial(std::vector<DetectedFiducial> detections, int count,
                                      Tsai2013First first) {
  std::stable_sort(detections.begin(), detections.end(),
                   [&](const auto& a, const auto& b) { return Rank(a, first) < Rank(b, first); });
  std::vector<DetectedFiducial> initial, others;
  std::array<bool, 4> taken{};
  for (const DetectedFiducial& detection : detections) {
    bool& mine = taken[static_cast<std::size_t>(detection.rotation_class)];
    (mine ? others : initial).push_back(detection);
    mine = true;
  }
  initial.insert(initial.end(), others.begin(), others.end());
  if (static_cast<int>(initial.size()) > count) initial.resize(static_cast<std::size_t>(count));
  return initial;
}

}  // namespace

Result<TsaiCorrespondence, PoseFailure> CorrespondTsai2013(
    const std::vector<DetectedFiducial>& detections, const FiducialBoard& board,
    const VisionSettings& settings) {
  const int count = std::max(4, settings.min_points);
  if (static_cast<int>(detections.size()) < count) {
    return PoseFailure::kTooFewFiducials;
  }
  const std::vector<DetectedFiducial> first = Initial(detections, count, settings.tsai2013.first);
  std::optional<Hypothesis> best;
  for (const auto& named : NamingHypotheses(first, board, 2)) {
    const auto hypothesis = Test(first, detections, board, named, settings);
    if (hypothesis && (!best || hypothesis->error_px < best->error_px)) best = hypothesis;
  }
  if (!best) return PoseFailure::kNoCorrespondence;
  TsaiCorrespondence named{
      .matches = best->matches, .centres = {}, .residual_px = best->residual_px};
  for (const Fiducial& fiducial : board.fiducials) {
    named.centres.push_back(Map(best->H, fiducial.p_BF).value_or(Eigen::Vector2d(-1.0, -1.0)));
  }
  for (const MarkMatch& match : best->matches) {
    named.centres[static_cast<std::size_t>(match.id)] =
        detections[static_cast<std::size_t>(match.detection)].rim.centre_px;
  }
  return named;
}

}  // namespace dockyard
