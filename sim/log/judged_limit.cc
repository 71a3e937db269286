#include "sim/log/judged_limit.h"

#include <algorithm>
#include <cmath>

#include "sim/base/text.h"

namespace dockyard {
namespace {

constexpr const char* kMargin = "margin.";

const char* WordOf(LimitSense sense) {
  return sense == LimitSense::kAtLeast ? "at least" : "at most";
}

/// "seat depth" of "seat_depth_m".
std::string SpokenName(const JudgedLimit& limit) {
  std::string name = limit.name.substr(0, limit.name.rfind('_'));
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// A tenth of the unit; lengths below 1 m in millimetres.
std::string ValueText(double value, const std::string& unit, bool small) {
  std::string text = Fixed(small ? 1e3 * value : value, 1);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text + " " + (small ? "mm" : unit);
}

}  // namespace

bool IsMargin(const Column& measure) { return measure.name.starts_with(kMargin); }

std::vector<Column> WithMargins(std::vector<Column> measures,
                                const std::vector<JudgedLimit>& limits) {
  for (const JudgedLimit& each : limits) {
    measures.push_back({kMargin + each.name, each.unit,
                        "margin to the limit, positive is good: " + each.meaning + ", " +
                            WordOf(each.sense) + " the limit; `nan` where it is not judged"});
  }
  return measures;
}

std::string LimitText(const JudgedLimit& limit) {
  const bool small = limit.unit == "m" && std::abs(limit.limit) < 1.0;
  return SpokenName(limit) + " " + ValueText(limit.value, limit.unit, small) + " (" +
         WordOf(limit.sense) + " " + ValueText(limit.limit, limit.unit, small) + ")";
}

std::string BrokenLimitsText(const std::vector<JudgedLimit>& limits) {
  std::string text;
  for (const JudgedLimit& each : limits) {
    if (each.margin() < 0.0) text += (text.empty() ? "" : ", ") + LimitText(each);
  }
  return text;
}

const JudgedLimit* TightestLimit(const std::vector<JudgedLimit>& limits) {
  const JudgedLimit* tightest = nullptr;
  const auto share = [](const JudgedLimit& each) { return each.margin() / std::abs(each.limit); };
  for (const JudgedLimit& each : limits) {
    if (std::isnan(each.value)) continue;
    if (tightest == nullptr || share(each) < share(*tightest)) tightest = &each;
  }
  return tightest;
}

Json LimitsJson(const std::vector<JudgedLimit>& limits) {
  Json json = Json::array();
  for (const JudgedLimit& each : limits) {
    if (std::isnan(each.value)) continue;
    json.push_back({{"name", each.name},
                    {"unit", each.unit},
                    {"value", each.value},
                    {"limit", each.limit},
                    {"sense", WordOf(each.sense)},
                    {"margin", each.margin()}});
  }
  return json;
}

}  // namespace dockyard
