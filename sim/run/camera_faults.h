// A scenario's faults of cameras: in the transport of their images, and in the images.
#pragma once

#include <utility>
#include <vector>

#include "controller/io/sensors.h"
#include "render/stereo_renderer.h"
#include "sim/base/random.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// How often a camera can give an image, and how long one takes to arrive.
struct CameraTimes {
  Tick period = 0, latency = 0;
};

/// Which cameras expose when. A camera that is asked within its period exposes at the period's end.
class CameraClock {
 public:
  explicit CameraClock(std::vector<CameraTimes> times)
      : times_(std::move(times)), next_(times_.size(), 0), asked_(times_.size(), false) {}

  /// Those that expose now, of those asked for now or before. Ticks must rise.
  std::vector<int> Due(const std::vector<int>& asked, Tick now);

 private:
  std::vector<CameraTimes> times_;
  std::vector<Tick> next_;   // the earliest next exposure
  std::vector<bool> asked_;  // and not yet answered
};

/// Carries the images from the cameras to the controller. Without times it holds one answer at a
/// time: cameras that are asked again begin anew, and images under transport are dropped.
class ImageLink {
 public:
  ImageLink(const CameraFaults& faults, const Seed& run_seed, std::vector<CameraTimes> times = {});

  /// Images exposed now, which get their stamp here by the cameras' clock. False: they are lost.
  /// One draw for each call.
  bool Send(std::vector<CameraImage> images, Tick now);
  /// What has arrived by now, once; empty: nothing.
  std::vector<CameraImage> Receive(Tick now);

 private:
  struct OnTheWay {
    CameraImage image;
    Tick due = 0;
  };
  /// The tick of this moment by the cameras' clock.
  Tick StampOf(Tick now) const;

  Tick delay_ = 0;
  double lost_ = 0.0;
  double clock_offset_s_ = 0.0, clock_drift_ppm_ = 0.0;
  RandomStream random_;
  std::vector<CameraTimes> times_;
  std::vector<OnTheWay> on_the_way_;
};

/// The sensor of a run's stereo pair with what spoils its pictures. Dust lies at places drawn from
/// the run's seed and stays there.
SensorOptions WithFaults(SensorOptions sensor, const CameraFaults& faults, const Seed& run_seed);

}  // namespace dockyard
