#include <Eigen/Geometry>
#include <algorithm>

#include "controller/geometry/pose.h"
#include "sim/vehicles/loose_stones.h"

namespace dockyard {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

// The normal and two directions across it.
Eigen::Matrix3d AxesAlong(const Vector3d& normal) {
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vector3d a = normal.cross(Vector3d::Unit(least)).normalized();
  Eigen::Matrix3d axes;
  axes << normal, a, normal.cross(a);
  return axes;
}

}  // namespace

// Over the speeds of the tool, if any touch is with a part, then six of each stone.
void LooseStones::Solve(TreeBody& tool, const std::vector<int>& stones,
                        std::vector<StoneTouch*> touches, double step_s) {
  if (touches.size() > kManyContacts) {  // the deepest bear
    std::stable_sort(touches.begin(), touches.end(),
                     [](const auto* a, const auto* b) { return a->law.gap_m < b->law.gap_m; });
    touches.resize(kManyContacts);
  }
  const bool with_tool = std::any_of(touches.begin(), touches.end(),
                                     [](const StoneTouch* touch) { return touch->part >= 0; });
  const Eigen::Index tool_speeds = with_tool ? tool.speeds().size() : 0;
  const auto rows = static_cast<Eigen::Index>(3 * touches.size());
  MatrixXd J = MatrixXd::Zero(tool_speeds + 6 * static_cast<Eigen::Index>(stones.size()), rows);
  const auto ColumnOf = [&](int stone) {
    return tool_speeds + 6 * (std::find(stones.begin(), stones.end(), stone) - stones.begin());
  };
  step_.count = static_cast<int>(touches.size());
  step_.impulse.resize(rows);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const StoneTouch& touch = *touches[i];
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const Eigen::Matrix3d axes = AxesAlong(touch.normal_G);
    const auto AddStone = [&](int stone, double sign) {
      const Vector3d arm = touch.p_G - stones_[Place(stone)].body.motion().X_GL.p;
      J.block<3, 3>(ColumnOf(stone), row) = sign * axes;
      J.block<3, 3>(ColumnOf(stone) + 3, row) = sign * (CrossMatrix(arm) * axes);
    };
    AddStone(touch.stone, 1.0);
    if (touch.other_stone >= 0) AddStone(touch.other_stone, -1.0);
    if (touch.part >= 0) {
      J.block(0, row, tool_speeds, 3) =
          -tool.JacobianOf(parts_[Place(touch.part)].link, touch.p_G).transpose() * axes;
    }
    const Eigen::Matrix3d& R_GS = stones_[Place(touch.stone)].body.motion().X_GL.R;
    step_.laws[i] = touch.law;
    step_.laws[i].bend_m = axes.rightCols<2>().transpose() * (R_GS * touch.bend_S);
    step_.impulse.segment<3>(row) = axes.transpose() * (R_GS * touch.impulse_S);
  }
  MatrixXd answers(J.rows(), rows);
  Eigen::VectorXd speeds(J.rows());
  if (with_tool) {
    answers.topRows(tool_speeds) = tool.Answers(J.topRows(tool_speeds));
    speeds.head(tool_speeds) = tool.speeds();
  }
  for (const int stone : stones) {
    const LooseStone& body = stones_[Place(stone)].body;
    const Eigen::Index at = ColumnOf(stone);
    answers.middleRows<3>(at) = J.middleRows<3>(at) / body.mass_kg();
    answers.middleRows<3>(at + 3) = body.InverseInertia() * J.middleRows<3>(at + 3);
    speeds.segment<3>(at) = body.motion().v_GL_G;
    speeds.segment<3>(at + 3) = body.motion().w_GL_G;
  }
  step_.answer.noalias() = J.transpose() * answers;
  step_.velocity = J.transpose() * speeds;

  sweeps_ = std::max(sweeps_, SolveContacts(step_s, step_));

  if (with_tool) tool.AddSpeeds(answers.topRows(tool_speeds) * step_.impulse);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    StoneTouch& touch = *touches[i];
    const Eigen::Matrix3d axes = AxesAlong(touch.normal_G);
    LooseStone& body = stones_[Place(touch.stone)].body;
    const Eigen::Matrix3d R_SG = body.motion().X_GL.R.transpose();
    touch.impulse_G = axes * step_.impulse.segment<3>(3 * static_cast<Eigen::Index>(i));
    touch.impulse_S = R_SG * touch.impulse_G;
    touch.bend_S = R_SG * (axes.rightCols<2>() * step_.laws[i].bend_m);
    body.AddImpulse(touch.impulse_G, touch.p_G);
    if (touch.other_stone >= 0) {
      stones_[Place(touch.other_stone)].body.AddImpulse(-touch.impulse_G, touch.p_G);
    }
  }
}

// Stones that touch nothing but soil are solved each by itself, all others together.
void LooseStones::SolveAll(TreeBody& tool, double step_s) {
  sweeps_ = 0;
  std::vector<bool> together(stones_.size(), false);
  for (const StoneTouch& touch : touches_) {
    if (touch.part >= 0 || touch.other_stone >= 0) together[Place(touch.stone)] = true;
    if (touch.other_stone >= 0) together[Place(touch.other_stone)] = true;
  }
  std::vector<int> joined;
  std::vector<StoneTouch*> of_joined;
  for (int i = 0; i < count(); ++i) {
    if (together[Place(i)]) joined.push_back(i);
  }
  for (StoneTouch& touch : touches_) {
    if (together[Place(touch.stone)]) of_joined.push_back(&touch);
  }
  if (!of_joined.empty()) Solve(tool, joined, std::move(of_joined), step_s);
  for (int i = 0; i < count(); ++i) {
    if (together[Place(i)] || stones_[Place(i)].asleep) continue;
    std::vector<StoneTouch*> own;
    for (StoneTouch& touch : touches_) {
      if (touch.stone == i) own.push_back(&touch);
    }
    if (!own.empty()) Solve(tool, {i}, std::move(own), step_s);
  }
}

}  // namespace dockyard
