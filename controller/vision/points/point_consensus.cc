#include "controller/vision/points/point_consensus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "controller/vision/p3p.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxTriples = 400;
// A pose from three points errs by pixels elsewhere, in the other image by the calibration's error
// too (0.5 deg at 700 px a radian). Assumed, 2-8 and 6-20.
constexpr double kOwnGate_px = 5.0, kOtherGate_px = 12.0;
// A gate is widened by this many sigmas of the survey's error: the point's own, and the one that
// the three points pass on. Assumed, 2-5.
constexpr double kSurveySigmas = 3.0;

std::vector<std::array<std::size_t, 3>> Triples(const std::vector<std::size_t>& of) {
  std::vector<std::array<std::size_t, 3>> triples;
  const std::size_t n = of.size();
  if (n < 3) return triples;
  if (n * (n - 1) * (n - 2) / 6 <= kMaxTriples) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        for (std::size_t k = j + 1; k < n; ++k) triples.push_back({of[i], of[j], of[k]});
      }
    }
    return triples;
  }
  std::uint64_t state = 1;  // the same triples every time: Knuth's linear congruence
  const auto pick = [&] {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return of[(state >> 33) % n];
  };
  while (triples.size() < kMaxTriples) {
    const std::array<std::size_t, 3> t{pick(), pick(), pick()};
    if (t[0] != t[1] && t[1] != t[2] && t[0] != t[2]) triples.push_back(t);
  }
  return triples;
}

class Search {
 public:
  Search(const std::vector<PointPixel>& points, const std::vector<CameraView>& views,
         double survey_m)
      : points_(points), views_(views), survey_m_(survey_m) {}

  void Try(const Pose3& X_RB, int view);
  std::optional<PointConsensus> best{};

 private:
  double Share(const PointPixel& point, const std::array<Pose3, 2>& X_CB, int view) const;

  const std::vector<PointPixel>& points_;
  const std::vector<CameraView>& views_;
  double survey_m_;
  double least_ = 1e18;
};

/// Squared error over squared gate.
double Search::Share(const PointPixel& point, const std::array<Pose3, 2>& X_CB, int view) const {
  const Camera& camera = views_[static_cast<std::size_t>(point.view)].camera;
  const Pose3& X = X_CB[static_cast<std::size_t>(point.view)];
  const Eigen::Vector3d p_C = X * point.p_B;
  auto pixel = camera.Project(p_C);
  if (pixel && point.disc_diameter_m > 0.0) {
    pixel = ProjectDisc(camera, X, point.p_B, point.disc_diameter_m);
  }
  if (!pixel) return 1e6;
  const double survey = point.survey_m >= 0.0 ? point.survey_m : survey_m_;
  const double gate = std::hypot(point.view == view ? kOwnGate_px : kOtherGate_px,
                                 kSurveySigmas * survey * camera.focal_px().x() / p_C.norm());
  return (*pixel - point.pixel).squaredNorm() / (gate * gate);
}

void Search::Try(const Pose3& X_RB, int view) {
  std::array<Pose3, 2> X_CB;
  for (std::size_t v = 0; v < views_.size(); ++v) X_CB[v] = Inverse(views_[v].X_RC) * X_RB;
  double sum = 0.0;
  std::vector<bool> inlier(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double share = Share(points_[i], X_CB, view);
    inlier[i] = share < 1.0;
    sum += std::min(share, 1.0);
    if (sum >= least_) return;
  }
  least_ = sum;
  best = {.X_RB = X_RB, .inlier = std::move(inlier)};
}

}  // namespace

std::optional<PointConsensus> FindConsensus(const std::vector<PointPixel>& points,
                                            const std::vector<CameraView>& views, double survey_m) {
  Search search(points, views, survey_m);
  for (int view = 0; view < static_cast<int>(views.size()); ++view) {
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].view == view) mine.push_back(i);
    }
    const CameraView& seen_by = views[static_cast<std::size_t>(view)];
    for (const auto& triple : Triples(mine)) {
      std::array<Eigen::Vector3d, 3> points_B, sights_C;
      for (std::size_t k = 0; k < 3; ++k) {
        points_B[k] = points[triple[k]].p_B;
        sights_C[k] = seen_by.camera.Direction(points[triple[k]].pixel);
      }
      for (const Pose3& X_CB : PosesFromThreePoints(points_B, sights_C)) {
        search.Try(seen_by.X_RC * X_CB, view);
      }
    }
  }
  return search.best;
}

}  // namespace dockyard
