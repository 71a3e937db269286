#include "controller/custom/dock_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace dockyard::custom {
namespace {

constexpr double kGate = 16.27;    // chi-square, 3 degrees of freedom, 99.9 %
constexpr double kDecided = 13.8;  // a likelihood ratio of 1000: 2 ln 1000
// Errors of floor and reprojection stay alike from image to image: each counts as this part of one
// that is independent. Assumed, 2-5.
constexpr double kAlike = 3.0;
// Sightings in a row that fit no hypothesis: then the dock is elsewhere. Assumed, 3-10.
constexpr int kMostMissed = 5;
// Two hypotheses that have come so close are one. Assumed, 2-10 mm, 0.5-2 deg.
constexpr double kOne_m = 0.005, kOne_rad = Radians(1.0);

Eigen::Vector3d Difference(const Pose2& a, const Eigen::Vector3d& b) {
  return {a.x - b.x(), a.y - b.y(), WrapPi(a.heading - b.z())};
}

}  // namespace

void DockFilter::Drive(const Pose2& X_OA, const Motion& motion, double dt_s) {
  X_OA_ = X_OA;
  const double length = std::abs(motion.length_m), turn = std::abs(motion.turn_rad);
  const double turn_share = has_imu_ ? noise_.turn_share_imu : noise_.turn_share;
  const double heading = has_imu_ ? 0.0 : std::pow(noise_.heading_rad_per_sqrt_m, 2) * length;
  const Eigen::Vector3d Q(std::pow(noise_.length_share, 2) * length,
                          std::pow(noise_.aside_share, 2) * length,
                          std::pow(turn_share, 2) * turn + heading +
                              (has_imu_ ? std::pow(noise_.drift_rad_per_sqrt_s, 2) * dt_s : 0.0));
  if (Q.isZero()) return;
  const double c = std::cos(X_OA.heading), s = std::sin(X_OA.heading);
  for (Hypothesis& hypothesis : kept_) {
    // A step or turn of A by more than odometry has moves the dock in O against it.
    Eigen::Matrix3d G;
    G << c, -s, -(hypothesis.mean.y() - X_OA.y),  //
        s, c, hypothesis.mean.x() - X_OA.x,       //
        0.0, 0.0, 1.0;
    hypothesis.P += G * Q.asDiagonal() * G.transpose();
  }
}

/// The weight of the next sighting: less for each before it from the same place.
double DockFilter::CountHere() {
  const double moved_m = std::hypot(X_OA_.x - X_OA_place_.x, X_OA_.y - X_OA_place_.y);
  if (from_here_ == 0 || moved_m >= errors_.place_m) {
    X_OA_place_ = X_OA_;
    from_here_ = 0;
  }
  ++from_here_;
  return 1.0 / from_here_;
}

/// Probabilistic data association (Bar-Shalom and Tse, Automatica 11, 1975): each branch within the
/// gate counts by its likelihood, and their spread adds to the covariance. Where the camera faces
/// the board, both branches are near. The nearest one alone would only confirm the estimate.
/// One wild sighting must not decide between hypotheses, so a score grows by no more than the
/// chance of one allows.
bool DockFilter::Take(const std::vector<DockFix>& fixes, double weight,
                      Hypothesis* hypothesis) const {
  struct Candidate {
    Eigen::Vector3d error;
    const DockFix* fix;
    double cost;
  };
  std::vector<Candidate> candidates;
  double least = std::numeric_limits<double>::infinity();
  for (const DockFix& fix : fixes) {
    if (fix.misfit > kGate) continue;
    const Eigen::Vector3d error = Difference(fix.X_OD, hypothesis->mean);
    const double distance2 = error.dot((hypothesis->P + fix.covariance).ldlt().solve(error));
    if (!(distance2 <= kGate)) continue;
    candidates.push_back({error, &fix, distance2 + fix.misfit / kAlike});
    least = std::min(least, candidates.back().cost);
  }
  const double score = -2.0 * std::log(std::exp(-0.5 * least) + errors_.wild_share);
  hypothesis->score += weight * score;
  if (candidates.empty()) {
    ++hypothesis->missed;
    return false;
  }
  double sum = 0.0;
  Eigen::Vector3d error = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Zero(), spread = Eigen::Matrix3d::Zero();
  for (const Candidate& candidate : candidates) {
    const double share = std::exp(0.5 * (least - candidate.cost));
    sum += share;
    error += share * candidate.error;
    R += share * candidate.fix->covariance;
    spread += share * candidate.error * candidate.error.transpose();
  }
  error /= sum;
  R /= sum * weight;
  spread = spread / sum - error * error.transpose();
  const Eigen::Matrix3d K = (hypothesis->P + R).ldlt().solve(hypothesis->P).transpose();
  hypothesis->mean += K * error;
  hypothesis->mean.z() = WrapPi(hypothesis->mean.z());
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - K;
  hypothesis->P = rest * hypothesis->P * rest.transpose() + K * (R + spread) * K.transpose();
  hypothesis->missed = 0;
  return true;
}

void DockFilter::Restart(const std::vector<DockFix>& fixes) {
  kept_.clear();
  for (const DockFix& fix : fixes) {
    if (fix.misfit > kGate) continue;
    kept_.push_back({.mean = {fix.X_OD.x, fix.X_OD.y, fix.X_OD.heading},
                     .P = fix.covariance,
                     .score = fix.misfit / kAlike});
  }
}

bool DockFilter::See(const std::vector<DockFix>& fixes) {
  if (fixes.empty()) return false;
  const bool usable = std::any_of(fixes.begin(), fixes.end(),
                                  [](const DockFix& fix) { return fix.misfit <= kGate; });
  if (!usable) return false;
  const double weight = CountHere();
  bool taken = false;
  for (Hypothesis& hypothesis : kept_) taken = Take(fixes, weight, &hypothesis) || taken;
  const bool elsewhere =
      !kept_.empty() && std::all_of(kept_.begin(), kept_.end(), [](const Hypothesis& hypothesis) {
        return hypothesis.missed >= kMostMissed;
      });
  if (kept_.empty() || elsewhere) {
    Restart(fixes);
    taken = true;
  }
  if (taken) lasting_ = fixes.front().lasting;
  Decide();
  return taken && kept_.front().missed == 0;
}

void DockFilter::Decide() {
  std::stable_sort(kept_.begin(), kept_.end(),
                   [](const Hypothesis& a, const Hypothesis& b) { return a.score < b.score; });
  const Hypothesis first = kept_.front();
  const auto given_up = [&](const Hypothesis& other) {
    return other.score > first.score + kDecided ||
           ((other.mean - first.mean).head<2>().norm() < kOne_m &&
            std::abs(WrapPi(other.mean.z() - first.mean.z())) < kOne_rad);
  };
  kept_.erase(std::remove_if(kept_.begin() + 1, kept_.end(), given_up), kept_.end());
  for (Hypothesis& hypothesis : kept_) hypothesis.score -= first.score;
}

void DockFilter::Loosen(double sigma_m, double sigma_rad) {
  for (Hypothesis& hypothesis : kept_)
    hypothesis.P.diagonal() += Eigen::Vector3d(sigma_m, sigma_m, sigma_rad).cwiseAbs2();
}

Pose2 DockFilter::X_OD() const {
  const Eigen::Vector3d& mean = kept_.front().mean;
  return {mean.x(), mean.y(), mean.z()};
}

}  // namespace dockyard::custom
