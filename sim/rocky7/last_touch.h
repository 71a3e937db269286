// The instrument's touch that a placement is judged by.
#pragma once

#include <Eigen/Core>

namespace dockyard::rocky7 {

/// The last touch of those that were felt: the instrument measures in it, those before are tries.
/// The face when this touch pressed most.
struct LastTouch {
  double force_n = 0.0;
  Eigen::Vector3d p_GF{0, 0, 0}, axis_G{1, 0, 0};
  double last_s = -1e9;  // the last time that it pressed
};

/// What presses on the face at a time, in order of time. After half a second without force
/// (assumed, 0.3-1 s: a can that springs back is not a new try) another touch begins.
inline void Add(double time_s, double force_n, const Eigen::Vector3d& p_GF,
                const Eigen::Vector3d& axis_G, LastTouch& touch) {
  constexpr double kApart_s = 0.5;
  if (force_n <= 0.0) return;
  if (time_s - touch.last_s > kApart_s) touch = {};
  touch.last_s = time_s;
  if (force_n > touch.force_n) touch = {force_n, p_GF, axis_G, time_s};
}

}  // namespace dockyard::rocky7
