// The forces of a cable's segments and of what it touches, at the speeds tried, and how they change
// with them. Segment j ends at mass j; `span` is that segment.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/cable/cable_parts.h"

namespace dockyard {

/// Of a bent segment, at the start of a step.
void FindSolidEdges(const CableStep& step, const std::vector<CableNode>& nodes, int j,
                    CableSpan& span);
/// Spring and damper of a segment in one, at the start of a step. damping_n_s: force per rate of
/// strain.
void Stiffen(const CableStep& step, const CableModel& model, double damping_n_s,
             const std::vector<CableNode>& nodes, int j, CableSpan& span);
void PullStraight(const CableStep& step, const std::vector<CableNode>& nodes,
                  const std::vector<Eigen::Vector3d>& speed, int j, CableSpan& span);
void PullRound(const CableStep& step, const std::vector<CableNode>& nodes,
               const std::vector<Eigen::Vector3d>& speed, int j, CableSpan& span);
/// v_G: of the mass that touches.
void Press(double step_s, const Eigen::Vector3d& v_G, CableTouch& touch);

}  // namespace dockyard
