#include "controller/vision/point_pose.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "controller/geometry/decompositions.h"
#include "controller/vision/p3p.h"
#include "controller/vision/robust_planar_pose.h"
#include "controller/vision/sighting_report.h"
#include "controller/vision/stereo_pose.h"

namespace dockyard {
namespace {

constexpr std::size_t kMinInliers = 4;  // three fix a pose and agree with any
constexpr std::size_t kMaxTriples = 400;
// A pose from three points errs by pixels elsewhere; in the other picture by what the calibration
// is off too (0.5 deg at 700 px a radian). Assumed, 2-8 and 6-20.
constexpr double kOwnGatePx = 5.0, kOtherGatePx = 12.0;

std::vector<double> Errors(const std::vector<PointPixel>& points,
                           const std::vector<CameraView>& views, const Pose3& X_RB) {
  std::vector<double> errors;
  for (const PointPixel& point : points) {
    const CameraView& view = views[static_cast<std::size_t>(point.view)];
    const auto pixel = view.camera.Project(Inverse(view.X_RC) * X_RB * point.p_B);
    errors.push_back(pixel ? (*pixel - point.pixel).norm() : 1e6);
  }
  return errors;
}

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

struct Consensus {
  Pose3 X_RB;
  std::vector<bool> inlier;
  std::size_t count = 0;
  double error = 0.0;
};

/// The pose from three points of one picture that most points agree with.
std::optional<Consensus> FindConsensus(const std::vector<PointPixel>& points,
                                       const std::vector<CameraView>& views) {
  std::optional<Consensus> best;
  for (int view = 0; view < static_cast<int>(views.size()); ++view) {
    std::vector<std::size_t> mine;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (points[i].view == view) mine.push_back(i);
    }
    const CameraView& eye = views[static_cast<std::size_t>(view)];
    for (const auto& triple : Triples(mine)) {
      std::array<Eigen::Vector3d, 3> points_B, sights_C;
      for (std::size_t k = 0; k < 3; ++k) {
        points_B[k] = points[triple[k]].p_B;
        sights_C[k] = eye.camera.Direction(points[triple[k]].pixel);
      }
      for (const Pose3& X_CB : PosesFromThreePoints(points_B, sights_C)) {
        Consensus found{.X_RB = eye.X_RC * X_CB, .inlier = {}};
        const std::vector<double> errors = Errors(points, views, found.X_RB);
        for (std::size_t i = 0; i < points.size(); ++i) {
          const double gate = points[i].view == view ? kOwnGatePx : kOtherGatePx;
          found.inlier.push_back(errors[i] < gate);
          found.count += errors[i] < gate;
          found.error += std::min(errors[i] / gate, 1.0);
        }
        if (!best || found.count > best->count ||
            (found.count == best->count && found.error < best->error)) {
          best = found;
        }
      }
    }
  }
  return best;
}

std::vector<PointPixel> Chosen(const std::vector<PointPixel>& points,
                               const std::vector<bool>& inlier) {
  std::vector<PointPixel> chosen;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (inlier[i]) chosen.push_back(points[i]);
  }
  return chosen;
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Normal of the plane that the points lie in; none when they fill space.
std::optional<Eigen::Vector3d> PlaneNormal(const std::vector<PointPixel>& points,
                                           Eigen::Vector3d* centre) {
  *centre = Eigen::Vector3d::Zero();
  for (const PointPixel& point : points) *centre += point.p_B / static_cast<double>(points.size());
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  for (const PointPixel& point : points) {
    M += (point.p_B - *centre) * (point.p_B - *centre).transpose();
  }
  const SymmetricEigen3 eigen = EigenOfSymmetric(M);
  if (eigen.values(0) > 1e-8 * eigen.values(2)) return std::nullopt;
  return eigen.vectors.col(0);
}

/// The planar ambiguity's other branch: the plane's normal mirrored about the line of sight.
void AddOtherBranch(const std::vector<PointPixel>& points, const std::vector<CameraView>& views,
                    double sigma_px, PointPose* pose) {
  Eigen::Vector3d centre_B;
  const auto normal_B = PlaneNormal(points, &centre_B);
  if (!normal_B) return;
  const CameraView& view = views[static_cast<std::size_t>(points.front().view)];
  const Pose3 X_CB = Inverse(view.X_RC) * pose->fit.X_RB;
  const Eigen::Vector3d centre_C = X_CB * centre_B, sight = centre_C.normalized();
  const Eigen::Vector3d normal = X_CB.R * *normal_B;
  const Eigen::Vector3d other = 2.0 * normal.dot(sight) * sight - normal;
  Pose3 start;
  start.R = RotationBetween(normal, other) * X_CB.R;
  start.p = centre_C - start.R * centre_B;
  const RefinedPose fit =
      RefinePoints(points, views, view.X_RC * start, {.sigma_px = sigma_px, .fit_turn = false});
  if (Eigen::AngleAxisd(fit.X_RB.R.transpose() * pose->fit.X_RB.R).angle() < Radians(0.5)) return;
  pose->other_RB = fit.X_RB;
  pose->other_cost = fit.cost;
  if (fit.cost < pose->fit.cost) {
    pose->other_RB = pose->fit.X_RB;
    pose->other_cost = pose->fit.cost;
    pose->fit = fit;
  }
}

/// The pixels' noise as the fit's residuals show it: whoever found the points may have found them
/// worse than we find fiducials, and the covariance must say so.
double SigmaOf(const RefinedPose& fit, double at_least_px) {
  double squares = 0.0;
  for (const double error : fit.mark_error_px) squares += error * error;
  const double freedom = 2.0 * static_cast<double>(fit.mark_error_px.size()) - 6.0;
  return std::max(at_least_px, std::sqrt(squares / std::max(1.0, freedom)));
}

std::string Method(const std::vector<PointPixel>& points) {
  const auto in = [&](int view) {
    return std::any_of(points.begin(), points.end(), [&](const auto& p) { return p.view == view; });
  };
  return in(0) && in(1) ? "stereo" : in(1) ? "right" : "left";
}

Result<PointPose, PoseFailure> Ours(const std::vector<PointPixel>& points,
                                    const std::vector<CameraView>& views) {
  if (points.size() < kMinInliers) return PoseFailure::kTooFewFiducials;
  const auto consensus = FindConsensus(points, views);
  if (!consensus || consensus->count < kMinInliers) return PoseFailure::kNoCorrespondence;
  PointPose pose{.fit = {}, .inlier = consensus->inlier, .method = {}, .other_RB = {}};
  pose.fit.X_RB = consensus->X_RB;
  double sigma_px = RefineOptions{}.sigma_px;
  for (int round = 0; round < 4; ++round) {
    const std::vector<PointPixel> chosen = Chosen(points, pose.inlier);
    pose.method = Method(chosen);
    RefineOptions options;
    options.fit_turn = pose.method == "stereo";
    options.sigma_px = sigma_px;
    pose.fit = RefinePoints(chosen, views, pose.fit.X_RB, options);
    if (round == 3) break;
    sigma_px = SigmaOf(pose.fit, RefineOptions{}.sigma_px);
    // Residuals with the cameras turned as the fit found them.
    std::vector<CameraView> turned = views;
    if (options.fit_turn) {
      for (std::size_t v = 0; v < 2; ++v) {
        turned[v].X_RC = Inverse(TurnedView(views, v, pose.fit.turn.mean_rad));
      }
    }
    const std::vector<double> errors = Errors(points, turned, pose.fit.X_RB);
    // Rayleigh's median is 1.177 sigma.
    const double gate = std::max(1.0, 4.0 * Median(pose.fit.mark_error_px) / 1.177);
    for (std::size_t i = 0; i < points.size(); ++i) pose.inlier[i] = errors[i] < gate;
    if (Chosen(points, pose.inlier).size() < kMinInliers) return PoseFailure::kPoorFit;
  }
  if (pose.method != "stereo") AddOtherBranch(Chosen(points, pose.inlier), views, sigma_px, &pose);
  return pose;
}

Result<PointPose, PoseFailure> AsTsai(const std::vector<PointPixel>& points, const StereoRig& rig,
                                      const std::vector<CameraView>& views) {
  PointPose pose{.fit = {},
                 .inlier = std::vector<bool>(points.size(), true),
                 .method = Method(points),
                 .other_RB = {}};
  if (pose.method == "stereo") {
    std::vector<Eigen::Vector3d> points_B, points_R;
    for (const PointPixel& left : points) {
      for (const PointPixel& right : points) {
        if (left.view != 0 || right.view != 1 || left.p_B != right.p_B) continue;
        const auto p_R = Triangulate(rig, left.pixel, right.pixel);
        if (!p_R) continue;
        points_B.push_back(left.p_B);
        points_R.push_back(*p_R);
      }
    }
    if (points_B.size() < 3) return PoseFailure::kTooFewFiducials;
    const auto X_RB = FitRigid(points_B, points_R);
    if (!X_RB) return PoseFailure::kNoCorrespondence;
    pose.fit.X_RB = *X_RB;
  } else {
    if (points.size() < 4) return PoseFailure::kTooFewFiducials;
    Eigen::Vector3d centre_B;
    const auto normal_B = PlaneNormal(points, &centre_B);
    if (!normal_B) return PoseFailure::kNoCorrespondence;
    // P: a frame in the plane, z along the normal.
    Pose3 X_BP;
    X_BP.R = RotationBetween(Eigen::Vector3d::UnitZ(), *normal_B);
    X_BP.p = centre_B;
    const CameraView& view = views[pose.method == "left" ? 0 : 1];
    std::vector<Eigen::Vector2d> points_P, sights;
    for (const PointPixel& point : points) {
      points_P.push_back((Inverse(X_BP) * point.p_B).head<2>());
      sights.push_back(LinearSight(view.camera, point.pixel));
    }
    // The plane may face either way: the frame's start assumes z away from the camera.
    auto minima = RobustPlanarPose(points_P, sights);
    const Pose3 X_PF{RotX(kPi), Eigen::Vector3d::Zero()};
    std::vector<Eigen::Vector2d> points_F;
    for (const Eigen::Vector2d& p : points_P) points_F.emplace_back(p.x(), -p.y());
    for (PlanarMinimum minimum : RobustPlanarPose(points_F, sights)) {
      minimum.X_CB = minimum.X_CB * Inverse(X_PF);
      minima.push_back(minimum);
    }
    const auto best = std::min_element(minima.begin(), minima.end(),
                                       [](auto& a, auto& b) { return a.error < b.error; });
    if (best == minima.end()) return PoseFailure::kNoCorrespondence;
    pose.fit.X_RB = view.X_RC * best->X_CB * Inverse(X_BP);
  }
  pose.fit.mark_error_px = Errors(points, views, pose.fit.X_RB);
  double sum = 0.0;
  for (const double error : pose.fit.mark_error_px) sum += error * error;
  pose.fit.rms_px = std::sqrt(sum / static_cast<double>(points.size()));
  return pose;
}

}  // namespace

Result<PointPose, PoseFailure> PoseFromPoints(const std::vector<PointPixel>& points,
                                              const StereoRig& rig,
                                              const VisionSettings& settings) {
  const std::vector<CameraView> views = Views(rig);
  return settings.pipeline == VisionPipeline::kTsai2013 ? AsTsai(points, rig, views)
                                                        : Ours(points, views);
}

}  // namespace dockyard
