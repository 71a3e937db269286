// Sensors by name between the plant, which has their values of now, and the controller.
#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "sim/base/random.h"
#include "sim/log/named_sensor.h"

namespace dockyard {

/// Samples each sensor at its period, with its noise, and delivers after its latency. Between two
/// deliveries a sensor keeps its value. The robot was switched on before the run: the first frame
/// has a value of each.
class SensorLink {
 public:
  SensorLink(const std::vector<NamedSensor>& sensors, const Seed& run_seed);

  /// @param now  the plant's values, by sensor. Ticks must rise.
  std::vector<double> Pass(const std::vector<double>& now, Tick tick);

 private:
  struct Line {
    NamedSensor sensor;
    RandomStream random;
    std::deque<std::pair<Tick, double>> pending{};  // when each arrives
    Tick next_sample = 0;
    double last = 0.0;
  };
  std::vector<Line> lines_;
  bool started_ = false;
};

}  // namespace dockyard
