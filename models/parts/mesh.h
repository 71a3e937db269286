// A triangle mesh as loaded from a file, and where it sits on a link.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;                // [m], in the mesh's own frame
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
};

struct Visual {
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
  Pose3 X_LV;                          // mesh frame in the link frame
  Eigen::Vector3d rgb{0.5, 0.5, 0.5};  // linear albedo, 0..1
};

}  // namespace dockyard
