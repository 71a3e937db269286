#include "controller/axel/moving_looks.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/sighting.h"

namespace dockyard::axel {
namespace {

double Square(double x) { return x * x; }

/// In place of the picture of a camera that gave none beside the other's.
GrayImage Dark(const GrayImage& other) {
  GrayImage dark{.width = other.width, .height = other.height, .pixels = {}};
  dark.pixels.resize(other.pixels.size());
  return dark;
}

}  // namespace

std::optional<Tick> ExposedAt(const SensorFrame& sensed) {
  if (sensed.images.empty()) return std::nullopt;
  return sensed.images.front().exposed;
}

std::optional<StereoImages> PairOf(const SensorFrame& sensed) {
  const GrayImage* left = GrayImageOf(sensed, kLeftCamera);
  const GrayImage* right = GrayImageOf(sensed, kRightCamera);
  if (!left && !right) return std::nullopt;
  return StereoImages{left ? *left : Dark(*right), right ? *right : Dark(*left)};
}

std::optional<StereoImages> AnswerTo(const ImageRequest& request, const SensorFrame& sensed) {
  return IsAnswered(request, sensed) ? PairOf(sensed) : std::nullopt;
}

double ExpectedBlur_px(const Nominal& nominal, const ImuSample& imu, double speed_m_s,
                       double range_m) {
  const double focal_px = nominal.rig.left.focal_px().maxCoeff();
  const double rate = imu.rate_R.norm() + std::abs(speed_m_s) / std::max(range_m, 0.3);
  return focal_px * nominal.shutter_s * rate;
}

LocateHints HintsThen(const Senses& senses, const SinceExposure& since) {
  LocateHints hints;
  hints.up_R = UpOfStation(since.attitude, !senses.ground().level());
  hints.X_RB_expected = senses.ExpectedBoard();
  if (hints.X_RB_expected) hints.X_RB_expected = Inverse(since.X_NR) * *hints.X_RB_expected;
  return hints;
}

void CarryToNow(const SinceExposure& since, const FilterNoise& noise, LocateOutput* seen) {
  if (!seen->sighting) return;
  DockSighting& sighting = *seen->sighting;
  sighting.X_RB = since.X_NR * sighting.X_RB;
  seen->report.X_RB = sighting.X_RB;
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = since.X_NR.R;
  sighting.covariance = turn * sighting.covariance * turn.transpose();
  // A pipeline without a covariance keeps none: the filter has its own.
  if (sighting.covariance.trace() > 0.0) {
    const double heading = Square(noise.heading_rad_per_sqrt_m) * since.way_m;
    const double place = Square(noise.along_m_per_sqrt_m) * since.way_m;
    const double range_m = sighting.X_RB.p.head<2>().norm();
    sighting.covariance.diagonal().head<2>().array() += place + heading * Square(range_m);
    sighting.covariance(5, 5) += heading;
  }
  seen->report.covariance = sighting.covariance;
}

void MovingLooks::Begin(Tick now) {
  past_.Clear();
  request_ = {};
  if (!Fresh(now)) last_ask_ = now;
}

void MovingLooks::Remember(const Senses& senses) {
  past_.Add({senses.now(), senses.reckoned(), senses.imu()});
}

bool MovingLooks::Asks(const Senses& senses, bool due, bool sees, double range_m) {
  const MovingOptions& moving = options_.moving;
  const Tick now = senses.now(), since = now - last_ask_;
  if (since < moving.soonest || (!due && since < moving.period)) return false;
  if (due && Fresh(now)) return false;
  const ImagePatience patience{.wait = moving.oldest, .most_asks = moving.unanswered + 1};
  if (StateOf(request_, patience, now) != RequestState::kDue) return false;
  if (!senses.filter().located() || !sees) return false;
  if (std::abs(senses.pitch_rad()) > options_.arm.look_pitch_rad) return false;
  if (ExpectedBlur_px(nominal_, senses.imu(), options_.drive.approach_m_s, range_m) >
      moving.blur_px)
    return false;
  request_ = {.asked = now, .asks = request_.asks + 1};
  last_ask_ = now;
  return true;
}

std::optional<SinceExposure> MovingLooks::Answered(const SensorFrame& sensed,
                                                   const Senses& senses) {
  if (!IsAnswered(request_, sensed)) return std::nullopt;
  request_ = {};
  const Tick exposed = *ExposedAt(sensed);
  if (!past_.Holds(exposed)) return std::nullopt;
  const PastMoment& then = past_.Nearest(exposed);
  const Pose2 X_NT = Inverse(senses.reckoned()) * then.X_OR;  // then, in the heading now
  const double heading_rad = senses.pose().heading + X_NT.heading;
  SinceExposure since;
  since.attitude = senses.ground().Against(then.imu, heading_rad);
  const Pose3 X_now{Tilt(senses.attitude()), Eigen::Vector3d::Zero()};
  const Pose3 X_then{Tilt(since.attitude), Eigen::Vector3d::Zero()};
  since.X_NR = Inverse(X_now) * FromGround(X_NT, 0.0) * X_then;
  since.way_m = std::hypot(X_NT.x, X_NT.y);
  return since;
}

}  // namespace dockyard::axel
