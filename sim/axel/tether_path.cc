#include "sim/axel/tether_path.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::axel {
namespace {

struct Node {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  int bend = -1;
};

}  // namespace

double TetherPath::total_m() const {
  double total = 0.0;
  for (int i = 0; i < pieces; ++i) total += length_m[i];
  return total;
}

TetherPath FindTetherPath(const ConeModel& cone, double anchor_depth_m,
                          const Eigen::Vector2d& tip) {
  // From the anchor outwards the string can only turn away from the axis, about an edge that stands
  // in its way: a convex chain, built as in Andrew's scan (1979).
  std::array<Node, kBendCount + 2> chain;
  int count = 0;
  const auto Append = [&](const Eigen::Vector2d& at, int bend) {
    while (count >= 2 &&
           Cross(chain[count - 1].at - chain[count - 2].at, at - chain[count - 1].at) <= 0.0) {
      --count;
    }
    chain[count++] = {at, bend};
  };
  const bool outside_face = tip.x() < 0.0 && tip.y() > cone.mouth_radius_m;
  Append({-anchor_depth_m, 0.0}, -1);
  if (outside_face || tip.x() > -cone.funnel_length_m) {
    Append({-cone.funnel_length_m, cone.throat_radius_m}, static_cast<int>(Bend::kThroat));
  }
  if (outside_face || tip.x() > 0.0) {
    Append({0.0, cone.mouth_radius_m}, static_cast<int>(Bend::kLip));
  }
  Append(tip, -1);

  TetherPath path;
  path.pieces = count - 1;
  for (int i = 0; i < count; ++i) {
    const Node& node = chain[count - 1 - i];
    path.nodes[i] = node.at;
    if (node.bend >= 0) path.bent[node.bend] = true;
  }
  for (int i = 0; i < path.pieces; ++i) {
    path.length_m[i] = (path.nodes[i + 1] - path.nodes[i]).norm();
  }
  for (int i = 0; i + 1 < path.pieces; ++i) {
    const Eigen::Vector2d a = path.nodes[i + 1] - path.nodes[i];
    const Eigen::Vector2d b = path.nodes[i + 2] - path.nodes[i + 1];
    path.turn_rad[i] = std::abs(std::atan2(Cross(a, b), a.dot(b)));
  }
  return path;
}

}  // namespace dockyard::axel
