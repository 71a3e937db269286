#include "controller/vision/points/point_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/median.h"
#include "controller/geometry/decompositions.h"
#include "controller/vision/points/point_acceptance.h"
#include "controller/vision/points/point_consensus.h"
#include "controller/vision/points/point_fit.h"

namespace dockyard {
namespace {

constexpr std::size_t kMinPoints = 4;  // three fix a pose and agree with any

/// Chi-square that good errors exceed one time in 25 000 (Wilson and Hilferty, PNAS 17(12), 1931).
double Limit(std::size_t pixels) {
  constexpr double kNormalQuantile = 3.94;
  const double freedom = 2.0 * static_cast<double>(pixels), share = 2.0 / (9.0 * freedom);
  return freedom * std::pow(1.0 - share + kNormalQuantile * std::sqrt(share), 3);
}

/// The fit of PoseFromPoints: its inputs, and the rounds of fitting and leaving out.
class PointSearch {
 public:
  PointSearch(const std::vector<PointPixel>& points, const std::vector<CameraView>& views,
              const PointOptions& options)
      : points_(points), views_(views), options_(options), groups_(GroupsOf(points)) {}

  Result<PointPose, PoseFailure> Find();

 private:
  double Survey(std::size_t i) const {
    return survey_share_ * (points_[i].survey_m >= 0.0 ? points_[i].survey_m : options_.survey_m);
  }
  PointFit Fit(const PointEstimate& start, bool fit_turn) const {
    return FitPoints(points_, inlier_, views_, start,
                     {.sigma_px = sigma_px_,
                      .survey_m = options_.survey_m,
                      .survey_share = survey_share_,
                      .fit_turn = fit_turn});
  }
  double MedianExcess(const std::vector<PixelError>& errors, double sigma_px, double share) const;
  double Unlikeliness(const std::vector<PixelError>& errors, double sigma_px, double share) const;
  void TakeNoiseOfAll(const std::vector<PixelError>& errors);
  double Misfit(const std::vector<PixelError>& errors, double sigma_px, double survey_share) const;
  void TakeNoiseOfInliers(const std::vector<PixelError>& errors);
  std::vector<bool> Gated(const std::vector<PixelError>& errors) const;
  void AddOtherBranch(PointPose* pose) const;

  const std::vector<PointPixel>& points_;
  const std::vector<CameraView>& views_;
  const PointOptions& options_;
  PointGroups groups_;
  std::vector<bool> inlier_{};
  double sigma_px_ = 0.0;
  double survey_share_ = 1.0;  // of the survey's error as given
};

/// The least noise of pixels, not below `least_px`, at which `excess` is not positive; it must fall
/// with the noise.
template <class Excess>
double NoiseWhere(double least_px, Excess excess) {
  constexpr double kMost_px = 1e4;
  if (excess(least_px) <= 0.0) return least_px;
  double low = least_px, high = kMost_px;
  while (high > 1.001 * low) {
    const double middle = std::sqrt(low * high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  return high;
}

/// The median of the squared sigmas less its expected value, over every pixel, so that it does not
/// depend on which were left out.
double PointSearch::MedianExcess(const std::vector<PixelError>& errors, double sigma_px,
                                 double share) const {
  std::vector<double> squares;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    squares.push_back(SquaredSigmas(errors, {i}, sigma_px, share * Survey(i)));
  }
  // Chi-square's median with two degrees of freedom, less the part that the pose takes.
  const double count = static_cast<double>(errors.size());
  return Median(squares) - 2.0 * std::log(2.0) * std::max(0.25, 1.0 - 3.0 / count);
}

/// Twice the negative logarithm of the errors' likelihood but for a constant; errors beyond the
/// gate count as if on it.
double PointSearch::Unlikeliness(const std::vector<PixelError>& errors, double sigma_px,
                                 double share) const {
  double sum = 0.0;
  for (const auto& group : groups_) {
    const double survey = share * Survey(group[0]) / sigma_px;
    Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
    for (const std::size_t i : group) {
      A += survey * survey * errors[i].by_point.transpose() * errors[i].by_point;
    }
    sum += std::min(Limit(group.size()), SquaredSigmas(errors, group, sigma_px, survey * sigma_px));
    sum += 4.0 * static_cast<double>(group.size()) * std::log(sigma_px) + std::log(A.determinant());
  }
  return sum;
}

/// Where errors are larger than stated, either the pixels are noisier or the survey is worse: the
/// likelier of the two.
void PointSearch::TakeNoiseOfAll(const std::vector<PixelError>& errors) {
  constexpr double kMostShare = 10.0;  // beyond it no survey error; assumed, 5-20
  survey_share_ = 1.0;
  sigma_px_ = NoiseWhere(options_.sigma_px,
                         [&](double sigma_px) { return MedianExcess(errors, sigma_px, 1.0); });
  if (sigma_px_ <= options_.sigma_px) return;
  const double share =
      NoiseWhere(1.0, [&](double by) { return MedianExcess(errors, options_.sigma_px, by); });
  if (share > kMostShare ||
      Unlikeliness(errors, options_.sigma_px, share) >= Unlikeliness(errors, sigma_px_, 1.0)) {
    return;
  }
  sigma_px_ = options_.sigma_px;
  survey_share_ = share;
}

/// Sum of squares of all that agree, in sigmas of pixels and survey.
double PointSearch::Misfit(const std::vector<PixelError>& errors, double sigma_px,
                           double survey_share) const {
  double squares = 0.0;
  for (const auto& group : groups_) {
    std::vector<std::size_t> mine;
    for (const std::size_t i : group) {
      if (inlier_[i]) mine.push_back(i);
    }
    if (mine.empty()) continue;
    squares += SquaredSigmas(errors, mine, sigma_px, survey_share * Survey(mine[0]));
  }
  return squares;
}

/// How far the fitted turn of the cameras is from the belief before it, in sigmas squared.
double TurnSquares(const RefinedPose& fit, bool fit_turn) {
  const CameraTurn before{};
  if (!fit_turn) return 0.0;
  return fit.turn.mean_rad.cwiseAbs2().cwiseQuotient(before.covariance.diagonal()).sum();
}

/// Takes the noise from the residuals, for the covariance. Given points may be measured less
/// precisely than our fiducials, and surveyed better than stated.
void PointSearch::TakeNoiseOfInliers(const std::vector<PixelError>& errors) {
  // Weight of the survey's stated error against the residuals, in degrees of freedom: those of one
  // more pixel. Assumed, 1-4.
  constexpr double kPriorFreedom = 2.0;
  const double used = static_cast<double>(std::count(inlier_.begin(), inlier_.end(), true));
  const double freedom = std::max(1.0, 2.0 * used - 6.0);
  sigma_px_ = NoiseWhere(options_.sigma_px,
                         [&](double sigma_px) { return Misfit(errors, sigma_px, 1.0) - freedom; });
  if (sigma_px_ > options_.sigma_px) return;
  constexpr double kLeastShare = 0.1;
  survey_share_ *= std::min(1.0, NoiseWhere(kLeastShare, [&](double share) {
                              return Misfit(errors, sigma_px_, share) +
                                     kPriorFreedom / (share * share) - freedom - kPriorFreedom;
                            }));
}

/// Pixels that agree with the pose by themselves, and with the other pixels of their point.
std::vector<bool> PointSearch::Gated(const std::vector<PixelError>& errors) const {
  std::vector<bool> inlier(points_.size(), false);
  for (const auto& group : groups_) {
    const auto squares = [&](const std::vector<std::size_t>& pixels) {
      return SquaredSigmas(errors, pixels, sigma_px_, Survey(pixels[0]));
    };
    std::vector<std::size_t> agree;
    for (const std::size_t i : group) {
      if (squares({i}) < Limit(1)) agree.push_back(i);
    }
    while (agree.size() > 1 && squares(agree) >= Limit(agree.size())) {
      std::size_t worst = 0;
      double least = 1e300;
      for (std::size_t k = 0; k < agree.size(); ++k) {
        std::vector<std::size_t> others = agree;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
        if (squares(others) < least) {
          least = squares(others);
          worst = k;
        }
      }
      agree.erase(agree.begin() + static_cast<std::ptrdiff_t>(worst));
    }
    for (const std::size_t i : agree) inlier[i] = true;
  }
  return inlier;
}

/// The planar ambiguity's other branch: the plane's normal mirrored about the line of sight.
void PointSearch::AddOtherBranch(PointPose* pose) const {
  std::vector<PointPixel> chosen;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (inlier_[i]) chosen.push_back(points_[i]);
  }
  Eigen::Vector3d centre_B;
  const auto normal_B = PlaneNormal(chosen, &centre_B);
  if (!normal_B) return;
  const CameraView& view = views_[static_cast<std::size_t>(chosen.front().view)];
  const Pose3 X_CB = Inverse(view.X_RC) * pose->fit.X_RB;
  const Eigen::Vector3d centre_C = X_CB * centre_B, sight = centre_C.normalized();
  const Eigen::Vector3d normal = X_CB.R * *normal_B;
  const Eigen::Vector3d other = 2.0 * normal.dot(sight) * sight - normal;
  Pose3 start;
  start.R = RotationBetween(normal, other) * X_CB.R;
  start.p = centre_C - start.R * centre_B;
  PointEstimate estimate;
  estimate.pose.X_RB = view.X_RC * start;
  const RefinedPose fit = Fit(estimate, false).fit;
  if (Eigen::AngleAxisd(fit.X_RB.R.transpose() * pose->fit.X_RB.R).angle() < Radians(0.5)) return;
  pose->other_RB = fit.X_RB;
  pose->other_cost = fit.cost;
  if (fit.cost < pose->fit.cost) {
    pose->other_RB = pose->fit.X_RB;
    pose->other_cost = pose->fit.cost;
    pose->fit = fit;
  }
}

Result<PointPose, PoseFailure> PointSearch::Find() {
  constexpr int kRounds = 8;  // two or three are enough where the points agree
  if (groups_.size() < kMinPoints) return PoseFailure::kTooFewFiducials;
  const auto consensus = FindConsensus(points_, views_, options_.survey_m);
  if (!consensus) return PoseFailure::kNoCorrespondence;
  PointPose pose{.fit = {}, .inlier = {}, .method = {}, .other_RB = {}};
  inlier_ = consensus->inlier;
  sigma_px_ = options_.sigma_px;
  PointEstimate at;
  at.pose.X_RB = consensus->X_RB;
  std::vector<double> error_px;
  for (int round = 0; round < kRounds; ++round) {
    if (DistinctPoints(points_, inlier_) < kMinPoints) return PoseFailure::kNoCorrespondence;
    pose.method = Method(points_, inlier_);
    const bool fit_turn = pose.method == "stereo";
    const PointFit found = Fit(at, fit_turn);
    at = found.at;
    pose.fit = found.fit;
    const std::vector<PixelError> errors = ErrorsOf(points_, views_, at, fit_turn);
    error_px.clear();
    for (const PixelError& error : errors) error_px.push_back(error.error_px.norm());
    TakeNoiseOfAll(errors);
    const std::vector<bool> gated = Gated(errors);
    const bool same = gated == inlier_;
    if (same || round + 1 == kRounds) {
      // A few residuals show the survey's error too poorly to weigh by it: it goes into the
      // covariance alone.
      TakeNoiseOfInliers(errors);
      // Against the stated pixels, and the survey's error as stated or as lowered, never as raised:
      // so a bad frame shows, and a survey that is better than stated hides nothing. Misfit counts
      // from the share.
      const double least_stated = std::min(1.0, survey_share_) / survey_share_;
      const RefinedPose shown = Fit(at, fit_turn).fit;
      pose.fit.covariance = shown.covariance;
      pose.fit.turn.covariance = shown.turn.covariance;
      pose.fit.misfit = Misfit(errors, options_.sigma_px, least_stated) +
                        at.calibration.squaredNorm() + TurnSquares(found.fit, fit_turn);
      break;
    }
    inlier_ = gated;
  }
  pose.inlier = inlier_;
  pose.sigma_px = sigma_px_;
  pose.survey_share = survey_share_;
  if (const auto failure = JudgePoints(points_, inlier_, error_px, views_, pose.fit)) {
    return *failure;
  }
  if (pose.method != "stereo") AddOtherBranch(&pose);
  return pose;
}

}  // namespace

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

std::string Method(const std::vector<PointPixel>& points, const std::vector<bool>& chosen) {
  std::array<bool, 2> in{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (chosen[i]) in[static_cast<std::size_t>(points[i].view)] = true;
  }
  return in[0] && in[1] ? "stereo" : in[1] ? "right" : "left";
}

Result<PointPose, PoseFailure> SearchPose(const std::vector<PointPixel>& points,
                                          const std::vector<CameraView>& views,
                                          const PointOptions& options) {
  // With more noise than this the cameras are checked one by one. Assumed, 1-4.
  constexpr double kDoubtful_px = 2.0;
  // Each camera alone must fit this many times better than both together: left and right exchanged
  // give 50, chance with five points 1 in 1000. Assumed, 2-6.
  constexpr double kBetterAlone = 3.0;
  const auto found = PointSearch(points, views, options).Find();
  if (found && (found->method != "stereo" || found->sigma_px < kDoubtful_px)) return found;
  std::array<std::vector<PointPixel>, 2> of;
  for (const PointPixel& point : points) of[static_cast<std::size_t>(point.view)].push_back(point);
  if (GroupsOf(of[0]).size() < kMinPoints || GroupsOf(of[1]).size() < kMinPoints) return found;
  int agree = 0;
  for (const auto& mine : of) {
    const auto alone = PointSearch(mine, views, options).Find();
    agree += alone && (!found || kBetterAlone * alone->sigma_px < found->sigma_px);
  }
  // Without a common pose one camera whose points agree by themselves is enough to say so.
  if (agree >= (found ? 2 : 1)) return PoseFailure::kCamerasDisagree;
  return found;
}

}  // namespace dockyard
