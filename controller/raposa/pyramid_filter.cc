#include "controller/raposa/pyramid_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/raposa/lean.h"

namespace dockyard::raposa {
namespace {

// The state: X_DN's x, y, heading; the share of the told gauge's turns that comes about; x_R of the
// turning centre; what the left and the right belt's readings say too much, when driven; what
// pictures say too much of a range, as a share: of marks and lens that are not as told.
enum Index { kX, kY, kHeading, kShare, kCentre, kLeftBias, kRightBias, kScale };
constexpr int kLearned = 5;  // the last of them

constexpr std::size_t kRecent = 10;   // control periods that a picture may be old
constexpr std::size_t kMostKept = 4;  // poses at a time; assumed, 3-6
constexpr double kDropped = 24.0;     // behind in log-likelihood; assumed, 15-30
// Of a pose that none foretold: two of its pictures must agree before it can lead, as one picture
// may be wrong. Assumed, 9-15.
constexpr double kBornBehind = 12.0;
// Pictures from almost one place err alike: each counts as a part of one. Assumed, 2-5.
constexpr double kAlike = 3.0;
// A pose that foretold no fit is less sure than it was: sigmas of place and heading grow by this
// factor, up to these. Assumed, 1.5-3, 0.05-0.2 m, 5-15 deg.
constexpr double kDoubt = 2.0, kMostDoubt_m = 0.1, kMostDoubt_rad = Radians(10.0);
constexpr double kFitGate =
    20.0;  // of a squared Mahalanobis distance: one in 6000 of 3 degrees of freedom
constexpr double kMissed = 6.0;        // a fit that fits no pose, in log-likelihood; half the gate
constexpr double kMisfitWeight = 3.0;  // residuals behind a fit's misfit, by two; assumed, 2-6
// Errors of the motion are those of independent stretches of a way, and of parts of a turn.
constexpr double kStretch_m = 0.1;               // assumed, 0.05-0.3
constexpr double kTurnPart_rad = Radians(10.0);  // assumed, 5-30 deg
constexpr double kArmPart_m = 0.02;              // of the arm's way: one press
// A turn slips sideways as so much of a stretch's way for each radian; a way turns by so much on a
// metre. Assumed, 0.1-0.5 m and 0.005-0.02 rad.
constexpr double kTurnSlip_m = 0.2, kWayTurn_rad_m = 0.01;
constexpr double kHypothesis_rad = Radians(30.0);  // of an angle that no image showed
// So far behind in log-likelihood a pose is refuted; less far, and its angle so different, it is a
// rival. Assumed, 4-9 and 10-20 deg.
constexpr double kRefuted = 6.0, kOtherAngle_rad = Radians(15.0);
constexpr double kGuideGate = 14.0;  // one in 1100 of 2 degrees of freedom

/// Wraps the angles of a residual: rows that are headings or bearings.
void WrapRow(double& value) { value = WrapPi(value); }

}  // namespace

PyramidFilter::PyramidFilter(const Nominal& nominal, const DockyardOptions& options)
    : nominal_(nominal), options_(options), X_NV_(CameraInPlan(nominal)) {
  learned_.mean(kShare) = 1.0;
  learned_.mean(kCentre) = options.centre_m;
  const auto variance = [](double sigma) { return sigma * sigma; };
  learned_.P(kShare, kShare) = variance(options.gauge_sigma);
  learned_.P(kCentre, kCentre) = variance(options.centre_sigma_m);
  learned_.P(kLeftBias, kLeftBias) = variance(options.belt_bias_m_s);
  learned_.P(kRightBias, kRightBias) = variance(options.belt_bias_m_s);
  learned_.P(kScale, kScale) = variance(options.scale_sigma);
}

/// The state after a share of the steps; a negative one goes back.
PyramidFilter::State PyramidFilter::Moved(const State& state, const BeltSteps& steps,
                                          double share) const {
  const double dt_s = steps.driven ? steps.dt_s : 0.0;
  const double left_m = share * (steps.left_m - dt_s * state(kLeftBias));
  const double right_m = share * (steps.right_m - dt_s * state(kRightBias));
  const double way_m = -0.5 * (left_m + right_m);
  const double turn_rad = state(kShare) * (right_m - left_m) / steps.gauge_m;
  const double side_m = state(kCentre) * turn_rad;  // v_y = -x_I w in R, turned half round
  const double middle = state(kHeading) + 0.5 * turn_rad;
  State next = state;
  next(kX) += way_m * std::cos(middle) - side_m * std::sin(middle);
  next(kY) += way_m * std::sin(middle) + side_m * std::cos(middle);
  next(kHeading) = WrapPi(state(kHeading) + turn_rad);
  return next;
}

void PyramidFilter::Drive(const BeltSteps& steps) {
  recent_.push_front(steps);
  if (recent_.size() > kRecent) recent_.pop_back();
  const double way_m = 0.5 * std::abs(steps.left_m + steps.right_m);
  const double turn_rad = std::abs(steps.right_m - steps.left_m) / steps.gauge_m;
  const double kept_share = std::exp(-steps.dt_s / options_.bias_time_s);
  const double fresh = std::pow(options_.belt_bias_m_s, 2) * (1.0 - kept_share * kept_share);
  const auto drift = [&](Kept& kept) {
    for (const int bias : {kLeftBias, kRightBias}) {
      kept.mean(bias) *= kept_share;
      kept.P.row(bias) *= kept_share;
      kept.P.col(bias) *= kept_share;
      kept.P(bias, bias) += fresh;
    }
  };
  drift(learned_);
  for (Kept& kept : kept_) {
    StateMatrix F;
    for (int i = 0; i < kStates; ++i) {
      State up = kept.mean, down = kept.mean;
      const double h = 1e-6;
      up(i) += h;
      down(i) -= h;
      F.col(i) = Moved(up, steps, 1.0) - Moved(down, steps, 1.0);
      F(kHeading, i) = WrapPi(F(kHeading, i));
      F.col(i) /= 2.0 * h;
    }
    kept.mean = Moved(kept.mean, steps, 1.0);
    kept.P = F * kept.P * F.transpose();
    const double heading = kept.mean(kHeading);
    const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
    const Eigen::Vector2d aside(-along.y(), along.x());
    const double along_m2 = std::pow(options_.way_noise, 2) * way_m * kStretch_m +
                            std::pow(options_.arm_noise, 2) * steps.arm_m * kArmPart_m;
    const double aside_m2 =
        std::pow(options_.side_noise, 2) * kStretch_m * (way_m + kTurnSlip_m * turn_rad);
    kept.P.topLeftCorner<2, 2>() +=
        along_m2 * along * along.transpose() + aside_m2 * aside * aside.transpose();
    kept.P(kHeading, kHeading) += std::pow(options_.turn_noise, 2) * turn_rad * kTurnPart_rad +
                                  std::pow(kWayTurn_rad_m, 2) * way_m * kStretch_m;
    drift(kept);
  }
}

/// The camera's pose V in D when the picture was taken.
Pose2 PyramidFilter::CameraIn(const State& state, double age_s) const {
  State then = state;
  for (const BeltSteps& steps : recent_) {
    if (age_s <= 0.0) break;
    const double share = std::min(1.0, age_s / steps.dt_s);
    then = Moved(then, steps, -share);
    age_s -= steps.dt_s;
  }
  return Pose2{then(kX), then(kY), then(kHeading)} * X_NV_;
}

Eigen::Vector3d PyramidFilter::Foretold(const State& state, double age_s) const {
  const Pose2 X_VD = Inverse(CameraIn(state, age_s));
  const double scale = 1.0 + state(kScale);
  return {scale * X_VD.x, scale * X_VD.y, X_VD.heading};
}

template <int Rows, class Model>
double PyramidFilter::Update(Kept& kept, const Eigen::Matrix<double, Rows, 1>& measured,
                             const Eigen::Matrix<double, Rows, Rows>& R, const Model& model,
                             double gate) const {
  Eigen::Matrix<double, Rows, 1> error = measured - model(kept.mean);
  WrapRow(error(Rows - 1));
  Eigen::Matrix<double, Rows, kStates> H;
  for (int i = 0; i < kStates; ++i) {
    State up = kept.mean, down = kept.mean;
    const double h = 1e-6;
    up(i) += h;
    down(i) -= h;
    Eigen::Matrix<double, Rows, 1> slope = model(up) - model(down);
    WrapRow(slope(Rows - 1));
    H.col(i) = slope / (2.0 * h);
  }
  const Eigen::Matrix<double, Rows, Rows> S = H * kept.P * H.transpose() + R;
  const auto solver = S.ldlt();
  const double distance2 = error.dot(solver.solve(error));
  if (!(distance2 <= gate)) return std::numeric_limits<double>::infinity();
  const Eigen::Matrix<double, kStates, Rows> K = solver.solve(H * kept.P).transpose();
  kept.mean += K * error;
  kept.mean(kHeading) = WrapPi(kept.mean(kHeading));
  const StateMatrix rest = StateMatrix::Identity() - K * H;
  kept.P = rest * kept.P * rest.transpose() + K * R * K.transpose();
  kept.score -= 0.5 * (distance2 + std::log(S.determinant()));
  return distance2;
}

/// A pose as a fit has it, with what is known of belts and pictures.
PyramidFilter::Kept PyramidFilter::Born(const PyramidFit& fit, double age_s) const {
  Kept kept = learned_;
  // The motion since the exposure does not depend on where it took place.
  State zero = learned_.mean;
  zero.head<3>().setZero();
  const Pose2 X_NV_then = CameraIn(zero, age_s);
  const auto place = [&](const Pose2& X_VD, double scale) {
    const Pose2 true_VD{X_VD.x / (1.0 + scale), X_VD.y / (1.0 + scale), X_VD.heading};
    return Inverse(X_NV_then * true_VD);
  };
  const double scale = learned_.mean(kScale), h = 1e-6;
  const auto slope = [&](const Pose2& up, const Pose2& down) {
    return Eigen::Vector3d(
        Eigen::Vector3d(up.x - down.x, up.y - down.y, WrapPi(up.heading - down.heading)) /
        (2.0 * h));
  };
  const Pose2 X_DN = place(fit.X_VD, scale);
  kept.mean.head<3>() = Eigen::Vector3d(X_DN.x, X_DN.y, X_DN.heading);
  Eigen::Matrix3d J;
  for (int i = 0; i < 3; ++i) {
    Pose2 up = fit.X_VD, down = fit.X_VD;
    (i == 0 ? up.x : i == 1 ? up.y : up.heading) += h;
    (i == 0 ? down.x : i == 1 ? down.y : down.heading) -= h;
    J.col(i) = slope(place(up, scale), place(down, scale));
  }
  const Eigen::Vector3d by_scale = slope(place(fit.X_VD, scale + h), place(fit.X_VD, scale - h));
  const auto known = learned_.P.bottomRightCorner<kLearned, kLearned>();
  const auto of_scale = known.row(kLearned - 1);
  kept.P.topLeftCorner<3, 3>() = J * fit.covariance * J.transpose() +
                                 learned_.P(kScale, kScale) * by_scale * by_scale.transpose();
  kept.P.topRightCorner<3, kLearned>() = by_scale * of_scale;
  kept.P.bottomLeftCorner<kLearned, 3>() = (by_scale * of_scale).transpose();
  return kept;
}

Pose2 PyramidFilter::PlacedBy(const PyramidFit& fit, double age_s) const {
  const State at = Born(fit, age_s).mean;
  return {at(kX), at(kY), at(kHeading)};
}

void PyramidFilter::Hypothesise(const GuideSighting& guide, double alpha_rad) {
  const Pose2 X_DV{guide.range_m * std::cos(alpha_rad), guide.range_m * std::sin(alpha_rad),
                   WrapPi(alpha_rad + kPi - guide.bearing_rad)};
  PyramidFit fit;
  fit.X_VD = Inverse(X_DV);
  const double aside_m = guide.range_m * guide.bearing_sigma_rad;
  fit.covariance =
      Eigen::Vector3d(guide.range_sigma_m, aside_m, kHypothesis_rad).cwiseAbs2().asDiagonal();
  kept_ = {Born(fit, 0.0)};
}

/// Place and heading are less sure than thought; what is known of belts and pictures stays.
void PyramidFilter::Doubt(Kept* kept) const {
  const double place_m = std::sqrt(std::max(kept->P(kX, kX), kept->P(kY, kY)));
  const double heading_rad = std::sqrt(kept->P(kHeading, kHeading));
  const auto grow = [](double sigma, double most) {
    return std::clamp(most / std::max(sigma, 1e-9), 1.0, kDoubt);
  };
  State growth = State::Ones();
  growth(kX) = growth(kY) = grow(place_m, kMostDoubt_m);
  growth(kHeading) = grow(heading_rad, kMostDoubt_rad);
  kept->P = growth.asDiagonal() * kept->P * growth.asDiagonal();
}

void PyramidFilter::SeeFits(const PyramidSighting& sighting, double age_s) {
  const double best = sighting.fits.front().misfit;
  std::vector<bool> matched(sighting.fits.size(), false);
  const auto model = [&](const State& state) { return Foretold(state, age_s); };
  for (Kept& kept : kept_) {
    std::size_t nearest = 0;
    Kept updated;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sighting.fits.size(); ++i) {
      const PyramidFit& fit = sighting.fits[i];
      Kept trial = kept;
      const double distance2 =
          Update<3>(trial, Eigen::Vector3d(fit.X_VD.x, fit.X_VD.y, fit.X_VD.heading),
                    kAlike * fit.covariance, model, kFitGate);
      trial.score -= kMisfitWeight * std::min(fit.misfit - best, 2.0);
      if (distance2 >= least) continue;
      least = distance2;
      nearest = i;
      updated = trial;
    }
    if (!(least <= kFitGate)) {
      kept.score -= kMissed;
      Doubt(&kept);
      continue;
    }
    matched[nearest] = true;
    kept = updated;
    kept.agrees = true;
  }
  // All poses of the first image are as likely as they fit it.
  const double start = kept_.empty() ? 0.0 : kept_.front().score - kBornBehind;
  for (std::size_t i = 0; i < sighting.fits.size(); ++i) {
    const Eigen::Matrix3d& covariance = sighting.fits[i].covariance;
    if (matched[i] || !covariance.allFinite() || !(covariance.diagonal().minCoeff() > 0.0))
      continue;
    Kept fresh = Born(sighting.fits[i], age_s);
    fresh.score = start - kMisfitWeight * std::min(sighting.fits[i].misfit - best, 2.0);
    fresh.agrees = true;
    kept_.push_back(fresh);
  }
}

void PyramidFilter::SeeGuide(const GuideSighting& guide, double age_s) {
  const auto model = [&](const State& state) {
    const Pose2 X_VD = Inverse(CameraIn(state, age_s));
    return Eigen::Vector2d((1.0 + state(kScale)) * std::hypot(X_VD.x, X_VD.y),
                           std::atan2(X_VD.y, X_VD.x));
  };
  Eigen::Matrix2d R = Eigen::Matrix2d::Zero();
  R(0, 0) = guide.range_sigma_m * guide.range_sigma_m;
  R(1, 1) = guide.bearing_sigma_rad * guide.bearing_sigma_rad;
  for (Kept& kept : kept_) {
    const double distance2 =
        Update<2>(kept, Eigen::Vector2d(guide.range_m, guide.bearing_rad), R, model, kGuideGate);
    if (!(distance2 <= kGuideGate)) kept.score -= kMissed;
  }
}

void PyramidFilter::See(const PyramidSighting& sighting, double age_s) {
  for (Kept& kept : kept_) kept.agrees = false;
  if (!sighting.fits.empty()) {
    SeeFits(sighting, age_s);
  } else if (sighting.guide && !sighting.guide->clipped) {
    SeeGuide(*sighting.guide, age_s);
  }
  Order();
}

void PyramidFilter::Order() {
  if (kept_.empty()) return;
  std::stable_sort(kept_.begin(), kept_.end(),
                   [](const Kept& a, const Kept& b) { return a.score > b.score; });
  // Two that have come together are one.
  std::vector<Kept> rest;
  for (const Kept& kept : kept_) {
    const bool again = std::any_of(rest.begin(), rest.end(), [&](const Kept& other) {
      return (kept.mean.head<2>() - other.mean.head<2>()).norm() < 0.05 &&
             std::abs(WrapPi(kept.mean(kHeading) - other.mean(kHeading))) < Radians(4.0);
    });
    if (!again && kept.score > kept_.front().score - kDropped && rest.size() < kMostKept) {
      rest.push_back(kept);
    }
  }
  kept_ = rest;
  const double top = kept_.front().score;
  for (Kept& kept : kept_) kept.score -= top;
  const Kept& first = kept_.front();
  learned_.mean.tail<kLearned>() = first.mean.tail<kLearned>();
  learned_.P.setZero();
  learned_.P.bottomRightCorner<kLearned, kLearned>() =
      first.P.bottomRightCorner<kLearned, kLearned>();
}

Pose2 PyramidFilter::X_DN() const {
  const State& mean = kept_.front().mean;
  return {mean(kX), mean(kY), mean(kHeading)};
}

bool PyramidFilter::one_angle() const {
  const Kept& first = kept_.front();
  return std::none_of(kept_.begin() + 1, kept_.end(), [&](const Kept& other) {
    return other.score > first.score - kRefuted &&
           std::abs(WrapPi(other.mean(kHeading) - first.mean(kHeading))) > kOtherAngle_rad;
  });
}

bool SureOfAngle(const PyramidFilter& filter, const DockyardOptions& options) {
  return filter.located() && filter.one_angle() &&
         std::sqrt(filter.covariance()(2, 2)) < options.sure_heading_rad;
}

Eigen::Matrix3d PyramidFilter::covariance() const { return kept_.front().P.topLeftCorner<3, 3>(); }

double PyramidFilter::gauge_share() const {
  return (kept_.empty() ? learned_ : kept_.front()).mean(kShare);
}

PyramidPrior PyramidFilter::Prior() const {
  const State& mean = kept_.front().mean;
  const Eigen::Vector3d now = Foretold(mean, 0.0);
  Eigen::Matrix3d J;
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i) {
    State up = mean, down = mean;
    up(i) += h;
    down(i) -= h;
    Eigen::Vector3d slope = Foretold(up, 0.0) - Foretold(down, 0.0);
    slope(2) = WrapPi(slope(2));
    J.col(i) = slope / (2.0 * h);
  }
  return {{now.x(), now.y(), now.z()}, J * covariance() * J.transpose()};
}

double PyramidFilter::alpha_rad() const {
  const Pose2 X_DV = X_DN() * X_NV_;
  return std::atan2(X_DV.y, X_DV.x);
}

double PyramidFilter::range_m() const {
  const Pose2 X_DV = X_DN() * X_NV_;
  return std::hypot(X_DV.x, X_DV.y);
}

double PyramidFilter::bearing_rad() const {
  const Pose2 X_VD = Inverse(X_DN() * X_NV_);
  return std::atan2(X_VD.y, X_VD.x);
}

}  // namespace dockyard::raposa
