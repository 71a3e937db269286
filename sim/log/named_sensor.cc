#include "sim/log/named_sensor.h"

namespace dockyard {

Json ToJson(const std::vector<NamedSensor>& sensors) {
  Json list = Json::array();
  for (const NamedSensor& each : sensors) {
    list.push_back({{"name", each.name},
                    {"unit", each.unit},
                    {"meaning", each.meaning},
                    {"period_ms", each.period},
                    {"latency_ms", each.latency},
                    {"noise", each.noise}});
  }
  return list;
}

std::vector<NamedSensor> SensorsFromJson(const Json& json) {
  std::vector<NamedSensor> sensors;
  for (const Json& each : json) {
    sensors.push_back({each.at("name"), each.at("unit"), each.at("meaning"), each.at("period_ms"),
                       each.at("latency_ms"), each.at("noise")});
  }
  return sensors;
}

std::vector<Column> ColumnsOf(const std::vector<NamedSensor>& sensors) {
  std::vector<Column> columns;
  for (const NamedSensor& each : sensors) columns.push_back({each.name, each.unit, each.meaning});
  return columns;
}

}  // namespace dockyard
