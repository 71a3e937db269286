#include "models/read/urdf_inertia.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "controller/base/number_text.h"
#include "controller/geometry/decompositions.h"
#include "models/read/urdf_numbers.h"

namespace dockyard {
namespace {

constexpr double kExact = 1e-6, kAlways = 0.01, kAtMost = 0.3;  // shares of the largest moment

std::string Short(double value, int digits = 6) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

double NumberOf(const TiXmlElement& element, const char* name) {
  const auto numbers = NumbersOf(element.Attribute(name));
  return numbers && numbers->size() == 1 ? numbers->front() : 0.0;
}

/// How far rounding may have moved the sum of two principal moments against the third: a moment on
/// the diagonal counts once, a product of inertia is twice in the matrix.
double RoundingOfAll(const TiXmlElement& inertia) {
  double sum = 0.0;
  for (const auto& [name, times] :
       {std::pair("ixx", 1.0), std::pair("iyy", 1.0), std::pair("izz", 1.0), std::pair("ixy", 2.0),
        std::pair("ixz", 2.0), std::pair("iyz", 2.0)}) {
    for (const std::string_view word : WordsOf(inertia.Attribute(name))) {
      sum += times * RoundingOf(std::string(word));
    }
  }
  return sum;
}

}  // namespace

double RoundingOf(const std::string& number) {
  double value = 0.0;
  if (!ParseNumber(number, value) || value == 0.0) return 0.0;
  const std::size_t exponent = number.find_first_of("eE"), point = number.find('.');
  if (exponent == std::string::npos && point == std::string::npos) return 0.0;
  const std::size_t end = std::min(exponent, number.size());
  const auto decimals = point == std::string::npos ? 0 : static_cast<int>(end - point) - 1;
  const int power = exponent == std::string::npos ? 0 : std::atoi(number.c_str() + exponent + 1);
  return 0.5 * std::pow(10.0, power - decimals);
}

InertiaCheck CheckInertia(const TiXmlElement& inertia) {
  const double ixx = NumberOf(inertia, "ixx"), iyy = NumberOf(inertia, "iyy"),
               izz = NumberOf(inertia, "izz"), ixy = NumberOf(inertia, "ixy"),
               ixz = NumberOf(inertia, "ixz"), iyz = NumberOf(inertia, "iyz");
  Eigen::Matrix3d I;
  I << ixx, ixy, ixz, ixy, iyy, iyz, ixz, iyz, izz;
  if (!I.allFinite() || I.cwiseAbs().maxCoeff() > 1e6) {
    return {"inertia: expected finite numbers up to 1e6 kg m^2", ""};
  }
  const Eigen::Vector3d moments = EigenOfSymmetric(I).values;
  const double largest = moments.cwiseAbs().maxCoeff();
  const double excess = std::max(moments[2] - moments[0] - moments[1], -moments[0]);
  const double allowed =
      std::max(kAlways * largest, std::min(RoundingOfAll(inertia), kAtMost * largest));
  const std::string found =
      Short(moments[0]) + ", " + Short(moments[1]) + " and " + Short(moments[2]) + " kg m^2";
  const std::string beyond = moments[0] < -kExact * largest
                                 ? Short(moments[0]) + " is negative"
                                 : "the largest exceeds the sum of the others by " + Short(excess) +
                                       ", " + Short(100.0 * excess / largest, 2) + " % of it";
  if (excess > allowed) {
    return {
        "inertia: expected principal moments >= 0 of which none exceeds the sum of the others, "
        "found " +
            found + ": " + beyond,
        ""};
  }
  if (excess > kExact * largest) {
    return {"", "inertia: the principal moments are " + found + ": " + beyond +
                    ", taken for rounding of the printed digits"};
  }
  if (moments[0] > kExact * largest) return {};
  return {"", "inertia: a principal moment of 0 (" + found +
                  "), as of a point or a thin rod: the link may only move fixed to another"};
}

}  // namespace dockyard
