// Lenses with focal lengths and a principal point, under our own keys.
#pragma once

#include <string>
#include <vector>

#include "controller/geometry/lens.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// Focal lengths and principal point [px].
struct FocalNumbers {
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;
};

template <typename L>
L WithFocal(L lens, const FocalNumbers& focal) {
  lens.fx = focal.fx;
  lens.fy = focal.fy;
  lens.cx = focal.cx;
  lens.cy = focal.cy;
  return lens;
}

/// xi of the double sphere, and the angle of the field-of-view lens.
inline constexpr Range kXiOfSpheres{-1.0, 1.0, true};
inline constexpr Range kWidthOfFov_rad = Positive(3.14);

/// The values of `model`: kannala_brandt, brown, ...
std::vector<std::string> FocalModelNames();
bool IsFocalModel(const std::string& model);
/// The keys of the lens of that model; IsFocalModel must hold.
std::vector<std::string> FocalModelKeys(const std::string& model);
/// Throws ConfigError; IsFocalModel must hold.
Lens ReadFocalLens(const YamlReader& in, const std::string& model);

}  // namespace dockyard
