#include "sim/report/rate_text.h"

#include <cmath>
#include <cstdio>

#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

long Percent(double share) { return std::lround(100.0 * share); }

}  // namespace

std::string RateText(int successes, int trials) {
  const std::string count = std::to_string(successes) + "/" + std::to_string(trials);
  if (trials == 0) return count;
  const Interval interval = ClopperPearson(successes, trials);
  return count + " (" + std::to_string(Percent(static_cast<double>(successes) / trials)) + " %, " +
         std::to_string(Percent(interval.low)) + "-" + std::to_string(Percent(interval.high)) +
         " %)";
}

std::string ShortRate(int successes, int trials) {
  if (trials == 0) return "0/0";
  const Interval interval = ClopperPearson(successes, trials);
  return std::to_string(Percent(static_cast<double>(successes) / trials)) + " % (" +
         std::to_string(Percent(interval.low)) + "-" + std::to_string(Percent(interval.high)) + ")";
}

std::string ChanceText(double p) {
  if (std::isnan(p)) return "nan";
  if (p < 0.0001) return "< 0.0001";
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", p);
  return text;
}

std::string PText(double p) {
  const std::string text = ChanceText(p);
  return "p " + (text.starts_with("<") ? text : "= " + text);
}

std::string BriefNumber(double value) {
  if (std::isnan(value)) return "nan";  // one spelling, whatever its sign bit
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace dockyard
