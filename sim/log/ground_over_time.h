// The ground of a logged run as it was at any time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/log/logged_run.h"

namespace dockyard {

/// Goes through a run's heights from its first sample on. The run must outlive it.
class GroundOverTime {
 public:
  explicit GroundOverTime(const LoggedRun& run);

  /// Takes in all changes up to then. Times must not fall.
  void AdvanceTo(double time_s);
  /// The grid, whose own heights are those of the beginning; null: the log has no ground.
  const LoggedGround* grid() const { return grid_; }
  /// In the grid's steps, row by row.
  const std::vector<std::int16_t>& heights() const { return heights_; }
  /// Changes with the heights.
  std::size_t revision() const { return next_; }

 private:
  const std::vector<Timed<LoggedGround>>& changes_;
  const LoggedGround* grid_ = nullptr;
  std::vector<std::int16_t> heights_;
  std::size_t next_ = 1;
};

}  // namespace dockyard
