// Bodies for tests of RigidWorld.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "models/parts/gravity.h"
#include "sim/rigid/rigid_world.h"

namespace dockyard {

/// A test at a step length [s].
class AtStep : public testing::TestWithParam<double> {
 protected:
  double step_s() const { return GetParam(); }
  long StepsIn(double seconds) const { return std::lround(seconds / step_s()); }
};

inline const Eigen::Vector3d kDown(0.0, 0.0, -kEarthGravity_m_s2);

inline LinkModel BoxModel(double mass_kg, const Eigen::Vector3d& size_m,
                          const Eigen::Vector3d& com_m = {0, 0, 0}) {
  const Eigen::Vector3d squares = size_m.cwiseAbs2();
  LinkModel model;
  model.mass_kg = mass_kg;
  model.p_LoCom_L = com_m;
  model.I_LCom_L.diagonal() = mass_kg / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  return model;
}

inline LinkModel TurningModel(double mass_kg, double along, double across,
                              const Eigen::Vector3d& com_m = {0, 0, 0}) {
  LinkModel model;
  model.mass_kg = mass_kg;
  model.p_LoCom_L = com_m;
  model.I_LCom_L = Eigen::Vector3d(across, across, along).asDiagonal();  // about z: along
  return model;
}

inline TreeLink JointedLink(int parent, const LinkModel& model, const Eigen::Vector3d& p_PL,
                            const Eigen::Vector3d& axis_L, JointKind joint = JointKind::kHinge) {
  TreeLink link;
  link.model = model;
  link.parent = parent;
  link.p_PL = p_PL;
  link.axis_L = axis_L;
  link.joint = joint;
  return link;
}

inline TreeLink BaseLink(const LinkModel& model) {
  return JointedLink(-1, model, {0, 0, 0}, Eigen::Vector3d::UnitY());
}

/// For trees on a base that never moves.
inline constexpr TreeRules kMounted{TreeBase::kFixed, VelocityTerms::kMidstep};
inline TreeLink Mount() { return BaseLink(BoxModel(1.0, {1.0, 1.0, 1.0})); }

inline TreeBody FreeBody(const LinkModel& model, const Pose3& X_GB) {
  return TreeBody({BaseLink(model)}, {}, X_GB);
}

inline void SetSpeeds(TreeBody& body, const std::vector<double>& speeds) {
  TreeBody::Speeds change = -body.speeds();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    change[static_cast<Eigen::Index>(i)] += speeds[i];
  }
  body.AddSpeeds(change);
}

/// When a value passes zero upwards: between two steps by the line between both.
class UpwardPasses {
 public:
  void Take(double time_s, double value) {
    if (last_ < 0.0 && value >= 0.0) {
      passes_s_.push_back(time_s - (time_s - last_s_) * value / (value - last_));
    }
    last_ = value;
    last_s_ = time_s;
  }
  std::size_t count() const { return passes_s_.size(); }
  /// From the first to the last pass; of two at least.
  double Period() const {
    return (passes_s_.back() - passes_s_.front()) / static_cast<double>(passes_s_.size() - 1);
  }

 private:
  double last_ = 0.0, last_s_ = 0.0;
  std::vector<double> passes_s_;
};

/// Runge and Kutta's fourth order, in steps of 0.1 ms.
template <class State, class Rate>
State Integrated(State state, double seconds, const Rate& rate) {
  constexpr double kStep_s = 1e-4;
  const long steps = std::lround(seconds / kStep_s);
  for (long i = 0; i < steps; ++i) {
    const State a = rate(state), b = rate(State(state + 0.5 * kStep_s * a)),
                c = rate(State(state + 0.5 * kStep_s * b)), d = rate(State(state + kStep_s * c));
    state += kStep_s / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  return state;
}

}  // namespace dockyard
