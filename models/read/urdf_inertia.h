// Moments of inertia as programs print them: rounded, so that they may seem impossible by a little.
#pragma once

#include <tinyxml.h>

#include <string>

namespace dockyard {

struct InertiaCheck {
  std::string fault;    // why no body has such moments; empty when one may
  std::string warning;  // what is odd about them; empty when nothing is
};

/// No body has a negative principal moment, or one beyond the sum of the others. An excess that
/// rounding explains is accepted with a warning: half a unit of each number's last printed digit,
/// at most 30 % of the largest moment, and always 1 % of it. A moment of 0 (a thin rod, a point)
/// has a warning too, because such a link cannot move by itself.
/// @param inertia  an <inertia> element whose attributes are numbers
InertiaCheck CheckInertia(const TiXmlElement& inertia);

/// Half a unit of the last digit: 0.00005 for "0.0417", 5e-7 for "1.2e-5". 0 for whole numbers and
/// zeros, which nobody has rounded.
double RoundingOf(const std::string& number);

}  // namespace dockyard
