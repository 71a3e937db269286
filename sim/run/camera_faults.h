// A scenario's faults of cameras: on the way of their pictures, and in them.
#pragma once

#include <optional>
#include <vector>

#include "controller/io/sensors.h"
#include "render/stereo_renderer.h"
#include "sim/base/random.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// The way of the pictures from the cameras to the controller. It holds one answer at a time:
/// cameras that are asked again begin anew, and what was on its way is dropped.
class ImageLink {
 public:
  ImageLink(const CameraFaults& faults, const Seed& run_seed);

  /// Pictures exposed now, as they are told from here on. False: they are lost. One draw for each
  /// call.
  bool Send(std::vector<CameraImage> images, Tick now);
  /// What has arrived by now, once; empty: nothing.
  std::vector<CameraImage> Receive(Tick now);

 private:
  struct OnTheWay {
    std::vector<CameraImage> images;
    Tick due = 0;
  };
  Tick delay_ = 0;
  double lost_ = 0.0;
  RandomStream random_;
  std::optional<OnTheWay> on_the_way_;
};

/// The sensor of a run's stereo pair with what spoils its pictures. Dust lies at places drawn from
/// the run's seed and stays there.
SensorOptions WithFaults(SensorOptions sensor, const CameraFaults& faults, const Seed& run_seed);

}  // namespace dockyard
