#include "sim/spectator/belief_words.h"

#include <cmath>
#include <optional>

#include "controller/base/number_text.h"

namespace dockyard {
namespace {

constexpr double kSameTime_s = 1e-6;

/// NaN where there is none.
double ValueAt(const Series& series, const std::string& name, std::size_t sample) {
  const auto found = series.find(name);
  return found == series.end() ? std::nan("") : found->second[sample];
}

std::string At(double time_s) { return ", at " + Fixed(time_s, 1) + " s"; }

/// x ahead, y to the left.
std::string TargetWords(const Eigen::Vector2d& p_R) {
  const double bearing_deg = Degrees(std::atan2(p_R.y(), p_R.x()));
  return "target at " + Fixed(p_R.norm(), 2) + " m, " + Fixed(std::abs(bearing_deg), 1) + " deg " +
         (bearing_deg < 0.0 ? "right" : "left");
}

/// With the time from which on it has been so, where that is not the sample's.
std::optional<std::string> StatedTarget(const LoggedRun& run, std::size_t sample) {
  for (const Series* series : {&run.belief, &run.values}) {
    const auto at = [&](std::size_t i) {
      return Eigen::Vector2d(ValueAt(*series, "target_x_m", i), ValueAt(*series, "target_y_m", i));
    };
    const Eigen::Vector2d p_R = at(sample);
    if (!p_R.allFinite() || p_R.isZero()) continue;
    std::size_t since = sample;
    while (since > 0 && at(since - 1) == p_R) --since;
    return TargetWords(p_R) + (since < sample ? At(run.times_s[since]) : "");
  }
  return std::nullopt;
}

const SightingSample* LastAccepted(const LoggedRun& run, double time_s) {
  const SightingSample* last = nullptr;
  for (const SightingSample& sighting : run.sightings) {
    if (sighting.report.accepted && sighting.time_s <= time_s + kSameTime_s) last = &sighting;
  }
  return last;
}

}  // namespace

std::string PoseWords(const Series& series, std::size_t sample) {
  const auto value = [&](const char* name) {
    return series.contains(name) ? ValueAt(series, name, sample) : 0.0;
  };
  return "x " + Fixed(value("x_m"), 2) + " m, y " + Fixed(value("y_m"), 2) + " m, heading " +
         Fixed(Degrees(value("heading_rad")), 1) + " deg";
}

std::string BelievedWords(const LoggedRun& run, std::size_t sample) {
  const auto located = run.belief.find("located");
  if (located == run.belief.end()) return {};
  if (located->second[sample] != 0.0) return PoseWords(run.belief, sample);
  if (const auto words = StatedTarget(run, sample)) return *words;
  if (const SightingSample* sighting = LastAccepted(run, run.times_s[sample])) {
    return TargetWords(sighting->report.X_RB.p.head<2>()) + At(sighting->time_s);
  }
  return "not located";
}

}  // namespace dockyard
