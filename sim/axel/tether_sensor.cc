#include "sim/axel/tether_sensor.h"

#include <cmath>

#include "controller/axel/nominal/motors.h"

namespace dockyard::axel {
namespace {

// Length of the feeler that the tether turns, as of a fairlead with two resolvers. Assumed, range
// 0.05-0.2 m.
constexpr double kFeeler_m = 0.1;

/// The point so far along the line from its first one, or its last.
Eigen::Vector3d Along(const std::vector<Eigen::Vector3d>& line, double length_m) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double piece_m = (line[i] - line[i - 1]).norm();
    if (piece_m >= length_m && piece_m > 0.0) {
      return line[i - 1] + length_m / piece_m * (line[i] - line[i - 1]);
    }
    length_m -= piece_m;
  }
  return line.back();
}

}  // namespace

std::vector<NamedSensor> SensorsOf(const TetherSensor& sensor) {
  return {{"tether_tension_n", "N", "of the tether at the drum", kControlPeriod, 0,
           sensor.tension_noise_n},
          {"tether_azimuth_rad", "rad", "of the tether from the arm's tip, from x of the body left",
           kControlPeriod, 0, sensor.direction_noise_rad},
          {"tether_elevation_rad", "rad", "the same, above the body's plane of x and y",
           kControlPeriod, 0, sensor.direction_noise_rad}};
}

std::vector<double> TetherTruth(const Truth& truth) {
  const std::vector<Eigen::Vector3d>& line = truth.tether_W;
  const Eigen::Vector3d d_R = truth.X_WR.R.transpose() * (Along(line, kFeeler_m) - line.front());
  std::vector<double> values(3);
  values[kTetherTension] = truth.tether_tension_n;
  values[kTetherAzimuth] = std::atan2(d_R.y(), d_R.x());
  values[kTetherElevation] = std::atan2(d_R.z(), std::hypot(d_R.x(), d_R.y()));
  return values;
}

TetherSensing::TetherSensing(const TetherSensorModel& model, const Seed& run_seed) {
  RandomStream random(StreamKey(run_seed, "tether sensor"));
  tension_offset_n_ = model.tension_offset_n * random.Normal();
  tension_scale_ = 1.0 + model.tension_scale_share * random.Normal();
  azimuth_offset_rad_ = model.direction_offset_rad * random.Normal();
  elevation_offset_rad_ = model.direction_offset_rad * random.Normal();
}

std::vector<double> TetherSensing::Read(const Truth& truth) const {
  std::vector<double> values = TetherTruth(truth);
  values[kTetherTension] = tension_scale_ * values[kTetherTension] + tension_offset_n_;
  values[kTetherAzimuth] += azimuth_offset_rad_;
  values[kTetherElevation] += elevation_offset_rad_;
  return values;
}

}  // namespace dockyard::axel
