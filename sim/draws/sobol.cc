#include "sim/draws/sobol.h"

#include <bit>

#include <boost/random/sobol.hpp>

#include "controller/base/check.h"

namespace dockyard {

// Boost's engine gives all dimensions of one point after the other, so it only serves to read its
// direction numbers: the point whose Gray code has one bit is that bit's. The Gray code of n is
// n ^ (n >> 1), so the point 2^(b + 1) - 1 has bit b alone; seed(s) makes the next point s + 1.
SobolPoints::SobolPoints(std::size_t dimensions, std::uint64_t points)
    : dimensions_(dimensions),
      bits_(points > 1 ? static_cast<int>(std::bit_width(points - 1)) : 0),
      directions_(dimensions * static_cast<std::size_t>(bits_)) {
  DOCKYARD_CHECK(dimensions <= kSobolDimensions && bits_ < 64);
  if (directions_.empty()) return;
  boost::random::sobol engine(dimensions);
  for (int bit = 0; bit < bits_; ++bit) {
    engine.seed((std::uint64_t{2} << bit) - 2);
    for (std::size_t k = 0; k < dimensions; ++k) directions_[k * bits_ + bit] = engine();
  }
}

std::uint64_t SobolPoints::Digits(std::size_t dimension, std::uint64_t point) const {
  DOCKYARD_CHECK(dimension < dimensions_ && point >> bits_ == 0);
  const std::uint64_t* direction = directions_.data() + dimension * bits_;
  std::uint64_t digits = 0;
  for (std::uint64_t gray = point ^ (point >> 1); gray != 0; gray >>= 1, ++direction) {
    if (gray & 1) digits ^= *direction;
  }
  return digits;
}

}  // namespace dockyard
