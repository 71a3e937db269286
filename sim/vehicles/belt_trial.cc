#include "sim/vehicles/belt_trial.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr double kStep_s = 1e-3;
constexpr double kGravity_m_s2 = 9.81;
constexpr double kSettleLengths = 3.0, kMeanLengths = 2.0;  // of the belt's lower run
constexpr double kRest_s = 1.0;                             // before it sets off

struct Sums {
  double drawbar = 0.0, side = 0.0, carried = 0.0, torque = 0.0, sinkage = 0.0, contact = 0.0;
};

/// Holds the belt level and upright, and lets it find its height under the load.
class Rig {
 public:
  Rig(const BeltModel& model, Belt belt, const BeltTrial& trial)
      : belt_(std::move(belt)), radius_m_(model.front.radius_m), load_n_(trial.load_n) {
    const double run_m = model.front.x_m - model.rear.x_m;
    const double reach_m = 2.0 * (kSettleLengths + kMeanLengths) * run_m + 2.0;
    ground_ = LevelGrid(-reach_m, 2.0 * reach_m, 2.0 * reach_m, 0.1);
    carrier_.X_GL.p.z() = radius_m_;
  }

  /// @param v_G  of the carrier, level
  BeltLoad Step(const Eigen::Vector2d& v_G, double belt_m_s) {
    carrier_.v_GL_G = {v_G.x(), v_G.y(), rise_m_s_};
    const BeltLoad load = belt_.Step(ground_, carrier_, belt_m_s, kStep_s);
    rise_m_s_ += kStep_s * kGravity_m_s2 * (load.force_G.z() / load_n_ - 1.0);
    carrier_.X_GL.p += kStep_s * Eigen::Vector3d(v_G.x(), v_G.y(), rise_m_s_);
    return load;
  }
  double sinkage_m() const { return radius_m_ - carrier_.X_GL.p.z(); }

 private:
  Belt belt_;
  double radius_m_, load_n_, rise_m_s_ = 0.0;
  HeightGrid ground_;
  LinkMotion carrier_;
};

}  // namespace

BeltTrialResult RunBelt(const BeltModel& model, Belt belt, const BeltTrial& trial) {
  // The faster of belt and travel has the trial's speed.
  const double behind = 1.0 - std::abs(trial.slip);
  const double belt_m_s = trial.speed_m_s * (trial.slip >= 0.0 ? 1.0 : behind);
  const double travel_m_s = trial.speed_m_s * (trial.slip >= 0.0 ? behind : 1.0);
  const Eigen::Vector2d v_G =
      travel_m_s * Eigen::Vector2d(std::cos(trial.side_slip_rad), -std::sin(trial.side_slip_rad));
  Rig rig(model, std::move(belt), trial);
  for (long i = std::lround(kRest_s / kStep_s); i > 0; --i) rig.Step(Eigen::Vector2d::Zero(), 0.0);
  const double run_m = model.front.x_m - model.rear.x_m;
  const auto steps = [&](double path_m) {
    return std::lround(path_m / (trial.speed_m_s * kStep_s));
  };
  for (long i = steps(kSettleLengths * run_m); i > 0; --i) rig.Step(v_G, belt_m_s);
  // Whole pads: the belt's lengths round its rollers, in parts.
  const double pitch_m = 2.0 * (run_m + kPi * model.front.radius_m) / model.pads;
  const long count = steps(std::max(1.0, std::round(kMeanLengths * run_m / pitch_m)) * pitch_m);
  Sums sums;
  for (long i = 0; i < count; ++i) {
    const BeltLoad load = rig.Step(v_G, belt_m_s);
    sums.drawbar += load.force_G.x();
    sums.side += load.force_G.y();
    sums.carried += load.force_G.z();
    sums.torque += load.drive_torque_nm;
    sums.sinkage += rig.sinkage_m();
    sums.contact += std::max(0.0, load.front_m - load.rear_m);
  }
  const double share = 1.0 / static_cast<double>(count);
  return {share * sums.drawbar, share * sums.side,    share * sums.carried,
          share * sums.torque,  share * sums.sinkage, share * sums.contact};
}

}  // namespace dockyard
