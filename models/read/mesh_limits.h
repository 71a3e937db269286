// How large a mesh may be that is read from a file.
#pragma once

#include <cstddef>

namespace dockyard {

inline constexpr std::size_t kMaxMeshBytes = 32u << 20;
inline constexpr std::size_t kMaxMeshTriangles = 500000;
inline constexpr double kMaxMeshCoordinate_m = 1000.0;

}  // namespace dockyard
