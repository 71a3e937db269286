// The roughness of broken and weathered rock: waves whose heights go with their lengths.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/base/random.h"

namespace dockyard {

class RockRoughness {
 public:
  /// @param rms_m  root mean square, of wavelengths of 12 to 100 mm
  RockRoughness(double rms_m, RandomStream& random);

  /// Over the smooth surface [m].
  double At(const Eigen::Vector3d& p) const;

 private:
  struct Wave {
    Eigen::Vector3d k_per_m{0, 0, 0};
    double phase = 0.0, height_m = 0.0;
  };
  std::vector<Wave> waves_;
};

}  // namespace dockyard
