// Pictures under way: when a pair is asked for, and where the rover was when it was exposed.
#pragma once

#include <optional>

#include "controller/axel/options.h"
#include "controller/axel/senses.h"
#include "controller/imaging/image_request.h"
#include "controller/imaging/past_motion.h"
#include "controller/vision/board/locate.h"

namespace dockyard::axel {

/// When the frame's first image was exposed; none without an image.
std::optional<Tick> ExposedAt(const SensorFrame& sensed);

/// The frame's pair; the picture of a camera that gave none is dark. None without any picture.
std::optional<StereoImages> PairOf(const SensorFrame& sensed);

/// The frame's pair, if it answers the request.
std::optional<StereoImages> AnswerTo(const ImageRequest& request, const SensorFrame& sensed);

/// Way in the image of a board at range_m while the shutter is open, at most [px]: by the gyros and
/// the speed ahead.
double ExpectedBlur_px(const Nominal& nominal, const ImuSample& imu, double speed_m_s,
                       double range_m);

/// The rover now against the rover when a picture was exposed.
struct SinceExposure {
  Pose3 X_NR;         // body then in the body now
  Attitude attitude;  // of the body then against the ground
  double way_m = 0.0;
};

/// Hints for pictures that were exposed then.
LocateHints HintsThen(const Senses& senses, const SinceExposure& since);
/// The sighting as it would be now: the way since, which only dead reckoning knows, widens its
/// covariance.
void CarryToNow(const SinceExposure& since, const FilterNoise& noise, LocateOutput* seen);

class MovingLooks {
 public:
  MovingLooks(const AxelOptions& options, const Nominal& nominal)
      : options_(options), nominal_(nominal), past_(options.moving.oldest) {}

  /// A phase begins: what was asked for is not awaited any more.
  void Begin(Tick now);
  /// Every control period of a drive.
  void Remember(const Senses& senses);
  /// Whether to ask for a pair now. due: near the leg's end; sees: the board should be in view,
  /// range_m from the rover.
  bool Asks(const Senses& senses, bool due, bool sees, double range_m);
  /// Of pictures that have come: how far the rover has moved since. None: no pictures, or none
  /// that were asked for here, or so old that it is forgotten where.
  std::optional<SinceExposure> Answered(const SensorFrame& sensed, const Senses& senses);
  void Accepted(Tick exposed) { accepted_ = exposed; }
  /// Whether a sighting from under way is so new that the rover need not stop for one.
  bool Fresh(Tick now) const { return accepted_ && now - *accepted_ <= options_.moving.fresh; }

 private:
  AxelOptions options_;
  Nominal nominal_;
  PastMotion past_;  // by odometry alone
  ImageRequest request_;
  Tick last_ask_ = 0;  // answered or not
  std::optional<Tick> accepted_;
};

}  // namespace dockyard::axel
