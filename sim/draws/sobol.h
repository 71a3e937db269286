// The points of Sobol' in any order, as workers draw the runs of a campaign.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dockyard {

/// The sequence has that many dimensions in Boost's table.
inline constexpr std::size_t kSobolDimensions = 3667;

/// The sequence with the direction numbers of Joe and Kuo (SIAM J. Sci. Comput. 30, 2008,
/// 2635-2654; their file new-joe-kuo-6), in the order of Gray's code (Antonov and Saleev 1979).
/// Point 0 is the origin: without it the first 2^k points were no net (Owen, arXiv:2008.08051).
class SobolPoints {
 public:
  /// For points 0 .. points - 1. At most kSobolDimensions; 0 is allowed.
  SobolPoints(std::size_t dimensions, std::uint64_t points);

  /// A coordinate as a binary fraction of 64 digits, to be divided by 2^64.
  std::uint64_t Digits(std::size_t dimension, std::uint64_t point) const;

 private:
  std::size_t dimensions_;
  int bits_;  // of the last point's number
  // By dimension: what each bit of a point's Gray code changes.
  std::vector<std::uint64_t> directions_;
};

}  // namespace dockyard
