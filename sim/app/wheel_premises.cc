#include "sim/app/wheel_premises.h"

#include <cmath>
#include <cstdio>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// The measured rows that the laws were compared with (docs/results/soil.md) end here: 39.6 mm of
// 62.5 mm, slip 0.76 (VIPER's wheel 0.8), side slip 45 deg.
constexpr double kDeepestCompared = 0.64;  // sinkage over the radius of the tips
constexpr double kMostSlip = 0.8;
constexpr double kMostSideSlip_deg = 45.0;
constexpr double kRoundOff = 1e-9;  // of degrees that were radians

template <typename... Numbers>
std::string Sentence(const char* format, Numbers... numbers) {
  char text[240];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

}  // namespace

bool IsBuried(const WheelModel& wheel, const SingleWheelResult& result) {
  return result.sinkage_m >= RollingRadius(wheel);
}

std::vector<std::string> BrokenPremises(const SingleWheelSetup& setup,
                                        const SingleWheelResult& result) {
  std::vector<std::string> broken;
  if (!result.steady) {
    broken.push_back(
        "the wheel was still changing at the end of its path of 60 radii; the row is no result");
  }
  const double radius_m = RollingRadius(setup.wheel);
  const double deep = result.sinkage_m / radius_m, side_deg = Degrees(setup.side_slip_rad);
  if (IsBuried(setup.wheel, result)) {
    broken.push_back(Sentence(
        "the wheel is buried: its axle is %.3g m below the ground, its lowest point %.3g m; "
        "no premise of the soil's laws holds, and the row is no result",
        result.sinkage_m - radius_m, result.sinkage_m));
  } else if (deep > kDeepestCompared) {
    broken.push_back(Sentence(
        "the wheel sinks by %.2f of its radius; the laws were compared with measured wheels "
        "up to %.2f",
        deep, kDeepestCompared));
  }
  if (std::fabs(setup.slip) > kMostSlip) {
    broken.push_back(Sentence("slip %g: the laws were compared with measured wheels up to %g",
                              setup.slip, kMostSlip));
  }
  if (side_deg > kMostSideSlip_deg + kRoundOff) {
    broken.push_back(Sentence(
        "side slip of %g deg: the laws were compared with measured wheels up to %g deg, and are "
        "wrong by half and more at 75 deg",
        side_deg, kMostSideSlip_deg));
  }
  return broken;
}

}  // namespace dockyard
