// Sensors of one number by name: a system states each once, and logs, tables and programs have it.
#pragma once

#include <string>
#include <vector>

#include "controller/io/sensors.h"
#include "sim/base/json.h"
#include "sim/log/column.h"

namespace dockyard {

/// A sensor other than inertial unit, motors and cameras. The plant gives its value of now; the run
/// samples it, adds the noise, and hands it over after the latency (sim/run/sensor_link.h).
struct NamedSensor {
  std::string name;     // with its unit: "depth_m"
  std::string unit;     // empty for a switch or a count
  std::string meaning;  // one line
  Tick period = 20;
  Tick latency = 0;
  double noise = 0.0;  // 1 sigma of a normal error of each sample, in the unit
};

/// A list of {name, unit, meaning, period_ms, latency_ms, noise}.
Json ToJson(const std::vector<NamedSensor>& sensors);
/// Throws nlohmann::json::exception.
std::vector<NamedSensor> SensorsFromJson(const Json& json);
std::vector<Column> ColumnsOf(const std::vector<NamedSensor>& sensors);

}  // namespace dockyard
