// The normal distribution as a function and its inverse: a normal number costs one uniform number.
#pragma once

namespace dockyard {

/// P(Z <= z) of a standard normal Z; z may be infinite. The relative error is a few 1e-16 in the
/// middle and grows with z^2 to 1e-13 at z = -37. Further down the result loses digits.
double NormalShare(double z);

/// The z with P(Z <= z) = p, for 0 < p < 1. Algorithm AS 241, routine PPND16 (Wichura, Applied
/// Statistics 37, 1988, 477-484), relative error below 1e-15. Near 1 a double has few digits of
/// 1 - p: take -NormalQuantile(1 - p) where 1 - p is known better.
double NormalQuantile(double p);

}  // namespace dockyard
