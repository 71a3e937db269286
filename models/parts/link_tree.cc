#include "models/parts/link_tree.h"

#include <Eigen/Geometry>

namespace dockyard {

void ScaleMass(double scale, LinkTree& tree) {
  const auto times = [&](LinkModel& link) {
    link.mass_kg *= scale;
    link.I_LCom_L *= scale;
  };
  times(tree.root);
  for (JointedLink& each : tree.joints.links) times(each.link);
}

std::vector<Pose3> StartPoses(const LinkTree& tree) {
  std::vector<double> start;  // by link
  start.push_back(0.0);
  for (const JointedLink& each : tree.joints.links) start.push_back(each.start_rad);
  for (const JointRatio& ratio : tree.joints.ratios) {
    start[static_cast<std::size_t>(ratio.link)] =
        ratio.ratio * start[static_cast<std::size_t>(ratio.other)] + ratio.offset_rad;
  }
  std::vector<Pose3> X_RL{Pose3{}};
  for (std::size_t i = 0; i < tree.joints.links.size(); ++i) {
    const JointedLink& each = tree.joints.links[i];
    Pose3 moved;
    if (each.slides) {
      moved.p = start[i + 1] * each.axis_L;
    } else {
      moved.R = Eigen::AngleAxisd(start[i + 1], each.axis_L).toRotationMatrix();
    }
    X_RL.push_back(X_RL[static_cast<std::size_t>(each.carrier)] * each.X_PL * moved);
  }
  return X_RL;
}

}  // namespace dockyard
