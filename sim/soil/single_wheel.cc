#include "sim/soil/single_wheel.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/soil/wheel_soil.h"

namespace dockyard {
namespace {

// Change of the means from window to window below which the wheel counts as steady, of the load
// and of the radius, and how often in a row. Paddles make them jitter by 0.3 %.
constexpr double kSteady = 0.004;
constexpr int kSteadyWindows = 3;
constexpr double kLongest_radii = 60.0;
// Cells of the rig's ground per radius; a yard's ground has 13 for a wheel of 0.3 m.
constexpr double kCellsPerRadius = 12.0;
// Inertia of the towed wheel about its axle: of a third of the load, as a disc.
constexpr double kWheelMassShare = 0.3;

/// Sums of one window of the way.
struct Window {
  double ahead = 0.0, side = 0.0, up = 0.0, torque = 0.0, sinkage = 0.0, spin = 0.0;
  double ahead2 = 0.0, sinkage2 = 0.0;
  long steps = 0;

  SingleWheelResult Means(double radius_m, double travel_speed_m_s) const {
    const double one = 1.0 / static_cast<double>(steps);
    SingleWheelResult mean;
    mean.ahead_n = ahead * one;
    mean.side_n = side * one;
    mean.up_n = up * one;
    mean.torque_nm = torque * one;
    mean.sinkage_m = sinkage * one;
    const double rim = spin * one * radius_m;
    mean.slip = (rim - travel_speed_m_s) / std::max(std::fabs(rim), std::fabs(travel_speed_m_s));
    mean.ahead_rms_n = std::sqrt(std::max(0.0, ahead2 * one - mean.ahead_n * mean.ahead_n));
    mean.height_rms_m = std::sqrt(std::max(0.0, sinkage2 * one - mean.sinkage_m * mean.sinkage_m));
    return mean;
  }
};

class Rig {
 public:
  explicit Rig(const SingleWheelSetup& setup) : setup_(setup), contact_(setup.wheel, setup.soil) {
    const double radius = setup.wheel.rim_radius_m;
    travel_speed_ = setup.slip < 1.0 ? setup.speed_m_s : 0.0;
    rim_speed_ = setup.slip >= 1.0  ? setup.speed_m_s
                 : setup.slip > 0.0 ? setup.speed_m_s / (1.0 - setup.slip)
                                    : setup.speed_m_s * (1.0 + setup.slip);
    if (setup.free_spin) rim_speed_ = setup.speed_m_s;
    spin_ = rim_speed_ / radius;
    drive_G_ = travel_speed_ *
               Eigen::Vector3d(std::cos(setup.side_slip_rad), -std::sin(setup.side_slip_rad), 0.0);
    reach_ = radius + PaddleReach(setup.wheel);
    const double longest = kLongest_radii * radius, margin = 8.0 * reach_;
    grid_ = LevelGrid(-0.5 * margin, longest * std::fabs(std::cos(setup.side_slip_rad)) + margin,
                      2.0 * longest * std::fabs(std::sin(setup.side_slip_rad)) + margin,
                      radius / kCellsPerRadius);
    mass_kg_ = setup.load_n / kEarthGravity_m_s2;
    motion_.X_GK.p = Eigen::Vector3d(0.0, 0.0, reach_);
  }

  SingleWheelResult Run() {
    const double radius = setup_.wheel.rim_radius_m;
    SingleWheelResult before, now;
    int steady = 0;
    double way = 0.0;
    while (way < kLongest_radii * radius) {
      const Window window = RunWindow(way);
      now = window.Means(radius, travel_speed_);
      const double change = std::hypot(now.ahead_n - before.ahead_n, now.side_n - before.side_n,
                                       (now.torque_nm - before.torque_nm) / radius) /
                            setup_.load_n;
      const double sunk = std::fabs(now.sinkage_m - before.sinkage_m) / radius;
      steady = change < kSteady && sunk < kSteady ? steady + 1 : 0;
      before = now;
      if (steady == kSteadyWindows) break;
    }
    now.travel_m = drive_G_.norm() * static_cast<double>(steps_) * setup_.step_s;
    now.steps = steps_;
    now.steady = steady == kSteadyWindows;
    return now;
  }

 private:
  /// One radius of way, rounded up to whole paddle pitches.
  Window RunWindow(double& way) {
    const double radius = setup_.wheel.rim_radius_m;
    Window window;
    double here = 0.0, turned = 0.0;
    const double pitch =
        setup_.wheel.paddle_count > 0 ? 2.0 * kPi / setup_.wheel.paddle_count : 0.0;
    const auto Done = [&] {
      if (here < radius) return false;
      if (pitch == 0.0 || turned < pitch) return true;  // it hardly turns in a radius of way
      const double pitches = turned / pitch;
      return pitches - std::floor(pitches) < 1.01 * std::fabs(spin_) * setup_.step_s / pitch;
    };
    while (!Done()) {
      Step(window);
      here += std::max(travel_speed_, std::fabs(spin_) * radius) * setup_.step_s;
      turned += std::fabs(spin_) * setup_.step_s;
    }
    way += here;
    return window;
  }

  void Step(Window& window) {
    const double dt = setup_.step_s;
    motion_.X_GK.R = RotY(angle_);
    motion_.v_GK_G = drive_G_ + Eigen::Vector3d(0.0, 0.0, sink_speed_);
    motion_.w_GK_G = Eigen::Vector3d(0.0, spin_, 0.0);
    const WheelLoad load = contact_.Step(grid_, motion_, dt);
    sink_speed_ += (load.force_G.z() - setup_.load_n) / mass_kg_ * dt;
    if (setup_.free_spin) {
      const double radius = setup_.wheel.rim_radius_m;
      const double inertia = 0.5 * kWheelMassShare * mass_kg_ * radius * radius;
      spin_ += load.torque_G.y() / inertia * dt;
    }
    motion_.X_GK.p += (drive_G_ + Eigen::Vector3d(0.0, 0.0, sink_speed_)) * dt;
    angle_ += spin_ * dt;
    ++steps_;
    const double sinkage = reach_ - motion_.X_GK.p.z();
    window.ahead += load.force_G.x();
    window.side += load.force_G.y();
    window.up += load.force_G.z();
    window.torque -= load.torque_G.y();
    window.sinkage += sinkage;
    window.spin += spin_;
    window.ahead2 += load.force_G.x() * load.force_G.x();
    window.sinkage2 += sinkage * sinkage;
    ++window.steps;
  }

  SingleWheelSetup setup_;
  WheelSoil contact_;
  HeightGrid grid_;
  WheelMotion motion_;
  Eigen::Vector3d drive_G_ = Eigen::Vector3d::Zero();
  double travel_speed_ = 0.0, rim_speed_ = 0.0, reach_ = 0.0, mass_kg_ = 0.0;
  double spin_ = 0.0, angle_ = 0.0, sink_speed_ = 0.0;
  long steps_ = 0;
};

}  // namespace

SingleWheelResult RunSingleWheel(const SingleWheelSetup& setup) {
  DOCKYARD_CHECK(setup.load_n > 0.0 && setup.speed_m_s > 0.0 && setup.step_s > 0.0);
  DOCKYARD_CHECK(setup.slip >= -1.0 && setup.slip <= 1.0);
  DOCKYARD_CHECK(std::fabs(setup.side_slip_rad) <= 0.5 * kPi + 1e-9);
  return Rig(setup).Run();
}

}  // namespace dockyard
