// Trees of links drawn by chance, on which tests compare engines.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"
#include "sim/rigid/tree_body.h"

namespace dockyard {

inline Eigen::Vector3d AnyVector(RandomStream& random, double most) {
  return {random.Uniform(-most, most), random.Uniform(-most, most), random.Uniform(-most, most)};
}

/// Inertia of a box that is turned in the link.
inline LinkModel AnyLink(RandomStream& random) {
  LinkModel link;
  link.mass_kg = random.Uniform(0.3, 5.0);
  link.p_LoCom_L = AnyVector(random, 0.2);
  const Eigen::Vector3d size(random.Uniform(0.1, 0.5), random.Uniform(0.1, 0.5),
                             random.Uniform(0.1, 0.5));
  const Eigen::Vector3d moments = link.mass_kg / 12.0 *
                                  Eigen::Vector3d(size.y() * size.y() + size.z() * size.z(),
                                                  size.z() * size.z() + size.x() * size.x(),
                                                  size.x() * size.x() + size.y() * size.y());
  const Eigen::Matrix3d R = ToRotation({random.Uniform(-1, 1), 0.3, random.Uniform(-1, 1)});
  link.I_LCom_L = R * moments.asDiagonal() * R.transpose();
  return link;
}

/// All joints are hinges.
inline std::vector<TreeLink> AnyTree(RandomStream& random, int count) {
  std::vector<TreeLink> links{{AnyLink(random)}};
  for (int i = 1; i < count; ++i) {
    links.push_back({AnyLink(random), static_cast<int>(random.Uniform(0.0, i - 0.01)),
                     AnyVector(random, 0.4), AnyVector(random, 1.0).normalized(), 0.0});
  }
  return links;
}

/// Hinges, slides and fixed joints in turn, `first` with the first link, in any directions.
inline std::vector<TreeLink> AnyTreeOfAllJoints(RandomStream& random, int count, int first) {
  std::vector<TreeLink> links = AnyTree(random, count);
  for (int i = 1; i < count; ++i) {
    TreeLink& link = links[static_cast<std::size_t>(i)];
    link.joint = static_cast<JointKind>((i + first) % 3);
    link.R_PL = ToRotation({random.Uniform(-1, 1), 0.4, random.Uniform(-1, 1)});
  }
  return links;
}

}  // namespace dockyard
