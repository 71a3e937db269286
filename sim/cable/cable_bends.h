// Where a cable touches ground and solids at the start of a step.
#pragma once

#include <vector>

#include "sim/cable/cable_parts.h"

namespace dockyard {

/// Bodies that the cable may meet in this step.
void FindNearBodies(const CableStep& step, const CableModel& model,
                    const std::vector<CableNode>& nodes, std::vector<int>& near);
/// Masses on ground or bodies. deepest_m: they are kept apart by at most this push.
void FindTouches(const CableStep& step, const CableModel& model,
                 const std::vector<CableNode>& nodes, const std::vector<int>& near,
                 double deepest_m, std::vector<CableTouch>& touches);
/// Segments over bodies: the nodes' bends, and spans for them.
void FindBends(const CableStep& step, const CableModel& model, const std::vector<int>& near,
               std::vector<CableNode>& nodes, std::vector<CableSpan>& spans);

}  // namespace dockyard
