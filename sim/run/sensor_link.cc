#include "sim/run/sensor_link.h"

#include "controller/base/check.h"

namespace dockyard {

SensorLink::SensorLink(const std::vector<NamedSensor>& sensors, const Seed& run_seed) {
  for (const NamedSensor& sensor : sensors) {
    DOCKYARD_CHECK(!sensor.name.empty() && sensor.period > 0 && sensor.latency >= 0 &&
                   sensor.noise >= 0.0);
    lines_.push_back(
        {.sensor = sensor, .random = RandomStream(StreamKey(run_seed, "sensor." + sensor.name))});
  }
}

std::vector<double> SensorLink::Pass(const std::vector<double>& now, Tick tick) {
  DOCKYARD_CHECK(now.size() == lines_.size());
  std::vector<double> values;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Line& line = lines_[i];
    const NamedSensor& sensor = line.sensor;
    if (!started_ || tick >= line.next_sample) {
      const double error = sensor.noise > 0.0 ? sensor.noise * line.random.Normal() : 0.0;
      line.pending.emplace_back(started_ ? tick + sensor.latency : tick, now[i] + error);
      line.next_sample = tick - tick % sensor.period + sensor.period;
    }
    while (!line.pending.empty() && line.pending.front().first <= tick) {
      line.last = line.pending.front().second;
      line.pending.pop_front();
    }
    values.push_back(line.last);
  }
  started_ = true;
  return values;
}

}  // namespace dockyard
